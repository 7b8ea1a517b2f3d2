// A tariff as people write it: a price per kWh, "0.30"; prices by time of day,
// "00:00-06:00=0.12,06:00-24:00=0.30"; or a TARIFF.toml:
//
//     [price_per_kwh]
//     "22:00-06:00" = 0.12       # over midnight is allowed
//     "06:00-22:00" = 0.30
#pragma once
#include <string>
#include <string_view>

#include "energy/tariff.h"

namespace bead {

// Throws Error, naming `option` or the file, for what is no tariff, and for times that are told
// twice or not at all.
Tariff tariff_of(const std::string& text, std::string_view option = "--tariff");

// "22:15" in s; nothing else than hours and minutes.
double time_of_day(std::string_view text, std::string_view option = "--start");
// "22:15"
std::string clock_text(double time_of_day);

}  // namespace bead
