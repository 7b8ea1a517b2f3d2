#include "gcode/time_marks.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "gcode/number.h"

namespace bead {
namespace {

constexpr std::size_t longest_mark = 1024;  // bytes; a longer line is none
constexpr std::string_view leading_mark = "\xef\xbb\xbf";

constexpr std::array<std::pair<std::string_view, TimeWord>, 8> comments{{
    {"; estimated printing time (normal mode) = ", TimeWord::total},
    {"; estimated first layer printing time (normal mode) = ", TimeWord::first_layer},
    {"; model printing time: ", TimeWord::with_preparation},
    {";TIME:", TimeWord::cura_total},
    {";TIME_ELAPSED:", TimeWord::cura_elapsed},
    {"; MACHINE_START_GCODE_END", TimeWord::prepared},
    {";LAYER_CHANGE", TimeWord::layer},
    {"; CHANGE_LAYER", TimeWord::layer},
}};

bool is_plain_number(std::string_view text) {
    text = text.substr(0, text.find_first_of("\r\n"));
    const Number number = read_number(text.data(), text.data() + text.size(), false);
    return !text.empty() && is_digit(text.front()) && number.end == text.data() + text.size();
}

std::optional<TimeWord> comment_word(std::string_view line) {
    const auto row = std::ranges::find_if(
        comments, [&](const auto& comment) { return line.starts_with(comment.first); });
    if (row == comments.end()) return {};
    const bool both = line.find("; total estimated time: ") != std::string_view::npos;
    if (row->second == TimeWord::with_preparation && !both) return {};
    const bool counts =
        row->second == TimeWord::cura_total || row->second == TimeWord::cura_elapsed;
    if (counts && !is_plain_number(line.substr(row->first.size()))) return {};
    return row->second;
}

std::optional<TimeWord> word_of(std::string_view line) {
    if (line.empty()) return {};
    if (line.front() == ';') return comment_word(line);
    if (line.front() == 'G' || progress_numbers(line).empty()) return {};
    return TimeWord::progress;
}

bool is_signature(std::string_view line) {
    return line.starts_with(signature_start) || line.starts_with(remark_start);
}

bool starts_thumbnail(std::string_view line) {
    return line.starts_with("; thumbnail") || line.starts_with("; THUMBNAIL");
}

class Finder {
  public:
    void feed(std::string_view piece) {
        while (!piece.empty()) {
            const std::size_t stop = piece.find('\n');
            const bool ends = stop != std::string_view::npos;
            const std::string_view part = ends ? piece.substr(0, stop + 1) : piece;
            if (ends && length_ == 0)
                take(part, part.size(), true);
            else
                hold(part, ends);
            piece.remove_prefix(part.size());
        }
    }

    TimeMarks finish() {
        if (length_ > 0) take(held_, length_, false);
        return std::move(found_);
    }

  private:
    void hold(std::string_view part, bool ends) {
        held_ += part.substr(0, longest_mark + 1 - std::min(held_.size(), longest_mark + 1));
        length_ += part.size();
        if (!ends) return;
        take(held_, length_, true);
        held_.clear();
        length_ = 0;
    }

    // `text` is the line as far as it is kept, `length` its whole length; the last may not end.
    void take(std::string_view text, std::size_t length, bool ends) {
        ++line_;
        if (line_ == 1 && text.ends_with("\r\n")) found_.line_end = "\r\n";
        in_head_ = in_head_ && ends && belongs_to_head(text);
        if (in_head_) found_.head = offset_ + std::int64_t(length);
        if (length <= longest_mark) look_for_mark(text);
        offset_ += std::int64_t(length);
    }

    [[nodiscard]] bool belongs_to_head(std::string_view text) const {
        if (line_ == 1 && text.starts_with(leading_mark)) return true;
        return text.starts_with(';') && !starts_thumbnail(text);
    }

    void look_for_mark(std::string_view text) {
        std::optional<TimeWord> word = word_of(text);
        if (in_head_ && is_signature(text)) word = TimeWord::signature;
        if (word == TimeWord::layer && ++layers_ > 2) word.reset();
        if (word) found_.marks.push_back({*word, line_, offset_, std::string(text)});
    }

    TimeMarks found_;
    std::string held_;        // the start of a line that is not whole yet
    std::size_t length_ = 0;  // of that line so far
    std::int64_t line_ = 0, offset_ = 0;
    int layers_ = 0;
    bool in_head_ = true;
};

}  // namespace

std::vector<ProgressNumber> progress_numbers(std::string_view line) {
    std::size_t at = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string_view command = line.substr(at, 3);
    if (command != "M73" && command != "m73") return {};
    at += command.size();
    if (at < line.size() && (is_digit(line[at]) || line[at] == '.')) return {};
    line = line.substr(0, line.find_first_of(";(\r\n"));
    if (line.find('*') != std::string_view::npos) return {};

    std::vector<ProgressNumber> numbers;
    while (at < line.size()) {
        const char letter = char(line[at++] & ~0x20);
        if (letter != 'P' && letter != 'R') continue;
        const std::size_t end = std::min(line.find_first_not_of("0123456789.", at), line.size());
        const std::string_view number = line.substr(at, end - at);
        if (!is_plain_number(number)) continue;
        const std::size_t point = std::min(number.find('.'), number.size() - 1);
        const bool has_point = number[point] == '.';
        numbers.push_back(
            {letter, at, number.size(), has_point ? int(number.size() - point - 1) : 0});
        at = end;
    }
    return numbers;
}

TimeMarks time_marks(const TextSource& source) {
    Finder finder;
    std::vector<char> buffer(std::size_t{1} << 18);
    while (const std::size_t count = source(buffer)) finder.feed({buffer.data(), count});
    return finder.finish();
}

}  // namespace bead
