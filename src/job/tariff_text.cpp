#include "job/tariff_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "job/data_file.h"
#include "job/one_line.h"
#include "job/parsed_toml.h"

namespace bead {
namespace {

template <class T>
std::optional<T> whole_number(std::string_view text) {
    T value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

// "06:00" or "24:00", in s.
std::optional<double> clock_time(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || colon > 2 || text.size() - colon != 3) return {};
    const auto hours = whole_number<unsigned>(text.substr(0, colon));
    const auto minutes = whole_number<unsigned>(text.substr(colon + 1));
    if (!hours || !minutes || *minutes > 59 || *hours * 60 + *minutes > 24 * 60) return {};
    return *hours * 3600.0 + *minutes * 60.0;
}

std::optional<double> price_of(std::string_view text) {
    const auto price = whole_number<double>(text);
    return price && std::isfinite(*price) && *price >= 0 ? price : std::nullopt;
}

// Where a rate stands, for messages.
struct Place {
    std::string text;
    Fault fault;
};

[[noreturn]] void fail(const Place& place, const std::string& what) {
    throw Error(fmt::format("{}: {}", place.text, what), place.fault);
}

// One over midnight becomes two.
void add_rate(Tariff& tariff, std::string_view span, double price, const Place& place) {
    const std::size_t dash = span.find('-');
    const auto from = clock_time(trimmed(span.substr(0, dash)));
    const auto to =
        dash == std::string_view::npos ? std::nullopt : clock_time(trimmed(span.substr(dash + 1)));
    if (!from || !to || *from == *to)
        fail(place,
             fmt::format("{} is no stretch of the day; write it as 22:00-06:00", one_line(span)));
    if (*from < *to) {
        tariff.push_back({*from, *to, price});
        return;
    }
    if (*from < day) tariff.push_back({*from, day, price});
    if (*to > 0) tariff.push_back({0, *to, price});
}

Tariff whole_day(Tariff tariff, const Place& place) {
    std::ranges::sort(tariff, {}, &Rate::from);
    double end = 0;
    for (const Rate& rate : tariff) {
        if (rate.from != end)
            fail(place, fmt::format("{} to {} {}", clock_text(std::min(end, rate.from)),
                                    clock_text(std::max(end, rate.from)),
                                    rate.from > end ? "has no price; add one"
                                                    : "has two prices; keep one"));
        end = rate.to;
    }
    if (end != day) fail(place, fmt::format("{} to 24:00 has no price; add one", clock_text(end)));
    return tariff;
}

Tariff inline_tariff(std::string_view text, const Place& place) {
    Tariff tariff;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const std::string_view row = trimmed(text.substr(0, comma));
        text = comma == std::string_view::npos ? "" : text.substr(comma + 1);
        const std::size_t equals = row.find('=');
        const auto price = equals == std::string_view::npos
                               ? std::nullopt
                               : price_of(trimmed(row.substr(equals + 1)));
        if (!price)
            fail(place, fmt::format("{} is no price for a stretch of the day; write "
                                    "06:00-24:00=0.30, prices not below 0",
                                    one_line(row)));
        add_rate(tariff, trimmed(row.substr(0, equals)), *price, place);
    }
    return whole_day(std::move(tariff), place);
}

Tariff tariff_file(const std::string& name) {
    const DataFile data = file_on_disk("tariff", name);
    const toml::table file = parsed_toml(data.text, data.place);
    const toml::table* const prices = file["price_per_kwh"].as_table();
    const Place whole{data.place, Fault::input};
    if (prices == nullptr)
        fail(whole, "says no prices; add [price_per_kwh] with rows like \"06:00-24:00\" = 0.30");
    for (const auto& [key, node] : file)
        if (key.str() != "price_per_kwh")
            fail({place_in(data.place, node.source().begin.line), Fault::input},
                 fmt::format("{} is not a key of a tariff; remove it", one_line(key.str())));
    Tariff tariff;
    for (const auto& [key, node] : *prices) {
        const Place row{place_in(data.place, node.source().begin.line), Fault::input};
        const auto price = node.is_number() ? node.value<double>() : std::nullopt;
        if (!price || !std::isfinite(*price) || *price < 0)
            fail(row,
                 fmt::format("{}: the price must be a number not below 0", one_line(key.str())));
        add_rate(tariff, key.str(), *price, row);
    }
    return whole_day(std::move(tariff), whole);
}

}  // namespace

Tariff tariff_of(const std::string& text, std::string_view option) {
    if (text.ends_with(".toml")) return tariff_file(text);
    const Place place{std::string(option), Fault::usage};
    if (const auto price = price_of(trimmed(text))) return {{0, day, *price}};
    if (text.find('=') == std::string::npos)
        fail(place, fmt::format("{} is no tariff; give a price per kWh (0.30), prices by time of "
                                "day (00:00-06:00=0.12,06:00-24:00=0.30) or a .toml file",
                                one_line(text)));
    return inline_tariff(text, place);
}

double time_of_day(std::string_view text, std::string_view option) {
    const auto time = clock_time(trimmed(text));
    if (!time || *time >= day)
        throw Error(
            fmt::format("{}: {} is no time of day; write it as 22:15", option, one_line(text)),
            Fault::usage);
    return *time;
}

std::string clock_text(double time_of_day) {
    const int minutes = static_cast<int>(std::lround(time_of_day / 60));
    return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

}  // namespace bead
