// Small sheets of pixels for tests.
#pragma once
#include <cstdint>
#include <random>

#include "fem/pixel_model.h"

namespace bead::test {

// A full rectangle; lower left at `origin`.
inline PixelModel sheet(int columns, int rows, double size = 1, Vec2 origin = {}) {
    PixelModel model;
    model.grid = {origin, size, columns, rows};
    model.thickness = 2;
    model.law = isotropic(2200, 0.35);
    model.factor.assign(model.grid.pixels(), 1.0);
    return model;
}

// Some pixels missing, others of other stiffness; all that is left hangs together.
inline PixelModel random_sheet(int columns, int rows, unsigned seed) {
    PixelModel model = sheet(columns, rows, 0.5);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (double& factor : model.factor) factor = uniform(random) < 0.25 ? 0 : 0.5 + uniform(random);
    const Vec2 first[]{model.grid.centre(0)};
    model.factor[0] = 1;
    for (int i = 0; i < columns; ++i) model.factor[model.grid.pixel(i, 0)] = 1;
    for (int j = 0; j < rows; ++j) model.factor[model.grid.pixel(0, j)] = 1;
    model.factor = connected(model.factor, model.grid, first, 0.1);
    return model;
}

inline Held left_side_held(const PixelGrid& grid) {
    Held held(2 * grid.nodes(), 0);
    for (int j = 0; j <= grid.rows; ++j)
        for (const std::size_t c : {0U, 1U}) held[2 * grid.node(0, j) + c] = 1;
    return held;
}

inline PixelVector random_vector(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    PixelVector values(count);
    for (double& value : values) value = uniform(random);
    return values;
}

// Loads only where something is.
inline PixelVector random_load(const PixelModel& model, unsigned seed) {
    PixelVector load = random_vector(2 * model.grid.nodes(), seed);
    std::vector<std::uint8_t> solid(model.grid.nodes(), 0);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel)
        if (model.factor[pixel] != 0)
            for (const std::size_t node : model.grid.corners(pixel)) solid[node] = 1;
    for (std::size_t i = 0; i < load.size(); ++i)
        if (solid[i / 2] == 0) load[i] = 0;
    return load;
}

inline double product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

inline double size_of(const std::vector<double>& a) { return std::sqrt(product(a, a)); }

inline double gap(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

}  // namespace bead::test
