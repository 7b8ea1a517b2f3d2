#include "fem/pixel_boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/stretch.h"

namespace bead {
namespace {

// A piece of a stretch that lies in one pixel, as one point of a Gauss rule, and the solid pixel
// that takes its share.
struct Touch {
    Vec2 place;
    double length = 0;  // mm
    std::size_t pixel = 0;
    double x = 0, y = 0;  // in that pixel, [-1, 1]
};

struct Contact {
    std::vector<Touch> touches;
    double missed = 0, length = 0;  // mm
};

std::optional<std::size_t> solid_near(const PixelModel& model, Vec2 p, double reach) {
    const PixelGrid& grid = model.grid;
    const Vec2 at = (p - grid.origin) / grid.size;
    const int ring = int(std::ceil(reach / grid.size)) + 1;
    const int i0 = int(std::floor(at.x)), j0 = int(std::floor(at.y));
    std::optional<std::size_t> best;
    double nearest = reach + 1e-9 * grid.size;
    for (int j = std::max(0, j0 - ring); j <= std::min(grid.rows - 1, j0 + ring); ++j)
        for (int i = std::max(0, i0 - ring); i <= std::min(grid.columns - 1, i0 + ring); ++i) {
            if (model.factor[grid.pixel(i, j)] == 0) continue;
            const double far = grid.size * std::hypot(std::max({0.0, i - at.x, at.x - i - 1}),
                                                      std::max({0.0, j - at.y, at.y - j - 1}));
            if (far >= nearest) continue;
            nearest = far;
            best = grid.pixel(i, j);
        }
    return best;
}

void add_touch(const PixelModel& model, Vec2 p, double piece, double reach, Contact& contact) {
    contact.length += piece;
    const std::optional<std::size_t> pixel = solid_near(model, p, reach);
    if (!pixel) {
        contact.missed += piece;
        return;
    }
    const Vec2 from_centre = 2 / model.grid.size * (p - model.grid.centre(*pixel));
    contact.touches.push_back({p, piece, *pixel, std::clamp(from_centre.x, -1.0, 1.0),
                               std::clamp(from_centre.y, -1.0, 1.0)});
}

// Where the line from a to b crosses lines of the grid, as shares of it, with both ends.
std::vector<double> grid_cuts(const PixelGrid& grid, Vec2 a, Vec2 b) {
    std::vector<double> cuts{0, 1};
    const auto cut = [&](double from, double to, double origin) {
        if (from == to) return;
        const double low = (std::min(from, to) - origin) / grid.size;
        const double high = (std::max(from, to) - origin) / grid.size;
        for (double k = std::ceil(low); k <= high; ++k)
            cuts.push_back(std::clamp((origin + k * grid.size - from) / (to - from), 0.0, 1.0));
    };
    cut(a.x, b.x, grid.origin.x);
    cut(a.y, b.y, grid.origin.y);
    std::ranges::sort(cuts);
    return cuts;
}

Contact contact_of(const PixelModel& model, const std::vector<Polyline>& lines, double reach) {
    Contact contact;
    const double gauss = 0.5 / std::sqrt(3.0);
    for (const Polyline& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const std::vector<double> cuts = grid_cuts(model.grid, line[i], line[i + 1]);
            const double side = distance(line[i], line[i + 1]);
            for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
                const double share = cuts[k + 1] - cuts[k], middle = (cuts[k] + cuts[k + 1]) / 2;
                if (share * side < 1e-12) continue;
                for (const double place : {middle - gauss * share, middle + gauss * share})
                    add_touch(model, lerp(line[i], line[i + 1], place), share * side / 2, reach,
                              contact);
            }
        }
    return contact;
}

std::array<double, 4> shape(const Touch& t) {
    return {(1 - t.x) * (1 - t.y) / 4, (1 + t.x) * (1 - t.y) / 4, (1 + t.x) * (1 + t.y) / 4,
            (1 - t.x) * (1 + t.y) / 4};
}

double reach_of(const PixelModel& model, const PatchOptions& options) {
    return options.reach > 0 ? options.reach : 3 * model.grid.size;
}

void hold(const Support& support, std::size_t node, Held& held) {
    if (support.x) held[2 * node] = 1;
    if (support.y) held[2 * node + 1] = 1;
}

bool hold_point(const PixelModel& model, const Support& support, Vec2 p, double reach, Held& held) {
    const std::optional<std::size_t> pixel = solid_near(model, p, reach);
    if (!pixel) return false;
    const auto corners = model.grid.corners(*pixel);
    hold(support,
         *std::ranges::min_element(
             corners, {}, [&](std::size_t node) { return distance(model.grid.place(node), p); }),
         held);
    return true;
}

bool hold_stretch(const PixelModel& model, const Support& support,
                  const std::vector<Polyline>& lines, double reach, Held& held) {
    const Contact contact = contact_of(model, lines, reach);
    if (contact.length == 0) return hold_point(model, support, lines[0][0], reach, held);
    if (contact.missed > contact.length / 2) return false;
    std::vector<double> share(model.grid.nodes(), 0.0);
    for (const Touch& touch : contact.touches) {
        const auto corners = model.grid.corners(touch.pixel);
        const std::array<double, 4> weight = shape(touch);
        for (std::size_t c = 0; c < 4; ++c) share[corners[c]] += touch.length * weight[c];
    }
    for (std::size_t node = 0; node < share.size(); ++node)
        if (share[node] >= 0.249 * model.grid.size) hold(support, node, held);
    return true;
}

bool add_load(const PixelModel& model, const Load& load, const std::vector<Polyline>& lines,
              double reach, PixelVector& result) {
    const Contact contact = contact_of(model, lines, reach);
    if (contact.missed > contact.length / 2) return false;
    double total = 0;
    for (const Touch& touch : contact.touches) total += touch.length * traction(load, touch.place);
    if (total <= 0) return false;
    for (const Touch& touch : contact.touches) {
        const auto corners = model.grid.corners(touch.pixel);
        const std::array<double, 4> weight = shape(touch);
        const double part = touch.length * traction(load, touch.place) / total;
        for (std::size_t c = 0; c < 4; ++c) {
            result[2 * corners[c]] += part * weight[c] * load.force.x;
            result[2 * corners[c] + 1] += part * weight[c] * load.force.y;
        }
    }
    return true;
}

}  // namespace

std::optional<Held> held_nodes(const PixelModel& model, const Region& part,
                               const std::vector<Support>& supports, const PatchOptions& options) {
    Held held(2 * model.grid.nodes(), 0);
    for (const Support& support : supports) {
        const auto lines = stretch_lines(part, support.on);
        if (!lines || !hold_stretch(model, support, *lines, reach_of(model, options), held))
            return std::nullopt;
    }
    return held;
}

std::optional<PixelVector> load_vector(const PixelModel& model, const Region& part,
                                       const std::vector<Load>& loads,
                                       const PatchOptions& options) {
    PixelVector result(2 * model.grid.nodes(), 0.0);
    for (const Load& load : loads) {
        const auto lines = stretch_lines(part, load.on);
        if (!lines || !add_load(model, load, *lines, reach_of(model, options), result))
            return std::nullopt;
    }
    return result;
}

}  // namespace bead
