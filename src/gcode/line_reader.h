// Text from a source to pieces of whole lines, in bounded memory: the line that a chunk ends in is
// carried over to the next.
//
//     LineReader reader(source, "part.gcode", {});
//     for (auto text = reader.next(0); !text.empty(); text = reader.next(lines_seen)) …
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gcode/text_source.h"

namespace bead {

struct LineLimits {
    std::size_t chunk = std::size_t{1} << 18;    // bytes read at a time
    std::size_t longest = std::size_t{1} << 20;  // bytes of a line
};

class LineReader {
  public:
    // The source must outlive the reader.
    LineReader(const TextSource& source, std::string name, const LineLimits& limits);

    // Some whole lines, each with its LF, also the last one; valid until the next call, and
    // followed by `padding` bytes that may be read. Empty at the end. A comment that makes a line
    // too long is cut short. Throws Error, with the input's name, for what cannot be G-code text:
    // NUL bytes, a line that is too long all the same. `before`: the lines handed out so far, for
    // the complaint.
    std::string_view next(std::int64_t before);
    [[nodiscard]] std::int64_t bytes() const { return bytes_; }

    static constexpr std::size_t padding = 16;

  private:
    std::size_t fill(std::int64_t before);
    void refuse_binary(std::string_view fresh, std::int64_t before);
    void shorten_first_line(std::int64_t before);
    [[noreturn]] void fail(std::int64_t line, std::string_view complaint) const;

    const TextSource& source_;
    std::string name_;
    LineLimits limits_;
    std::vector<char> buffer_;
    std::string start_;
    std::size_t begin_ = 0, held_ = 0;  // bytes handed out, bytes held
    std::int64_t bytes_ = 0;
};

}  // namespace bead
