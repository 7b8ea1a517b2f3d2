#include "plan/parts.h"

#include "core/parallel.h"
#include "geom/clip.h"
#include "plan/skin.h"
#include "plan/skirt.h"
#include "plan/walls.h"

namespace bead {
namespace {

constexpr double narrowest_solid = 0.5;  // of a bead's width

// Everything of the layer but its fills, and what is to be filled.
struct Shell {
    LayerParts parts;
    Region material;
};

Shell shell_of(const Layer& layer, int index, const PlanOptions& options) {
    const double width = index == 0 ? options.first_layer_width : options.bead_width;
    Shell shell{{layer.z, layer.height, index, {width, layer.height}, {}, {}, {}}, {}};
    for (const Polygon& polygon : layer.region) {
        Walled inside = walled(polygon, shell.parts.bead, options.walls);
        shell.parts.islands.push_back({polygon, std::move(inside.loops), {}});
        for (Polygon& piece : inside.material) shell.material.push_back(std::move(piece));
    }
    if (index == 0) shell.parts.skirt = skirt_round(layer.region, shell.parts.bead, options);
    return shell;
}

// What the next `count` layers (`above`) or the previous ones have in common; nothing where there
// are fewer.
class Covers {
  public:
    Covers(const std::vector<Region>& outlines, int count, int threads) : count_(count) {
        if (count > 0) runs_ = running_intersections(outlines, count, threads);
    }
    [[nodiscard]] Region above(const Region& material, int index) const {
        return part_under(material, index + 1);
    }
    [[nodiscard]] Region below(const Region& material, int index) const {
        return part_under(material, index - count_);
    }

  private:
    [[nodiscard]] Region part_under(const Region& material, int run) const {
        if (count_ == 0) return material;
        if (run < 0 || run >= static_cast<int>(runs_.size())) return {};
        return common_part(material, runs_[static_cast<std::size_t>(run)]);
    }

    int count_ = 0;
    std::vector<Region> runs_;
};

Island& island_of(std::vector<Island>& islands, const Polygon& piece) {
    if (islands.size() == 1) return islands.front();
    const Vec2 point = piece.outer.front();
    for (Island& island : islands) {
        const Box2 box = bounds(island.outline.outer);
        if (point.x < box.low.x || point.x > box.high.x || point.y < box.low.y ||
            point.y > box.high.y)
            continue;
        if (contains({island.outline}, point)) return island;
    }
    return islands.front();
}

// Skin that is to be printed in one way.
struct Skin {
    Role role = Role::skin;
    Bead bead;
    bool on_infill = false, patterned = false;
};

void add_area(std::vector<Island>& islands, const Skin& skin, const Polygon& piece, double inset) {
    Region centre = offset({piece}, -inset);
    if (!centre.empty())
        island_of(islands, piece)
            .fills.push_back(
                {skin.role, {piece}, std::move(centre), skin.bead, skin.on_infill, skin.patterned});
}

// Where a bead fits its line keeps half a spacing from the edge, where it is too narrow a quarter.
void add_solid(std::vector<Island>& islands, const Skin& skin, const Region& region) {
    const double half = spacing(skin.bead) / 2;
    const Region wide = opened(region, half);
    for (const Polygon& piece : wide) add_area(islands, skin, piece, half);
    for (const Polygon& piece : opened(without(region, wide), half / 2))
        add_area(islands, skin, piece, half / 2);
}

// Crumbs that no line fits into are left empty.
void add_sparse(std::vector<Island>& islands, const Region& region, const Bead& bead,
                double overlap) {
    const double inwards = (0.5 - overlap) * bead.width;
    for (const Polygon& piece : region) {
        const Region centre = offset({piece}, -inwards);
        if (centre.empty()) continue;
        std::vector<FillArea>& fills = island_of(islands, piece).fills;
        if (fills.empty()) fills.push_back({Role::infill, {}, {}, bead});
        fills.back().material.push_back(piece);
        fills.back().centre.insert(fills.back().centre.end(), centre.begin(), centre.end());
    }
}

Split split_of(const Shell& shell, const Covers& upper, const Covers& lower, const Region& above,
               const PlanOptions& options) {
    const int index = shell.parts.index;
    const Region covered =
        options.density >= 1 ? Region{} : lower.below(upper.above(shell.material, index), index);
    return split(shell.material, covered, above, narrowest_solid * shell.parts.bead.width);
}

// The first layer has one bead for all.
Bead skin_bead(const LayerParts& layer, double width) {
    return layer.index == 0 || width <= 0 ? layer.bead : Bead{width, layer.height};
}

bool tells_over_infill(const PlanOptions& options) {
    return options.speeds.over_infill > 0 || options.over_infill_width > 0 ||
           options.over_infill_acceleration > 0;
}

// What lies below a layer; empty regions below the first.
struct Below {
    Region outline, sparse;
};

// The part of `from` that also lies in `in` and what is left of it, both without slivers.
std::pair<Region, Region> parted(const Region& from, const Region& in, double narrowest) {
    Region common = without_slivers(common_part(from, in), narrowest);
    Region rest = without_slivers(without(from, common), narrowest);
    return {std::move(common), std::move(rest)};
}

// Skin that is not seen from above. What differs in nothing that is asked for stays in one piece.
void add_skin(Shell& shell, Region skin, const Below& below, const PlanOptions& options) {
    std::vector<Island>& islands = shell.parts.islands;
    const Bead& bead = shell.parts.bead;
    const double narrowest = narrowest_solid * bead.width;
    if (tells_over_infill(options)) {
        auto [bridge, other] = parted(skin, below.sparse, narrowest);
        const Bead thread = skin_bead(shell.parts, options.over_infill_width);
        add_solid(islands, {Role::skin, thread, true}, bridge);
        skin = std::move(other);
    }
    if (options.pattern_on_bottom) {
        auto [inner, bottom] = parted(skin, below.outline, narrowest);
        add_solid(islands, {Role::skin, bead, false, true}, bottom);
        skin = std::move(inner);
    }
    add_solid(islands, {Role::skin, bead}, skin);
}

void add_fills(Shell& shell, const Split& fills, const Below& below, const PlanOptions& options) {
    std::vector<Island>& islands = shell.parts.islands;
    if (options.density > 0 && options.density < 1)
        add_sparse(islands, fills.sparse, shell.parts.bead,
                   options.walls > 0 ? options.infill_overlap : 0);
    add_skin(shell, fills.skin, below, options);
    const Bead top = skin_bead(shell.parts, options.top_skin_width);
    add_solid(islands, {Role::top_skin, top}, fills.top);
}

Vec2 centre_of(std::span<const Layer> layers) {
    Box2 box;
    for (const Layer& layer : layers) box.include(bounds(layer.region));
    return box.is_empty() ? Vec2{} : box.centre();
}

}  // namespace

std::vector<LayerParts> parts_of(std::span<const Layer> layers, const PlanOptions& options) {
    std::vector<Shell> shells(layers.size());
    parallel_for(layers.size(), options.threads, [&](std::size_t i) {
        shells[i] = shell_of(layers[i], static_cast<int>(i), options);
    });
    std::vector<Region> outlines;
    for (const Layer& layer : layers) outlines.push_back(layer.region);
    const Covers upper(outlines, options.top_layers, options.threads);
    const Covers lower = options.bottom_layers == options.top_layers
                             ? upper
                             : Covers(outlines, options.bottom_layers, options.threads);
    outlines.emplace_back();  // above the last
    std::vector<Split> fills(layers.size());
    parallel_for(layers.size(), options.threads, [&](std::size_t i) {
        fills[i] = split_of(shells[i], upper, lower, outlines[i + 1], options);
    });
    parallel_for(layers.size(), options.threads, [&](std::size_t i) {
        const Below below = i > 0 ? Below{outlines[i - 1], fills[i - 1].sparse} : Below{};
        add_fills(shells[i], fills[i], below, options);
    });
    std::vector<LayerParts> parts;
    for (Shell& shell : shells) {
        shell.parts.centre = centre_of(layers);
        parts.push_back(std::move(shell.parts));
    }
    return parts;
}

LayerParts moved(LayerParts parts, double angle, Vec2 about, Vec2 shift) {
    const auto move_line = [&](Polyline& line) {
        line = moved(std::move(line), angle, about, shift);
    };
    const auto move_region = [&](Region& region) {
        region = moved(std::move(region), angle, about, shift);
    };
    for (Island& island : parts.islands) {
        island.outline = moved({island.outline}, angle, about, shift).front();
        for (WallLoop& wall : island.walls) move_line(wall.points);
        for (FillArea& area : island.fills) {
            move_region(area.material);
            move_region(area.centre);
        }
    }
    for (Polyline& loop : parts.skirt) move_line(loop);
    parts.centre = rotated(parts.centre - about, unit(angle)) + about + shift;
    return parts;
}

}  // namespace bead
