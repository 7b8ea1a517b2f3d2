// The words of Klipper's longer commands: KEY=value, set apart by blanks, up to a comment.
//
//     number_of("VELOCITY=300 ACCEL=5000", "ACCEL")   // 5000
#pragma once
#include <optional>
#include <string_view>

namespace bead {

// Of the first such key; capitals or not is the same. Quotes around the value are taken off.
std::optional<std::string_view> value_of(std::string_view words, std::string_view key);

struct KeyNumber {
    bool named = false;           // the key is there …
    std::optional<double> value;  // … and a number of at most 1e9 with it
};
KeyNumber number_of(std::string_view words, std::string_view key);

}  // namespace bead
