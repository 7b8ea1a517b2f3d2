// What energy costs: one price, or one by time of day.
//
//     Billing billing(tariff, start);
//     meter.listen({[&](double t) { return billing.next_change(t); },
//                   [&](const PowerPiece& piece) { billing.add(piece); }});
#pragma once
#include <vector>

#include "energy/power_pieces.h"

namespace bead {

inline constexpr double day = 24 * 3600;  // s
inline constexpr double joules_per_kwh = 3.6e6;

// From one time of day (s) to a later one.
struct Rate {
    double from = 0, to = day;
    double price = 0;  // per kWh, in whatever money
};

// Rates in order that cover the day without a gap; one of them: the same all day.
using Tariff = std::vector<Rate>;

struct Bill {
    double heat_up = 0, print = 0;  // money
    std::vector<double> energy;     // J, of each rate
};

class Billing {
  public:
    // `start`: the time of day (s) when the print is begun.
    Billing(Tariff tariff, double start);

    // s since the beginning, after `time`; prices are the same until then.
    [[nodiscard]] double next_change(double time) const;
    void add(const PowerPiece& piece);  // none across a change
    [[nodiscard]] const Bill& bill() const { return bill_; }

  private:
    [[nodiscard]] double time_of_day(double time) const;
    [[nodiscard]] std::size_t rate_at(double time) const;

    Tariff tariff_;
    double start_;
    Bill bill_;
};

}  // namespace bead
