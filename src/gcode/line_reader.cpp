#include "gcode/line_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "core/error.h"

namespace bead {
namespace {

using namespace std::string_view_literals;

struct Magic {
    std::string_view bytes, complaint;
};
constexpr std::array magics{
    Magic{"GCDE"sv,
          "this is not G-code text; binary G-code (.bgcode) must be exported as text: switch off "
          "binary G-code in the slicer"},
    Magic{"PK\3\4"sv, "this is an archive, not G-code text; unpack it first"},
    Magic{"\x1f\x8b"sv, "this is gzipped, not G-code text; unpack it or name it as a file"},
};

class LineReader {
  public:
    LineReader(const TextSource& source, const std::string& name, const LineLimits& limits)
        : source_(source), name_(name), limits_(limits), buffer_(limits.chunk) {}

    template <class OnLine>
    std::int64_t run(const OnLine& on_line) {
        while (const std::size_t fresh = fill()) {
            std::size_t begin = 0;
            std::size_t search = held_ - fresh;  // what was carried over holds no line end
            while (const char* const stop = line_end(search)) {
                const std::size_t end = std::size_t(stop - buffer_.data());
                deliver(begin, end, on_line);
                begin = search = end + 1;
            }
            carry_over(begin);
        }
        if (held_ > 0) deliver(0, held_, on_line);
        return bytes_;
    }

  private:
    [[noreturn]] void fail(std::int64_t line, std::string_view complaint) const {
        throw Error(name_ + ":" + std::to_string(line) + ": " + std::string(complaint));
    }

    std::size_t fill() {
        buffer_.resize(std::max(buffer_.size(), held_ + limits_.chunk));
        const std::span<char> place(buffer_.data() + held_, limits_.chunk);
        const std::size_t fresh = source_(place);
        refuse_binary({place.data(), fresh});
        held_ += fresh;
        bytes_ += std::int64_t(fresh);
        return fresh;
    }

    void refuse_binary(std::string_view fresh) {
        if (start_.size() < 4) start_ += fresh.substr(0, 4 - start_.size());
        for (const Magic& magic : magics)
            if (start_.starts_with(magic.bytes)) fail(1, magic.complaint);
        if (fresh.empty()) return;
        const void* const nul = std::memchr(fresh.data(), '\0', fresh.size());
        if (nul == nullptr) return;
        const auto before = std::count(fresh.data(), static_cast<const char*>(nul), '\n');
        fail(lines_ + 1 + before,
             "there is a NUL byte, so this is not G-code text; export it as plain (ASCII or UTF-8) "
             "text");
    }

    const char* line_end(std::size_t from) const {
        if (from == held_) return nullptr;
        return static_cast<const char*>(std::memchr(buffer_.data() + from, '\n', held_ - from));
    }

    template <class OnLine>
    void deliver(std::size_t begin, std::size_t end, const OnLine& on_line) {
        ++lines_;
        if (end - begin > limits_.longest) refuse_length();
        if (end > begin && buffer_[end - 1] == '\r') --end;
        on_line(std::string_view(buffer_.data() + begin, end - begin));
    }

    void carry_over(std::size_t begin) {
        held_ -= begin;
        if (begin > 0) std::memmove(buffer_.data(), buffer_.data() + begin, held_);
        if (held_ <= limits_.longest) return;
        ++lines_;
        refuse_length();
    }

    [[noreturn]] void refuse_length() const {
        fail(lines_, "the line is longer than " + std::to_string(limits_.longest) +
                         " bytes, so this is not G-code text; was the right file given?");
    }

    const TextSource& source_;
    const std::string& name_;
    const LineLimits& limits_;
    std::vector<char> buffer_;
    std::string start_;
    std::size_t held_ = 0;
    std::int64_t lines_ = 0, bytes_ = 0;
};

}  // namespace

std::int64_t for_each_line(const TextSource& source, const std::string& name,
                           const LineLimits& limits,
                           const std::function<void(std::string_view)>& on_line) {
    return LineReader(source, name, limits).run(on_line);
}

}  // namespace bead
