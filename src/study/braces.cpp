#include "study/braces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geom/polygon.h"
#include "study/brace_candidates.h"

namespace bead {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double least_cell = 0.8;  // mm; shorter ways between beads are no cells
constexpr std::size_t kept = 3000;  // candidates that are looked at closely
constexpr double apart = 1.2;       // mm, between the middles of two braces
constexpr double enough = 0.9;      // of the budget
constexpr double worth = 1e-6;      // of the measure, that a brace must gain

struct Brace {
    Vec2 from, to;
    double size = 0;                // mm
    std::vector<Matrix> stiffness;  // per variant, in the space of its modes
    double promise = 0;
};

// What a variant's modes leave of the load after braces: eigenvalues 1/λ of the structure in their
// space. The measure is their 8-norm: the largest counts most, those near it count too.
struct ModeSpace {
    const VariantModes* modes = nullptr;
    Vector inverse_factors;  // 1/λ
    Matrix added;            // stiffness of the braces that are chosen

    [[nodiscard]] double eighth_powers(const Matrix& stiffness) const {
        const auto n = stiffness.rows();
        const Vector root = inverse_factors.cwiseSqrt();
        const Matrix inverse =
            (Matrix::Identity(n, n) + stiffness).llt().solve(Matrix::Identity(n, n));
        const Matrix a = root.asDiagonal() * inverse * root.asDiagonal();
        const Matrix square = a * a;
        return (square * square).squaredNorm();
    }
};

std::vector<ModeSpace> spaces_of(const std::vector<VariantModes>& modes) {
    std::vector<ModeSpace> spaces;
    for (const VariantModes& of : modes) {
        if (of.modes.empty()) continue;
        ModeSpace space{&of, Vector(static_cast<Eigen::Index>(of.modes.size())), {}};
        for (std::size_t i = 0; i < of.modes.size(); ++i)
            space.inverse_factors(static_cast<Eigen::Index>(i)) = 1 / of.modes[i].factor;
        space.added = Matrix::Zero(space.inverse_factors.size(), space.inverse_factors.size());
        spaces.push_back(std::move(space));
    }
    return spaces;
}

class Candidates {
  public:
    Candidates(const TestRig& rig, const LoadCase& load_case, const std::vector<ModeSpace>& spaces,
               const BraceOptions& options)
        : grid_(rig.model().grid), spaces_(spaces), options_(options) {
        bar_ = soft_joints * load_case.material.young * load_case.thickness *
               load_case.print.bead_width;
        for (const CrossedLine& line : crossed_lines(rig.model(), load_case, options.pitch))
            append(line);
        keep_best();
    }
    std::vector<Brace> found;

  private:
    void append(const CrossedLine& line) {
        const auto& at = line.crossings;
        std::vector<std::vector<Matrix>> cells;
        for (std::size_t i = 1; i < at.size(); ++i) cells.push_back(cell(at[i - 1], at[i]));
        for (std::size_t a = 0; a + 1 < at.size(); ++a) {
            Brace candidate{at[a].at, {}, 0, zeros(), 0};
            const std::size_t last =
                std::min(at.size() - 1, a + static_cast<std::size_t>(options_.cells));
            for (std::size_t b = a + 1; b <= last; ++b) {
                for (std::size_t v = 0; v < spaces_.size(); ++v)
                    candidate.stiffness[v] += cells[b - 1][v];
                candidate.to = at[b].at;
                candidate.size = distance(candidate.from, candidate.to);
                if (candidate.size < options_.shortest || candidate.size > options_.longest)
                    continue;
                candidate.promise = promise_of(candidate);
                found.push_back(candidate);
            }
        }
    }

    std::vector<Matrix> zeros() const {
        std::vector<Matrix> all;
        for (const ModeSpace& space : spaces_)
            all.push_back(Matrix::Zero(space.added.rows(), space.added.cols()));
        return all;
    }

    // A bar from bead to bead.
    std::vector<Matrix> cell(const BeadCrossing& a, const BeadCrossing& b) const {
        std::vector<Matrix> all = zeros();
        const double size = distance(a.at, b.at);
        if (size < least_cell) return all;
        const Vec2 along = (b.at - a.at) / size;
        for (std::size_t v = 0; v < spaces_.size(); ++v) {
            Vector stretched(all[v].rows());
            for (Eigen::Index i = 0; i < stretched.size(); ++i) {
                const PixelVector& shape =
                    spaces_[v].modes->modes[static_cast<std::size_t>(i)].shape;
                stretched(i) = dot(
                    displacement_at(grid_, b.pixel, shape) - displacement_at(grid_, a.pixel, shape),
                    along);
            }
            all[v] = bar_ / size * stretched * stretched.transpose();
        }
        return all;
    }

    double promise_of(const Brace& candidate) const {
        double sum = 0;
        for (std::size_t v = 0; v < spaces_.size(); ++v)
            sum += (candidate.stiffness[v].diagonal().array() *
                    spaces_[v].inverse_factors.array().pow(8))
                       .sum();
        return sum / (candidate.size + end_cost);
    }

    void keep_best() {
        std::ranges::stable_sort(found, std::greater{}, &Brace::promise);
        if (found.size() > kept) found.resize(kept);
    }

    const PixelGrid& grid_;
    const std::vector<ModeSpace>& spaces_;
    const BraceOptions& options_;
    double bar_ = 0;  // N, stiffness times length
};

double measure(const std::vector<ModeSpace>& spaces, const Brace* with) {
    double sum = 0;
    for (std::size_t v = 0; v < spaces.size(); ++v)
        sum += spaces[v].eighth_powers(with == nullptr ? spaces[v].added
                                                       : spaces[v].added + with->stiffness[v]);
    return std::pow(sum, 1.0 / 8);
}

// The place of the candidate that gains most per length; nothing if none is worth it.
std::optional<std::size_t> best_of(const std::vector<Brace>& candidates,
                                   const std::vector<ModeSpace>& spaces, double longest) {
    const double now = measure(spaces, nullptr);
    double best_gain = worth * now;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (candidates[i].size > longest) continue;
        const double gain =
            (now - measure(spaces, &candidates[i])) / (candidates[i].size + end_cost);
        if (gain <= best_gain) continue;
        best_gain = gain;
        best = i;
    }
    return best;
}

}  // namespace

Layout braces(const TestRig& rig, const LoadCase& load_case, const std::vector<VariantModes>& modes,
              const BraceOptions& options) {
    std::vector<ModeSpace> spaces = spaces_of(modes);
    std::vector<Brace> candidates = Candidates(rig, load_case, spaces, options).found;
    const double whole = options.area / load_case.print.bead_width;
    Layout chosen;
    double used = 0;
    while (used < enough * whole && chosen.size() < static_cast<std::size_t>(options.most)) {
        const std::optional<std::size_t> best =
            best_of(candidates, spaces, whole - used + options.over);
        if (!best) break;
        const Brace brace = candidates[*best];
        for (std::size_t v = 0; v < spaces.size(); ++v) spaces[v].added += brace.stiffness[v];
        used += brace.size;
        chosen.push_back({LineKind::brace, {brace.from, brace.to}});
        std::erase_if(candidates, [&](const Brace& other) {
            return distance(0.5 * (other.from + other.to), 0.5 * (brace.from + brace.to)) < apart;
        });
    }
    return chosen;
}

}  // namespace bead
