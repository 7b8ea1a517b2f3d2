#include "mesh/text.h"

#include <algorithm>
#include <charconv>

namespace bead {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

std::optional<double> number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

std::string_view Words::next() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
}

void Words::skip_line() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }

long Words::line() const { return 1 + std::ranges::count(text_.substr(0, at_), '\n'); }

}  // namespace bead
