#include "job/toml_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/error.h"
#include "job/nearest_name.h"
#include "job/parsed_toml.h"

namespace bead {

struct TomlReader::Document {
    toml::table table;
    std::string place;
    std::set<std::string, std::less<>> asked, ignored, counted;

    [[nodiscard]] std::string where(const toml::node& node) const {
        return place_in(place, node.source().begin.line);
    }
    [[noreturn]] void fail(const toml::node& node, std::string_view key,
                           std::string_view what) const {
        throw Error(fmt::format("{}: {} {}", where(node), key, what), fault_in(place));
    }
    const toml::node* find(std::string_view key) {
        asked.emplace(key);
        return table.at_path(key).node();
    }
    [[nodiscard]] double checked(const toml::node& node, std::string_view key,
                                 const Range& range) const;
    void check_known(const toml::table& level, const std::string& prefix) const;
    [[nodiscard]] bool leads_to_a_key(const std::string& path) const;
    [[nodiscard]] const toml::array& array(const toml::node& node, std::string_view key,
                                           std::string_view of) const;
    [[nodiscard]] std::vector<std::array<double, 2>> pairs(const toml::node& node,
                                                           std::string_view key,
                                                           const Range& range) const;
};

namespace {

std::string limits_of(const Range& range) {
    const std::string_view above = range.open_low ? "above" : "at least";
    if (std::isinf(range.low) && std::isinf(range.high)) return "finite";
    if (std::isinf(range.high)) return fmt::format("{} {}", above, range.low);
    if (std::isinf(range.low)) return fmt::format("at most {}", range.high);
    return fmt::format("{} {} and at most {}", above, range.low, range.high);
}

bool within(double value, const Range& range) {
    return std::isfinite(value) && value <= range.high &&
           (range.open_low ? value > range.low : value >= range.low);
}

}  // namespace

double TomlReader::Document::checked(const toml::node& node, std::string_view key,
                                     const Range& range) const {
    if (!node.is_number()) fail(node, key, "must be a number");
    const double value = *node.value<double>();
    if (!within(value, range))
        fail(node, key, fmt::format("is {} but must be {}", value, limits_of(range)));
    return value;
}

bool TomlReader::Document::leads_to_a_key(const std::string& path) const {
    const auto next = asked.lower_bound(path + '.');
    return next != asked.end() && next->starts_with(path + '.');
}

void TomlReader::Document::check_known(const toml::table& level, const std::string& prefix) const {
    for (const auto& [key, node] : level) {
        const std::string path = prefix + std::string(key.str());
        if (ignored.contains(path) || (asked.contains(path) && !counted.contains(path))) continue;
        if (node.is_table() && leads_to_a_key(path)) {
            check_known(*node.as_table(), path + '.');
            continue;
        }
        if (counted.contains(path)) {
            for (std::size_t i = 0; i < node.as_array()->size(); ++i)
                check_known(*node.as_array()->get(i)->as_table(), fmt::format("{}[{}].", path, i));
            continue;
        }
        if (leads_to_a_key(path)) fail(node, path, fmt::format("must be a table [{}]", path));
        const std::vector<std::string_view> known(asked.begin(), asked.end());
        const std::string hint = suggestion(path, known);
        const bool option = fault_in(place) == Fault::usage;
        fail(node, path,
             std::string(option ? "is not a setting" : "is not a key of this file") +
                 (hint.empty() ? "; remove it" : hint));
    }
}

TomlReader::TomlReader(std::string_view text, std::string place)
    : document_(std::make_unique<Document>()) {
    document_->table = parsed_toml(text, place);
    document_->place = std::move(place);
}

TomlReader::TomlReader(TomlReader&&) noexcept = default;
TomlReader::~TomlReader() = default;

double TomlReader::number(std::string_view key, double fallback, const Range& range) {
    const toml::node* node = document_->find(key);
    return node == nullptr ? fallback : document_->checked(*node, key, range);
}

int TomlReader::integer(std::string_view key, int fallback, const Range& range) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return fallback;
    if (!node->is_integer()) document_->fail(*node, key, "must be a whole number");
    constexpr double most = 1e9;
    const Range narrowed{std::max(range.low, -most), std::min(range.high, most), range.open_low};
    return static_cast<int>(document_->checked(*node, key, narrowed));
}

bool TomlReader::flag(std::string_view key, bool fallback) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return fallback;
    if (!node->is_boolean()) document_->fail(*node, key, "must be true or false");
    return *node->value<bool>();
}

std::string TomlReader::text(std::string_view key, const std::string& fallback) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return fallback;
    if (!node->is_string()) document_->fail(*node, key, "must be text in quotes");
    return *node->value<std::string>();
}

std::size_t TomlReader::choice(std::string_view key, std::size_t fallback,
                               std::span<const std::string_view> names) {
    const std::string word = text(key, std::string(names[fallback]));
    const auto found = std::ranges::find(names, word);
    if (found == names.end())
        document_->fail(*document_->find(key), key,
                        fmt::format("is {} but must be one of {}", word, fmt::join(names, ", ")));
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::string> TomlReader::place_of(std::string_view key) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return std::nullopt;
    return document_->where(*node);
}

const toml::array& TomlReader::Document::array(const toml::node& node, std::string_view key,
                                               std::string_view of) const {
    const toml::array* found = node.as_array();
    if (found == nullptr) fail(node, key, fmt::format("must be an array of {}", of));
    return *found;
}

std::vector<std::array<double, 2>> TomlReader::Document::pairs(const toml::node& node,
                                                               std::string_view key,
                                                               const Range& range) const {
    std::vector<std::array<double, 2>> values;
    for (const toml::node& item : array(node, key, "points [x, y]")) {
        const std::string name = fmt::format("{}[{}]", key, values.size());
        const toml::array& pair = array(item, name, "2 numbers, x and y");
        if (pair.size() != 2) fail(item, name, "must be an array of 2 numbers, x and y");
        values.push_back({checked(*pair.get(0), name, range), checked(*pair.get(1), name, range)});
    }
    return values;
}

std::vector<std::array<double, 2>> TomlReader::pairs(std::string_view key, const Range& range) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return {};
    return document_->pairs(*node, key, range);
}

std::vector<std::vector<std::array<double, 2>>> TomlReader::pair_lists(std::string_view key,
                                                                       const Range& range) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return {};
    std::vector<std::vector<std::array<double, 2>>> lists;
    for (const toml::node& item : document_->array(*node, key, "polygons"))
        lists.push_back(document_->pairs(item, fmt::format("{}[{}]", key, lists.size()), range));
    return lists;
}

std::vector<std::vector<double>> TomlReader::number_lists(std::string_view key, std::size_t lists,
                                                          std::size_t numbers, const Range& range) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return {};
    const std::string wanted = fmt::format("must be {} arrays of {} numbers", lists, numbers);
    std::vector<std::vector<double>> result;
    if (!node->is_array() || node->as_array()->size() != lists) document_->fail(*node, key, wanted);
    for (const toml::node& item : *node->as_array()) {
        if (!item.is_array() || item.as_array()->size() != numbers)
            document_->fail(item, key, wanted);
        result.emplace_back();
        for (const toml::node& value : *item.as_array())
            result.back().push_back(document_->checked(value, key, range));
    }
    return result;
}

std::size_t TomlReader::tables(std::string_view key) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return 0;
    if (!node->is_array_of_tables())
        document_->fail(*node, key, fmt::format("must be tables [[{}]]", key));
    document_->counted.emplace(key);
    return node->as_array()->size();
}

void TomlReader::refuse(std::string_view key, std::string_view what) {
    std::string outer(key);
    while (document_->table.at_path(outer).node() == nullptr && outer.find('.') != outer.npos)
        outer.resize(outer.rfind('.'));
    const toml::node* node = document_->table.at_path(outer).node();
    document_->fail(node == nullptr ? document_->table : *node, key, what);
}

void TomlReader::ignore(std::string_view key) { document_->ignored.emplace(key); }

void TomlReader::finish() const { document_->check_known(document_->table, ""); }

void TomlReader::read_numbers(std::string_view key, std::span<double> values, const Range& range) {
    const toml::node* node = document_->find(key);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != values.size())
        document_->fail(*node, key, fmt::format("must be an array of {} numbers", values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = document_->checked(*array->get(i), key, range);
}

}  // namespace bead
