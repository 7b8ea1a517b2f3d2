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

void print_features(const Console& console, const EnergyReport& report) {
    console.say("\n{:>14} {:>12}", "feature", "all");
    for (const Consumer& column : consumers) console.say(" {:>12}", column.name);
    console.say("\n");
    const auto row = [&](std::string_view name, const Energy& energy) {
        if (total(energy) <= 0) return;
        console.say("{:>14} {:>9.2f} Wh", name, watt_hours(total(energy)));
        for (const Consumer& column : consumers)
            console.say(" {:>9.2f} Wh", watt_hours(energy.*column.joules));
        console.say("\n");
    };
    row("heating up", report.heat_up_consumers);
    for (std::size_t role = 0; role < role_names.size(); ++role) {
        const bool waits = role == static_cast<std::size_t>(Role::other);
        row(role_names[role], waits ? report.consumers_by_role[role] - report.heat_up_consumers
                                    : report.consumers_by_role[role]);
    }
}

void print_comparison(const Console& console, const Energy& before, const Energy& after) {
    for (const Consumer& row : consumers)
        console.say(
            "    {:<20} {:>13.2f} Wh {:>13.2f} Wh {:>+8.1f} %\n", row.name,
            watt_hours(before.*row.joules), watt_hours(after.*row.joules),
            before.*row.joules > 0 ? 100 * (after.*row.joules / (before.*row.joules) - 1) : 0.0);
}

}  // namespace bead::cli
