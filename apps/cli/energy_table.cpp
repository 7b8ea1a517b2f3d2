#include "energy_table.h"

#include <array>

namespace bead::cli {
namespace {

struct Consumer {
    const char* name;
    double Energy::*joules;
};
constexpr std::array consumers{
    Consumer{"heated bed", &Energy::bed},          Consumer{"hot end", &Energy::hotend},
    Consumer{"motors", &Energy::motors},           Consumer{"fans", &Energy::fans},
    Consumer{"electronics", &Energy::electronics},
};

double watt_hours(double joules) { return joules / 3600; }

}  // namespace

void print_consumers(const Console& console, const Energy& energy) {
    const double whole = total(energy);
    for (const Consumer& row : consumers)
        console.say("{:>14} {:>9.2f} Wh {:>5.1f} %\n", row.name, watt_hours(energy.*row.joules),
                    whole > 0 ? 100 * energy.*row.joules / whole : 0.0);
}

void print_comparison(const Console& console, const Energy& before, const Energy& after) {
    for (const Consumer& row : consumers)
        console.say(
            "    {:<20} {:>13.2f} Wh {:>13.2f} Wh {:>+8.1f} %\n", row.name,
            watt_hours(before.*row.joules), watt_hours(after.*row.joules),
            before.*row.joules > 0 ? 100 * (after.*row.joules / (before.*row.joules) - 1) : 0.0);
}

}  // namespace bead::cli
