// A TOML file whose every key is checked: a value of the wrong type or out of range, and a key that
// nobody asked for, throw an Error that names the file, the line, the key and what to do.
//
//     TomlReader file(text, "my.toml");
//     printer.nozzle = file.number("nozzle_mm", printer.nozzle, positive);
//     file.finish();
#pragma once
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bead {

// Bounds are allowed values themselves, unless `open_low`.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool open_low = false;
};
inline constexpr Range positive{.low = 0, .open_low = true};
inline constexpr Range not_negative{.low = 0};

// Keys are given with their tables: "limits.jerk_mm_s". A key that is absent gives the fallback.
class TomlReader {
  public:
    // `place` names the text in messages; an option ("--…") has no lines, and makes what is wrong
    // with it a fault of usage.
    TomlReader(std::string_view text, std::string place);
    TomlReader(TomlReader&&) noexcept;
    ~TomlReader();

    double number(std::string_view key, double fallback, const Range& range = {});
    int integer(std::string_view key, int fallback, const Range& range = {});
    bool flag(std::string_view key, bool fallback);
    std::string text(std::string_view key, const std::string& fallback);
    // The place in `names` of the word that the file says.
    std::size_t choice(std::string_view key, std::size_t fallback,
                       std::span<const std::string_view> names);
    // An array of exactly as many numbers.
    template <std::size_t n>
    std::array<double, n> numbers(std::string_view key, std::array<double, n> fallback,
                                  const Range& range = {}) {
        read_numbers(key, fallback, range);
        return fallback;
    }
    // Arrays of [x, y], and arrays of such arrays.
    std::vector<std::array<double, 2>> pairs(std::string_view key, const Range& range = {});
    std::vector<std::vector<std::array<double, 2>>> pair_lists(std::string_view key,
                                                               const Range& range = {});
    // Exactly as many arrays of exactly as many numbers.
    std::vector<std::vector<double>> number_lists(std::string_view key, std::size_t lists,
                                                  std::size_t numbers, const Range& range = {});
    // How many tables [[key]] there are; their keys are "key[0].name", "key[1].name" …
    std::size_t tables(std::string_view key);
    // Throws an Error that names the place of the key, the key and what is wrong with it.
    [[noreturn]] void refuse(std::string_view key, std::string_view what);
    // Where the file says it, "my.toml:7"; nothing if it does not.
    std::optional<std::string> place_of(std::string_view key);
    // The key and all below it may say anything.
    void ignore(std::string_view key);

    // Throws if the file has a key that was not asked for.
    void finish() const;

  private:
    struct Document;
    void read_numbers(std::string_view key, std::span<double> values, const Range& range);

    std::unique_ptr<Document> document_;
};

}  // namespace bead
