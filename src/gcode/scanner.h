// The syntax of G-code, apart from its meaning: one line of text to a command and its words.
// A word is a letter and a number: "X10.5", "x 10.5", "X+1e1" or several without blanks, "X1Y2E3".
// Since E is also a letter of its own, an exponent counts as one only in lower case after a
// capital letter: "X1e3" is X 1000, "X1E3" and "x1e3" are X 1 and E 3.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace bead {

enum class LineKind : std::uint8_t { blank, comment, command, junk };

struct Line {
    LineKind kind = LineKind::blank;
    char letter = 0;        // capital, of a command like G1; 0 for a macro like PRINT_START
    int number = -1;        // -1 if there is none that is whole (G92.1)
    std::string_view name;  // the command as it stands there
    std::string_view rest;  // its words; of a comment what follows the ';'
};

// Line numbers (N12) are skipped.
Line split_line(std::string_view text);

class Words {
  public:
    // Comments are skipped, also what follows a checksum (*71).
    explicit Words(std::string_view text);

    [[nodiscard]] bool has(char letter) const { return (numbered_ & bit(letter)) != 0; }
    [[nodiscard]] bool names(char letter) const { return ((numbered_ | bare_) & bit(letter)) != 0; }
    [[nodiscard]] double at(char letter) const { return numbers_[std::size_t(letter - 'A')]; }
    [[nodiscard]] bool none() const { return (numbered_ | bare_) == 0; }
    [[nodiscard]] bool any_of(std::uint32_t letters) const { return (numbered_ & letters) != 0; }
    [[nodiscard]] bool has_bare() const { return bare_ != 0; }   // letters without a number
    [[nodiscard]] bool has_junk() const { return junk_; }        // what is neither word nor comment
    [[nodiscard]] char too_large() const { return too_large_; }  // a letter whose number is; or 0
    // Whether there is no checksum, or the right one: all bytes of the line before it, by exclusive
    // or. `line` is the text in which the words stand.
    [[nodiscard]] bool fit_checksum(std::string_view line) const;

    static constexpr std::uint32_t bit(char letter) { return std::uint32_t{1} << (letter - 'A'); }

  private:
    const char* read_word(const char* at, const char* end);
    void keep(char letter, double value);

    std::uint32_t numbered_ = 0, bare_ = 0;  // bit 0 is A
    bool junk_ = false;
    char too_large_ = 0;
    std::string_view checksum_;
    std::array<double, 26> numbers_;  // only those with their bit set
};

}  // namespace bead
