#include "gcode/line_reader.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/error.h"

namespace bead {
namespace {

using namespace std::string_view_literals;

struct Magic {
    std::string_view bytes, complaint;
};
constexpr std::array magics{
    Magic{"GCDE"sv,
          "this is binary G-code, which is not read: switch off \"Supports binary G-code\" in "
          "PrusaSlicer's printer settings and export again, or convert the file with bgcode"},
    Magic{"PK\3\4"sv, "this is an archive, not G-code text; unpack it or name it as a file"},
    Magic{"\x1f\x8b"sv, "this is gzipped, not G-code text; unpack it or name it as a file"},
};

}  // namespace

LineReader::LineReader(const TextSource& source, std::string name, const LineLimits& limits)
    : source_(source), name_(std::move(name)), limits_(limits) {}

std::string_view LineReader::next(std::int64_t before) {
    held_ -= begin_;
    if (begin_ > 0) std::memmove(buffer_.data(), buffer_.data() + begin_, held_);
    begin_ = 0;
    while (begin_ == 0) {
        if (fill(before) == 0) {
            if (held_ == 0) return {};
            buffer_[held_++] = '\n';
        }
        shorten_first_line(before);
        const std::string_view all(buffer_.data(), held_);
        begin_ = all.rfind('\n') + 1;
    }
    return {buffer_.data(), begin_};
}

std::size_t LineReader::fill(std::int64_t before) {
    buffer_.resize(std::max(buffer_.size(), held_ + limits_.chunk + padding));
    const std::span<char> place(buffer_.data() + held_, limits_.chunk);
    const std::size_t fresh = source_(place);
    refuse_binary({place.data(), fresh}, before);
    held_ += fresh;
    bytes_ += std::int64_t(fresh);
    return fresh;
}

void LineReader::refuse_binary(std::string_view fresh, std::int64_t before) {
    if (start_.size() < 4) start_ += fresh.substr(0, 4 - start_.size());
    for (const Magic& magic : magics)
        if (start_.starts_with(magic.bytes)) fail(1, magic.complaint);
    const auto nul = fresh.find('\0');
    if (nul == std::string_view::npos) return;
    const auto ends = std::ranges::count(fresh.substr(0, nul), '\n');
    fail(before + 1 + ends,
         "there is a NUL byte, so this is not G-code text; export it as plain (ASCII or UTF-8) "
         "text");
}

// Only the first line can be too long: others are within a chunk.
void LineReader::shorten_first_line(std::int64_t before) {
    if (held_ <= limits_.longest) return;
    const std::string_view all(buffer_.data(), held_);
    const std::size_t end = std::min(all.find('\n'), held_);
    if (end <= limits_.longest) return;
    if (all.substr(0, limits_.longest).find(';') == std::string_view::npos)
        fail(before + 1, "the line is longer than " + std::to_string(limits_.longest) +
                             " bytes, so this is not G-code text; was the right file given?");
    std::memmove(buffer_.data() + limits_.longest, buffer_.data() + end, held_ - end);
    held_ -= end - limits_.longest;
}

void LineReader::fail(std::int64_t line, std::string_view complaint) const {
    throw Error(name_ + ":" + std::to_string(line) + ": " + std::string(complaint));
}

}  // namespace bead
