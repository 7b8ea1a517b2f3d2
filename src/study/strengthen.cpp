#include "study/strengthen.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "strength/coarse_modes.h"
#include "study/braces.h"
#include "study/patches.h"

namespace bead {
namespace {

constexpr int most_steps = 60;
constexpr double fruitful = 1.003;        // less of the norm, that a patch step shall reach
constexpr int unneeded = 2;               // times as many braces where they only fill up
constexpr int patience = 6;               // patch steps in a row without fruit
constexpr double nearly = 0.75;           // of what it should bear before it buckles: patches too
constexpr double mode_tolerance = 0.1;    // of the lowest factor, on the way
constexpr double other_tolerance = 1;     // of those above it
constexpr int most_vectors = 48;          // in which modes are sought, on the way
constexpr std::size_t most_searched = 3;  // variants, those that buckle first
constexpr double overdraw = 0.004;        // of the area, by which it may be exceeded

// A layout under test: all variants.
struct Trial {
    TestRig rig;
    std::vector<Tested> tested;
    double failure = 0;
    double norm = 0;  // of the failure indices
};

std::optional<Trial> trial_of(const LoadCase& load_case, const Layout& layout, double pixel) {
    const Toolpath layer = layer_of(layout, load_case.print);
    std::optional<TestRig> rig = TestRig::of({&layer, 1}, load_case, {.pixel = pixel});
    if (!rig) return std::nullopt;
    Trial trial{std::move(*rig), {}, std::numeric_limits<double>::infinity(), 0};
    for (std::size_t v = 0; v < trial.rig.variants().size(); ++v) {
        trial.tested.push_back(trial.rig.tested(v));
        trial.failure = std::min(trial.failure, trial.tested.back().factor());
    }
    trial.norm = failure_norm(trial.tested);
    return trial;
}

Layout joined(Layout layout, const Layout& more) {
    layout.insert(layout.end(), more.begin(), more.end());
    return layout;
}

struct CoarseVariant {
    std::size_t variant = 0;
    double factor = std::numeric_limits<double>::infinity();
    std::vector<PixelVector> start;
};

class Loop {
  public:
    Loop(const LoadCase& load_case, Layout layout, const StrengthenOptions& options)
        : case_(load_case), options_(options), trial_(trial_of(load_case, layout, options.pixel)) {
        result_.layout = std::move(layout);
        if (!trial_) return;
        find_modes();
        note(false, 0);
    }

    Strengthened run() && {
        for (int step = 0; trial_ && step < most_steps && left() > options_.full * options_.area;
             ++step) {
            const bool breaks_first = buckling_ >= options_.margin * trial_->failure;
            if (breaks_first && fruitless_ < patience)
                patch();
            else if (!brace(breaks_first ? unneeded : 1))
                break;
        }
        return std::move(result_);
    }

  private:
    double area() const { return deposited_area(result_.layout, case_.print.bead_width); }
    double left() const { return options_.area - area(); }

    void find_modes() {
        const std::vector<VariantModes> before = std::exchange(modes_, {});
        buckling_ = std::numeric_limits<double>::infinity();
        for (CoarseVariant& coarse : first_to_buckle(before)) {
            const std::size_t v = coarse.variant;
            BucklingOptions how{
                .count = options_.modes, .tolerance = mode_tolerance, .others = other_tolerance};
            how.most = most_vectors;
            how.start = std::move(coarse.start);
            modes_.push_back({v, trial_->rig.modes(v, trial_->tested[v].displacement, how)});
            if (!modes_.back().modes.empty())
                buckling_ = std::min(buckling_, modes_.back().modes.front().factor);
        }
        modes_are_of_trial_ = true;
    }

    // The variants that buckle first as coarse pixels have it, with shapes to start from: those of
    // `before` where it has them.
    std::vector<CoarseVariant> first_to_buckle(const std::vector<VariantModes>& before) const {
        std::vector<CoarseVariant> found(trial_->tested.size());
        for (std::size_t v = 0; v < found.size(); ++v) found[v].variant = v;
        for (const VariantModes& of : before)
            for (const BucklingMode& mode : of.modes) found[of.variant].start.push_back(mode.shape);
        if (found.size() > most_searched || before.empty()) look_coarsely(found);
        std::ranges::stable_sort(found, std::less{}, &CoarseVariant::factor);
        if (found.size() > most_searched) found.resize(most_searched);
        return found;
    }

    void look_coarsely(std::vector<CoarseVariant>& variants) const {
        const Toolpath layer = layer_of(result_.layout, case_.print);
        const CoarseModes coarse({&layer, 1}, case_, 2 * options_.pixel);
        for (CoarseVariant& of : variants) {
            const Buckling buckling = coarse.of(of.variant);
            if (!buckling.modes.empty()) of.factor = buckling.modes.front().factor;
            if (of.start.empty()) of.start = coarse.start(buckling, trial_->rig.model().grid);
        }
    }

    void note(bool braces, std::size_t lines) {
        result_.steps.push_back({braces, lines, area(), trial_->failure, buckling_});
    }

    void take(std::optional<Trial> next, const Layout& more) {
        trial_ = std::move(next);
        modes_are_of_trial_ = false;
        adjoint_.clear();
        tries_ = 0;
        result_.layout = joined(std::move(result_.layout), more);
    }

    // Patches for the trial as it is, where `layout` leaves room: as many as the step allows; after
    // `tried` times that did no good one, behind those that were tried.
    Layout patch_lines(const Layout& layout, int tried) {
        if (adjoint_.empty()) adjoint_ = sensitivity(trial_->rig, trial_->tested);
        const double rest = options_.area - deposited_area(layout, case_.print.bead_width);
        if (!(rest > 0)) return {};
        PatchLineOptions how{.area = std::min(options_.patch_step * options_.area, rest)};
        how.most_area = rest + overdraw * options_.area;
        if (tried > 0) {
            how.most = 1;
            how.skipped = tried - 1;
        }
        return patches(layout, trial_->rig, trial_->tested, adjoint_, case_, how);
    }

    void patch() {
        const Layout more = patch_lines(result_.layout, tries_++);
        if (more.empty()) {
            fruitless_ = patience;
            return;
        }
        std::optional<Trial> next = trial_of(case_, joined(result_.layout, more), options_.pixel);
        const double before = trial_->norm;
        if (!next || next->norm > before) {
            ++fruitless_;
            return;
        }
        take(std::move(next), more);
        fruitless_ = trial_->norm > before / fruitful ? fruitless_ + 1 : 0;
        if (buckling_ < options_.margin * trial_->failure) find_modes();
        note(false, more.size());
    }

    // `share`: of the usual number of braces. Where they need only be few, with patches.
    bool brace(int share) {
        if (!modes_are_of_trial_) find_modes();
        BraceOptions how;
        how.area = std::min(share * options_.brace_step * options_.area, left());
        how.most *= share;
        how.over = std::min(
            how.over, (left() - how.area + overdraw * options_.area) / case_.print.bead_width);
        how.shortest = options_.shortest_brace;
        Layout more = braces(trial_->rig, case_, modes_, how);
        if (more.empty()) return false;
        if (share == 1 && fruitless_ < patience &&
            buckling_ > nearly * options_.margin * trial_->failure)
            more = joined(more, patch_lines(joined(result_.layout, more), 0));
        std::optional<Trial> next = trial_of(case_, joined(result_.layout, more), options_.pixel);
        if (!next) return false;
        take(std::move(next), more);
        if (left() > options_.full * options_.area) find_modes();
        fruitless_ = 0;
        note(true, more.size());
        return true;
    }

    const LoadCase& case_;
    StrengthenOptions options_;
    std::optional<Trial> trial_;
    std::vector<VariantModes> modes_;
    bool modes_are_of_trial_ = false;
    std::vector<PixelVector> adjoint_;  // of the trial
    double buckling_ = 0;
    int fruitless_ = 0;  // patch steps in a row
    int tries_ = 0;      // patch steps on this trial
    Strengthened result_;
};

}  // namespace

Strengthened strengthened(const LoadCase& load_case, Layout layout,
                          const StrengthenOptions& options) {
    return Loop(load_case, std::move(layout), options).run();
}

}  // namespace bead
