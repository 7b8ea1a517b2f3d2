#include "study/densities.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "fem/pixel_boundary.h"
#include "fem/pixel_solver.h"
#include "fem/pixel_stress.h"
#include "geom/polygon.h"
#include "strength/failure_index.h"
#include "strength/load_variants.h"
#include "strength/printed_pixels.h"
#include "study/blur.h"
#include "study/fixed_lines.h"

namespace bead {
namespace {

constexpr double softness = 0.02;  // of the families, in all directions: joints hold a little
constexpr double soft_poisson = 0.3;
constexpr int widened_from = 6;               // iteration
constexpr double widening = 5, blending = 2;  // mm: saturated zones grow by this, softly
constexpr double persistence = 0.3;  // of an excess, that is added to what is remembered of it
constexpr double most_excess = 4;
constexpr double least_counted = 0.05;  // densities that say how stress and density go together
constexpr double most_counted = 0.94;
constexpr int fine = 6;  // fine pixels per cell, for what walls and pads cover

using Field = std::vector<double>;

// The share of each coarse pixel that walls and pads cover.
Field covered(const LoadCase& load_case, const Layout& fixed, const PixelGrid& grid) {
    const PixelGrid finer{grid.origin, grid.size / fine, grid.columns * fine, grid.rows * fine};
    const Field solid = printed_pixels(layer_of(fixed, load_case.print), finer);
    Field share(grid.pixels(), 0.0);
    for (int j = 0; j < finer.rows; ++j)
        for (int i = 0; i < finer.columns; ++i)
            share[grid.pixel(i / fine, j / fine)] += solid[finer.pixel(i, j)] / (fine * fine);
    return share;
}

class Iteration {
  public:
    Iteration(const LoadCase& load_case, const Layout& fixed, const DensityOptions& options)
        : case_(load_case), options_(options), variants_(load_variants(load_case)) {
        model_.grid = grid_over(bounds(load_case.part), options.cell);
        model_.thickness = load_case.thickness;
        model_.factor = coverage(load_case.part, model_.grid);
        for (double& share : model_.factor) share = share >= 0.5 ? 1 : 0;
        fixed_ = covered(load_case, fixed, model_.grid);
        for (const double share : model_.factor) cells_ += share;
        budget_ = options.area / (model_.grid.size * model_.grid.size);
        for (Field& r : density_) r.assign(model_.factor.size(), budget_ / cells_ / 2);
        frame_.assign(model_.factor.size(), {});
        excess_.assign(model_.factor.size(), 1);
        judged_ = far_from(model_.grid, patches_of(load_case), options.excluded);
        set_loads();
    }

    void step(int number) {
        set_laws(number == 0);
        const std::vector<std::vector<PlaneTensor>> stress = smooth_stresses();
        turn_frame(stress);
        std::array<Field, 2> wanted = stresses_along(stress);
        if (number >= widened_from) widen(wanted);
        move_densities(wanted, number == 0);
    }

    Densities result() const {
        Densities best;
        best.work = work_;
        best.frame = at_nodes(frame_);
        for (std::size_t f = 0; f < 2; ++f) best.density[f] = at_nodes(density_[f]);
        return best;
    }

  private:
    void set_loads() {
        const PatchOptions reach{3 * model_.grid.size};
        for (const Situation& situation : case_.situations) {
            const auto held = held_nodes(model_, case_.part, situation.supports, reach);
            BEAD_EXPECTS(held);
            held_.push_back(*held);
        }
        for (const Variant& variant : variants_) {
            const auto load = load_vector(model_, case_.part, variant.loads, reach);
            BEAD_EXPECTS(load);
            loads_.push_back(*load);
        }
    }

    void set_laws(bool is_first) {
        const double young = case_.material.young;
        model_.laws.resize(model_.factor.size());
        solid_law_ = isotropic(young, case_.material.poisson);
        for (std::size_t p = 0; p < model_.laws.size(); ++p) {
            const double both = density_[0][p] + density_[1][p];
            const Vec2 first = unit(principal(frame_[p]).angle);
            PlaneLaw law = is_first ? isotropic(young * both / 3, soft_poisson)
                                    : bars(young * density_[0][p], first) +
                                          bars(young * density_[1][p], left_of(first)) +
                                          isotropic(softness * young * both, soft_poisson);
            model_.laws[p] = law + fixed_[p] * solid_law_;
        }
    }

    // Of the families alone, per variant.
    std::vector<std::vector<PlaneTensor>> smooth_stresses() {
        std::vector<PixelSolver> solvers;
        for (const Held& held : held_) solvers.emplace_back(model_, held);
        std::vector<std::vector<PlaneTensor>> all;
        for (std::size_t v = 0; v < variants_.size(); ++v) {
            const PixelSolver& solver = solvers[variants_[v].situation];
            BEAD_EXPECTS(!solver.loose_node());
            const Displacement u = solver.solve(loads_[v]);
            if (v == 0) work_ = work(loads_[v], u.values);
            all.push_back(smooth(family_stress(u.values)));
        }
        return all;
    }

    std::vector<PlaneTensor> family_stress(std::span<const double> u) {
        std::vector<PlaneTensor> stress = centre_stress(model_, u);
        PixelModel walls = model_;
        for (std::size_t p = 0; p < walls.laws.size(); ++p) walls.laws[p] = fixed_[p] * solid_law_;
        const std::vector<PlaneTensor> in_walls = centre_stress(walls, u);
        for (std::size_t p = 0; p < stress.size(); ++p) stress[p] = stress[p] - in_walls[p];
        return stress;
    }

    std::vector<PlaneTensor> smooth(const std::vector<PlaneTensor>& stress) const {
        const auto component = [&](double PlaneTensor::*which) {
            Field values(stress.size());
            for (std::size_t p = 0; p < values.size(); ++p) values[p] = stress[p].*which;
            return blurred(values, model_.factor, model_.grid, options_.smoothing);
        };
        const Field xx = component(&PlaneTensor::xx), yy = component(&PlaneTensor::yy),
                    xy = component(&PlaneTensor::xy);
        std::vector<PlaneTensor> result(stress.size());
        for (std::size_t p = 0; p < result.size(); ++p) result[p] = {xx[p], yy[p], xy[p]};
        return result;
    }

    // For one variant its principal directions. For several those of Σ σ σ, the first of which is
    // the one that the first variant pulls at more.
    void turn_frame(const std::vector<std::vector<PlaneTensor>>& stress) {
        frame_ = stress.front();
        if (stress.size() == 1) return;
        for (std::size_t p = 0; p < frame_.size(); ++p) {
            PlaneTensor sum;
            for (const std::vector<PlaneTensor>& of : stress) {
                const PlaneTensor s = of[p];
                sum = sum + PlaneTensor{s.xx * s.xx + s.xy * s.xy, s.yy * s.yy + s.xy * s.xy,
                                        s.xy * (s.xx + s.yy)};
            }
            const Vec2 first = unit(principal(sum).angle);
            const double pull = along(frame_[p], first), other = along(frame_[p], left_of(first));
            frame_[p] = pull >= other ? sum : PlaneTensor{} - sum;
        }
    }

    // The highest of the variants, compression counted for less.
    std::array<Field, 2> stresses_along(const std::vector<std::vector<PlaneTensor>>& stress) const {
        std::array<Field, 2> wanted{Field(frame_.size(), 0.0), Field(frame_.size(), 0.0)};
        for (std::size_t p = 0; p < frame_.size(); ++p) {
            const Vec2 first = unit(principal(frame_[p]).angle);
            for (const std::vector<PlaneTensor>& of : stress)
                for (std::size_t f = 0; f < 2; ++f) {
                    const double s = along(of[p], f == 0 ? first : left_of(first));
                    wanted[f][p] = std::max(wanted[f][p], s > 0 ? s : -s / options_.compression);
                }
        }
        return wanted;
    }

    // Where even solid is not enough the load shall spread: wanted stresses grow around it, the
    // longer it stays so the more. Next to loads and supports stress is not judged.
    void widen(std::array<Field, 2>& wanted) {
        for (std::size_t p = 0; p < excess_.size(); ++p) {
            const double now = per_stress_ * std::max(wanted[0][p], wanted[1][p]) / options_.most;
            if (judged_[p] && now > 0)
                excess_[p] = std::clamp(excess_[p] * std::pow(now, persistence), 1.0, most_excess);
        }
        const Field excess =
            blurred(widened(excess_, model_.grid, widening), model_.factor, model_.grid, blending);
        for (Field& of : wanted)
            for (std::size_t p = 0; p < of.size(); ++p) of[p] *= std::max(1.0, excess[p]);
    }

    double bounded(double r) const { return std::clamp(r, options_.least, options_.most); }

    template <class Visit>
    void for_solid(const Visit& visit) const {
        for (std::size_t p = 0; p < model_.factor.size(); ++p)
            if (model_.factor[p] > 0)
                for (std::size_t f = 0; f < 2; ++f) visit(f, p);
    }

    void move_densities(const std::array<Field, 2>& wanted, bool is_first) {
        double stress = 0, now = 0;
        for_solid([&](std::size_t f, std::size_t p) {
            stress += wanted[f][p];
            now += density_[f][p];
        });
        std::array<Field, 2> next = density_;
        for_solid([&](std::size_t f, std::size_t p) {
            const double full = bounded(wanted[f][p] * now / stress);
            next[f][p] = is_first ? full : std::sqrt(density_[f][p] * full);
        });
        const double scale = scale_to_budget(next);
        std::vector<double> ratios;
        for_solid([&](std::size_t f, std::size_t p) {
            density_[f][p] = bounded(scale * next[f][p]);
            if (density_[f][p] > least_counted && density_[f][p] < most_counted * options_.most &&
                wanted[f][p] > 0)
                ratios.push_back(density_[f][p] / wanted[f][p]);
        });
        if (ratios.empty()) return;
        std::ranges::nth_element(ratios, ratios.begin() + static_cast<long>(ratios.size() / 2));
        per_stress_ = ratios[ratios.size() / 2];
    }

    double scale_to_budget(const std::array<Field, 2>& density) const {
        double low = 1e-4, high = 1e4;
        for (int i = 0; i < 60; ++i) {
            const double middle = std::sqrt(low * high);
            double sum = 0;
            for_solid(
                [&](std::size_t f, std::size_t p) { sum += bounded(middle * density[f][p]); });
            (sum > budget_ ? high : low) = middle;
        }
        return low;
    }

    // Nodes take the mean of the solid pixels around; the others that of the nodes near them.
    template <class T>
    Sampled<T> at_nodes(const std::vector<T>& values) const {
        const PixelGrid& grid = model_.grid;
        Sampled<T> field{grid.origin, grid.size, grid.columns + 1, grid.rows + 1, {}};
        field.values.assign(grid.nodes(), T{});
        std::vector<double> weight(grid.nodes(), 0.0);
        for (std::size_t p = 0; p < values.size(); ++p)
            if (model_.factor[p] > 0)
                for (const std::size_t node : grid.corners(p)) {
                    field.values[node] = field.values[node] + values[p];
                    weight[node] += 1;
                }
        for (std::size_t n = 0; n < weight.size(); ++n)
            if (weight[n] > 0) field.values[n] = (1 / weight[n]) * field.values[n];
        spread(field, weight);
        return field;
    }

    template <class T>
    static void spread(Sampled<T>& field, std::vector<double>& weight) {
        constexpr int far = 6;  // nodes
        for (int pass = 0; pass < far; ++pass) {
            const std::vector<double> known = weight;
            const auto at = [&](int i, int j) {
                return static_cast<std::size_t>(j) * static_cast<std::size_t>(field.columns) +
                       static_cast<std::size_t>(i);
            };
            for (int j = 0; j < field.rows; ++j)
                for (int i = 0; i < field.columns; ++i) {
                    if (known[at(i, j)] > 0) continue;
                    T sum{};
                    double count = 0;
                    for (int y = std::max(j - 1, 0); y <= std::min(j + 1, field.rows - 1); ++y)
                        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, field.columns - 1);
                             ++x)
                            if (known[at(x, y)] > 0) {
                                sum = sum + field.values[at(x, y)];
                                count += 1;
                            }
                    if (count <= 0) continue;
                    field.values[at(i, j)] = (1 / count) * sum;
                    weight[at(i, j)] = 1;
                }
        }
    }

    const LoadCase& case_;
    DensityOptions options_;
    std::vector<Variant> variants_;
    PixelModel model_;
    PlaneLaw solid_law_;
    Field fixed_;                       // share of walls and pads
    Field excess_;                      // of stress over what solid bears, remembered; 1: none
    std::vector<std::uint8_t> judged_;  // per pixel
    double cells_ = 0, budget_ = 0;
    std::vector<Held> held_;
    std::vector<PixelVector> loads_;
    std::vector<PlaneTensor> frame_;
    std::array<Field, 2> density_;
    double per_stress_ = 0;  // density per wanted stress, where neither is at its bounds
    double work_ = 0;
};

}  // namespace

double allowed_compression(const SolidMaterial& material) {
    return 1 + 0.5 * std::max(0.0, material.compressive / material.tensile - 1);
}

Densities densities(const LoadCase& load_case, const Layout& fixed, const DensityOptions& options) {
    Iteration iteration(load_case, fixed, options);
    for (int i = 0; i < options.iterations; ++i) iteration.step(i);
    return iteration.result();
}

}  // namespace bead
