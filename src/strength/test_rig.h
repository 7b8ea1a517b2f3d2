// Printed layers set up for their test: rastered to pixels, cut loose from what hangs on nothing,
// held by the case's supports, the stiffness factored once per situation.
//
//     const std::optional<TestRig> rig = TestRig::of(layers, load_case, {.pixel = 0.1});
//     const Tested tested = rig->tested(0);          // under the first variant's loads
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "fem/buckling.h"
#include "fem/pixel_solver.h"
#include "strength/load_variants.h"
#include "toolpath/path.h"

namespace bead {

struct RigOptions {
    double pixel = 0.1;      // mm
    double averaging = 0.6;  // mm, radius within which the failure index is averaged
    double excluded = 4;  // mm around loads and supports that are not judged; less in small parts
};

struct Tested {
    std::vector<double> displacement;
    double work = 0;            // N mm, loads times displacements
    std::vector<double> index;  // per pixel, averaged; what is not judged is 0
    std::size_t weakest = 0;    // pixel of the largest
    [[nodiscard]] double factor() const {
        return 1 / index[weakest];
    }  // of the load, first failure
};

class TestRig {
  public:
    // Layers that differ count by their share of the height, as if glued to each other. Nothing if
    // the print does not reach a load or support, or does not hang together.
    static std::optional<TestRig> of(std::span<const Toolpath> layers, const LoadCase& load_case,
                                     const RigOptions& options);

    [[nodiscard]] const std::vector<Variant>& variants() const { return variants_; }
    [[nodiscard]] const PixelModel& model() const { return solvers_.front().model(); }
    [[nodiscard]] const PixelSolver& solver(std::size_t variant) const {
        return solvers_[variants_[variant].situation];
    }
    [[nodiscard]] const PixelVector& load(std::size_t variant) const { return loads_[variant]; }
    [[nodiscard]] const SolidMaterial& material() const { return material_; }
    [[nodiscard]] double averaging() const { return options_.averaging; }  // mm
    // Per pixel: whether it counts for the first failure.
    [[nodiscard]] const std::vector<std::uint8_t>& is_judged() const { return judged_; }

    [[nodiscard]] Tested tested(std::size_t variant) const;
    [[nodiscard]] Tested judged(const PixelModel& model, std::vector<double> displacement,
                                std::size_t variant) const;
    [[nodiscard]] std::vector<BucklingMode> modes(std::size_t variant,
                                                  std::span<const double> displacement,
                                                  const BucklingOptions& options) const;

  private:
    TestRig() = default;
    SolidMaterial material_;
    RigOptions options_;
    std::vector<Variant> variants_;
    std::vector<PixelSolver> solvers_;  // one per situation
    std::vector<PixelVector> loads_;    // one per variant
    std::vector<std::uint8_t> judged_;
};

}  // namespace bead
