#include "fem/pixel_model.h"

#include <algorithm>

#include "core/expects.h"
#include "fem/pixel_element.h"

namespace bead {
namespace {

// Where the horizontal line crosses the boundary, sorted: inside between the first and the second,
// the third and the fourth …
std::vector<double> crossings(const Region& region, double y) {
    std::vector<double> at;
    const auto add = [&](const Polyline& loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            if ((a.y > y) != (b.y > y)) at.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    };
    for (const Polygon& polygon : region) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    std::ranges::sort(at);
    return at;
}

// Adds `share` for each of the row's points, `per_pixel` in every pixel, that lies inside.
void add_row(const std::vector<double>& at, const PixelGrid& grid, int per_pixel, double share,
             std::span<double> row) {
    const double step = grid.size / per_pixel;
    const long count = long(per_pixel) * grid.columns;
    const auto first_right_of = [&](double x) {
        return std::clamp(long(std::ceil((x - grid.origin.x) / step - 0.5)), 0L, count);
    };
    for (std::size_t k = 0; k + 1 < at.size(); k += 2)
        for (long i = first_right_of(at[k]), end = first_right_of(at[k + 1]); i < end; ++i)
            row[std::size_t(i / per_pixel)] += share;
}

std::vector<double> sampled(const Region& region, const PixelGrid& grid, int per_pixel) {
    std::vector<double> share(grid.pixels(), 0.0);
    const double step = grid.size / per_pixel;
    for (int j = 0; j < grid.rows * per_pixel; ++j) {
        const std::vector<double> at = crossings(region, grid.origin.y + (j + 0.5) * step);
        const auto row =
            std::span(share).subspan(grid.pixel(0, j / per_pixel), std::size_t(grid.columns));
        add_row(at, grid, per_pixel, 1.0 / (per_pixel * per_pixel), row);
    }
    return share;
}

double distance_to_pixel(const PixelGrid& grid, std::size_t pixel, Vec2 p) {
    const Vec2 d = p - grid.centre(pixel);
    return std::hypot(std::max(0.0, std::abs(d.x) - grid.size / 2),
                      std::max(0.0, std::abs(d.y) - grid.size / 2));
}

}  // namespace

std::vector<double> rastered(const Region& region, const PixelGrid& grid) {
    return sampled(region, grid, 1);
}

std::vector<double> coverage(const Region& region, const PixelGrid& grid) {
    return sampled(region, grid, 4);
}

std::vector<double> connected(const std::vector<double>& factor, const PixelGrid& grid,
                              std::span<const Vec2> places, double reach) {
    BEAD_EXPECTS(factor.size() == grid.pixels());
    std::vector<double> kept(factor.size(), 0.0);
    std::vector<std::size_t> open;
    const auto visit = [&](std::size_t pixel) {
        if (factor[pixel] == 0 || kept[pixel] != 0) return;
        kept[pixel] = factor[pixel];
        open.push_back(pixel);
    };
    for (const Vec2 place : places)
        for (std::size_t pixel = 0; pixel < factor.size(); ++pixel)
            if (factor[pixel] != 0 && distance_to_pixel(grid, pixel, place) <= reach) visit(pixel);
    const auto columns = std::size_t(grid.columns);
    while (!open.empty()) {
        const std::size_t pixel = open.back();
        open.pop_back();
        if (pixel % columns > 0) visit(pixel - 1);
        if (pixel % columns + 1 < columns) visit(pixel + 1);
        if (pixel >= columns) visit(pixel - columns);
        if (pixel + columns < factor.size()) visit(pixel + columns);
    }
    return kept;
}

PixelVector forces(const PixelModel& model, std::span<const double> displacement) {
    BEAD_EXPECTS(displacement.size() == 2 * model.grid.nodes());
    PixelVector result(displacement.size(), 0.0);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const auto corners = model.grid.corners(pixel);
        const CornerValues f = square_forces(model.thickness * law_of(model, pixel),
                                             corner_values(displacement, corners));
        for (std::size_t c = 0; c < 4; ++c) {
            result[2 * corners[c]] += f[2 * c];
            result[2 * corners[c] + 1] += f[2 * c + 1];
        }
    }
    return result;
}

}  // namespace bead
