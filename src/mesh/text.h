// Words and numbers of text files, the same in every locale.
#pragma once
#include <optional>
#include <string_view>

namespace bead {

// The whole word as a number; nothing if it is none. Takes a leading '+', "nan" and "inf".
std::optional<double> number(std::string_view word);

// Splits text into words at spaces and line ends.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}
    std::string_view next();  // empty at the end
    void skip_line();
    [[nodiscard]] long line() const;  // of the last word, from 1; counts from the start each time

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace bead
