// Where the program's words go: results for people on standard output (on standard error when JSON
// has standard output to itself), warnings and progress on standard error. Bars only on a terminal.
#pragma once
#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include "core/progress.h"

namespace bead::cli {

enum class ProgressStyle { none, bar, json };

struct Console {
    std::FILE* text = stdout;
    bool quiet = false;
    bool colour = false;
    ProgressStyle progress = ProgressStyle::none;

    template <class... T>
    void say(fmt::format_string<T...> format, T&&... values) const {
        if (!quiet) fmt::print(text, format, std::forward<T>(values)...);
    }
    void warn(std::string_view message) const;
    // The text in bold or green, if colour is on.
    [[nodiscard]] std::string strong(std::string_view words) const;
    [[nodiscard]] std::string good(std::string_view words) const;
};

// Draws the bar (or writes JSON lines) whenever it moves by a hundredth; clears it when done.
Progress progress_on(const Console& console);

// "1 h 02 min 03 s", "4 min 05 s", "6.7 s"
std::string spoken_time(double seconds);

}  // namespace bead::cli
