#include "fem/pixel_stress.h"

#include "fem/pixel_element.h"

namespace bead {

std::vector<PlaneTensor> centre_stress(const PixelModel& model,
                                       std::span<const double> displacement) {
    std::vector<PlaneTensor> stress(model.factor.size());
    const double scale = 2 / model.grid.size;
    for (std::size_t pixel = 0; pixel < stress.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const CornerValues u = corner_values(displacement, model.grid.corners(pixel));
        stress[pixel] = scale * stress_of(law_of(model, pixel), modes_of(u).centre);
    }
    return stress;
}

PixelVector centre_stress_adjoint(const PixelModel& model, std::span<const PlaneTensor> weight) {
    PixelVector forces(2 * model.grid.nodes(), 0.0);
    constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    const double scale = 1 / (2 * model.grid.size);
    for (std::size_t pixel = 0; pixel < weight.size(); ++pixel) {
        if (model.factor[pixel] == 0 || weight[pixel] == PlaneTensor{}) continue;
        const PlaneTensor w = weight[pixel];
        const PlaneTensor s = scale * stress_of(law_of(model, pixel), {w.xx, w.yy, 2 * w.xy});
        const auto corners = model.grid.corners(pixel);
        for (std::size_t c = 0; c < 4; ++c) {
            forces[2 * corners[c]] += s.xx * x[c] + s.xy * y[c];
            forces[2 * corners[c] + 1] += s.xy * x[c] + s.yy * y[c];
        }
    }
    return forces;
}

std::vector<PlaneTensor> node_stress(const PixelModel& model,
                                     std::span<const double> displacement) {
    std::vector<PlaneTensor> stress(model.grid.nodes());
    std::vector<std::uint8_t> count(stress.size(), 0);
    constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
    const double scale = 2 / model.grid.size;
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const auto corners = model.grid.corners(pixel);
        const SquareModes modes = modes_of(corner_values(displacement, corners));
        const PlaneLaw law = law_of(model, pixel);
        for (std::size_t c = 0; c < 4; ++c) {
            stress[corners[c]] =
                stress[corners[c]] + scale * stress_of(law, strain_at(modes, x[c], y[c]));
            ++count[corners[c]];
        }
    }
    for (std::size_t node = 0; node < stress.size(); ++node)
        if (count[node] > 1) stress[node] = 1.0 / count[node] * stress[node];
    return stress;
}

std::vector<double> pixel_energy(const PixelModel& model, std::span<const double> displacement) {
    std::vector<double> energy(model.factor.size(), 0.0);
    for (std::size_t pixel = 0; pixel < energy.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const CornerValues u = corner_values(displacement, model.grid.corners(pixel));
        const CornerValues f = square_forces(model.thickness * law_of(model, pixel), u);
        for (std::size_t i = 0; i < 8; ++i) energy[pixel] += u[i] * f[i];
    }
    return energy;
}

}  // namespace bead
