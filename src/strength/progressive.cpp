#include "strength/progressive.h"

#include <algorithm>

namespace bead {
namespace {

constexpr double fails = 0.95;  // of the highest index: what is taken away in one step
constexpr int most_steps = 60;
constexpr double fallen = 0.5;  // of the peak: nothing more is to come

}  // namespace

double peak_factor(const TestRig& rig, std::size_t variant, const Tested& first) {
    PixelModel model = rig.model();
    Tested tested = first;
    std::optional<PixelSolver> fresh;
    double peak = first.factor();
    for (int step = 0; step < most_steps && tested.factor() > fallen * peak; ++step) {
        const double limit = fails * tested.index[tested.weakest];
        for (std::size_t p = 0; p < model.factor.size(); ++p)
            if (tested.index[p] >= limit) model.factor[p] = 0;
        const PixelSolver& solver = fresh ? *fresh : rig.solver(variant);
        Displacement moved =
            solver.solve_changed(model, rig.load(variant),
                                 {.tolerance = 1e-5, .most = 60, .start = tested.displacement});
        if (!moved.converged) {
            fresh.emplace(model, solver.held());
            if (fresh->loose_node()) break;
            moved = fresh->solve(rig.load(variant));
        }
        tested = rig.judged(model, std::move(moved.values), variant);
        if (!(tested.index[tested.weakest] > 0)) break;
        peak = std::max(peak, tested.factor());
    }
    return peak;
}

}  // namespace bead
