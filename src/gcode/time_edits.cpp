#include "gcode/time_edits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/expects.h"
#include "gcode/time_text.h"

namespace bead {
namespace {

constexpr double digit_rounding = 1e-9;  // so that 100 * (0.29 / 1) is cut to 29

using Marks = std::vector<TimeMark>;

Marks::const_iterator find_word(const Marks& marks, TimeWord word) {
    return std::ranges::find(marks, word, &TimeMark::word);
}

// Time that passed, from simulated time: the slicer's while the machine prepares itself.
class Clock {
  public:
    Clock(const TimeMarks& found, const PrintTimes& times) : times_(times) {
        const auto header = find_word(found.marks, TimeWord::with_preparation);
        const auto prepared = find_word(found.marks, TimeWord::prepared);
        if (header == found.marks.end() || prepared == found.marks.end()) return;
        const std::size_t semicolon = header->text.find(';', 1);
        if (semicolon == std::string::npos) return;
        const auto model = time_in(header->text.substr(0, semicolon));
        const auto all = time_in(header->text.substr(semicolon));
        if (!model || !all || *all < *model) return;
        prepared_ = std::size_t(prepared - found.marks.begin());
        simulated_ = times.at[prepared_];
        told_ = *all - *model;
    }

    [[nodiscard]] double preparation() const { return told_; }
    [[nodiscard]] double total() const { return times_.total - simulated_ + told_; }
    [[nodiscard]] double at(std::size_t mark) const {
        if (mark >= prepared_) return times_.at[mark] - simulated_ + told_;
        return simulated_ > 0 ? times_.at[mark] * told_ / simulated_ : 0;
    }

  private:
    const PrintTimes& times_;
    std::size_t prepared_ = 0;         // marks from here on run by our time
    double simulated_ = 0, told_ = 0;  // s, until there
};

// Cut, as slicers do, so that equal times leave a line as it is.
std::string cut_number(double value, int decimals) {
    const double one = std::pow(10.0, decimals);
    const double cut = std::floor(value * one + digit_rounding) / one;
    std::array<char, 400> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), cut,
                                   std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

int decimals_of(std::string_view number) {
    const std::size_t point = number.find('.');
    return point == std::string_view::npos ? 0 : std::min(6, int(number.size() - point - 1));
}

std::string progress_line(std::string line, double elapsed, double total) {
    const double percent = total > 0 ? std::min(100.0, 100 * (elapsed / total)) : 100;
    const double left = std::max(0.0, total - elapsed);
    const std::vector<ProgressNumber> numbers = progress_numbers(line);
    for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
        const double value = number->letter == 'P' ? percent : left / 60;
        line.replace(number->begin, number->size, cut_number(value, std::min(6, number->decimals)));
    }
    return line;
}

// The slicer's last word, "M73 P100 R0", often with the end code behind it.
bool says_done(const TimeMark& mark) {
    return std::ranges::any_of(progress_numbers(mark.text), [&](const ProgressNumber& number) {
        return number.letter == 'P' && mark.text.compare(number.begin, number.size, "100") == 0;
    });
}

std::string with_value(const std::string& line, std::string_view key_end,
                       const std::string& value) {
    const std::size_t from = line.find(key_end) + key_end.size();
    const std::size_t to = std::min(line.find_first_of("\r\n", from), line.size());
    return line.substr(0, from) + value + line.substr(to);
}

std::string with_count(const std::string& line, double seconds) {
    const std::string_view text = std::string_view(line).substr(0, line.find_first_of("\r\n"));
    return with_value(line, ":", cut_number(seconds, decimals_of(text)));
}

class Editor {
  public:
    Editor(const TimeMarks& found, const PrintTimes& times)
        : marks_(found.marks), clock_(found, times) {
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            if (marks_[i].word == TimeWord::progress) last_progress_ = i;
            if (marks_[i].word == TimeWord::layer) second_layer_ = layers_++ > 0 ? i : 0;
        }
    }

    // What the mark's line should be.
    [[nodiscard]] std::string line(std::size_t i) const {
        const std::string& text = marks_[i].text;
        switch (marks_[i].word) {
            case TimeWord::progress:
                if (i == last_progress_ && says_done(marks_[i])) return text;
                return progress_line(text, clock_.at(i), clock_.total());
            case TimeWord::total:
                return with_value(text, " = ", time_text(clock_.total()));
            case TimeWord::first_layer:
                return with_value(text, " = ", time_text(first_layer()));
            case TimeWord::with_preparation:
                return with_value(text, ": ", both_times());
            case TimeWord::cura_total:
                return with_count(text, clock_.total());
            case TimeWord::cura_elapsed:
                return with_count(text, clock_.at(i));
            default:
                return text;
        }
    }

  private:
    // As slicers count it: with all that comes before it.
    [[nodiscard]] double first_layer() const {
        return layers_ > 1 ? clock_.at(second_layer_) : clock_.total();
    }
    [[nodiscard]] std::string both_times() const {
        const double model = std::floor(clock_.total() - clock_.preparation());
        return time_text(model) +
               "; total estimated time: " + time_text(model + clock_.preparation());
    }

    const Marks& marks_;
    Clock clock_;
    std::size_t last_progress_ = 0, second_layer_ = 0, layers_ = 0;
};

std::int64_t end_of(const Edit& edit) { return edit.offset + std::int64_t(edit.was.size()); }

// In place of what there is of it, or at the end of the head.
std::vector<Edit> signature_edits(const TimeMarks& found, std::span<const std::string> signature) {
    std::string text;
    for (const std::string& line : signature) text += line + found.line_end;
    std::vector<Edit> edits;
    for (const TimeMark& mark : found.marks) {
        if (mark.word != TimeWord::signature) continue;
        if (!edits.empty() && end_of(edits.back()) == mark.offset)
            edits.back().was += mark.text;
        else
            edits.push_back({mark.offset, mark.text, ""});
    }
    if (edits.empty()) edits.push_back({found.head, "", ""});
    edits.front().now = text;
    return edits;
}

}  // namespace

double told_total(const TimeMarks& found, const PrintTimes& times) {
    return Clock(found, times).total();
}

std::vector<Edit> time_edits(const TimeMarks& found, const PrintTimes& times,
                             std::span<const std::string> signature) {
    BEAD_EXPECTS(times.at.size() == found.marks.size());
    std::vector<Edit> edits = signature_edits(found, signature);
    const Editor editor(found, times);
    for (std::size_t i = 0; i < found.marks.size(); ++i)
        if (found.marks[i].word != TimeWord::signature)
            edits.push_back({found.marks[i].offset, found.marks[i].text, editor.line(i)});
    std::erase_if(edits, [](const Edit& edit) { return edit.was == edit.now; });
    std::ranges::stable_sort(edits, {}, &Edit::offset);
    return edits;
}

}  // namespace bead
