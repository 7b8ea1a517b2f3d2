#include "study/layer_cost.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>

namespace bead {
namespace {

// Fowler, Noll and Vo's hash (FNV-1a, 64 bit) over the bits of numbers.
struct Hash {
    std::uint64_t value = 14695981039346656037U;
    void add(std::uint64_t bits) { value = (value ^ bits) * 1099511628211U; }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const Polyline& line) {
        add(static_cast<std::uint64_t>(line.size()));
        for (const Vec2 p : line) {
            add(p.x);
            add(p.y);
        }
    }
    void add(const Polygon& polygon) {
        add(polygon.outer);
        for (const Polyline& hole : polygon.holes) add(hole);
    }
};

std::uint64_t hash_of(const LayerParts& layer) {
    Hash hash;
    hash.add(
        static_cast<std::uint64_t>(layer.index == 0));  // the first layer is printed differently
    hash.add(layer.height);
    hash.add(layer.bead.width);
    for (const Island& island : layer.islands) {
        hash.add(island.outline);
        for (const FillArea& area : island.fills) {
            hash.add(static_cast<std::uint64_t>(area.role));
            hash.add(static_cast<std::uint64_t>(area.on_infill));
            hash.add(static_cast<std::uint64_t>(area.patterned));
            for (const Polygon& polygon : area.material) hash.add(polygon);
        }
    }
    return hash.value;
}

bool has_fill(const LayerParts& layer, bool sparse) {
    for (const Island& island : layer.islands)
        for (const FillArea& area : island.fills)
            if ((area.role == Role::infill) == sparse && !area.centre.empty()) return true;
    return false;
}

// Everything warm, the nozzle in the middle of the bed just below the layer.
Nozzle warm_start(Judge& judge, const LayerParts& layer, const Jury& jury) {
    std::vector<Command> start;
    Nozzle nozzle;
    append_start(start, nozzle, jury.program);
    if (layer.index > 0) start.push_back({SetFan{jury.program.fan}});
    const Vec2 middle = middle_of_bed(jury.machine.printer);
    nozzle.at = {middle.x, middle.y, layer.z - layer.height, 0};
    SetPosition here;
    for (std::size_t i = 0; i < nozzle.at.size(); ++i) here.to[i] = nozzle.at[i];
    start.push_back({here});
    for (const Command& command : start) judge.add(command);
    return nozzle;
}

// What the layer's sparse infill should weigh, over what it weighs; 0 if it has none but should.
double infill_due(const LayerParts& layer, const Toolpath& path, const PlanOptions& plan) {
    const double asked = asked_volumes({&layer, 1}, plan).infill;
    const double laid = deposited_volumes(path).infill;
    if (asked <= 0) return 1;
    return laid > 0 ? asked / laid : 0;
}

// A pattern that lays much too much or too little on a layer (rings in a narrow one) does not suit
// it, however cheap: it is taken only where nothing suits.
constexpr double least_due = 0.8, most_due = 1.25, unsuited = 10;

// The layer with the way back to where it began: the next one begins near there.
Toolpath with_return(Toolpath path) {
    if (path.empty() || path.back().points.empty() || path.front().points.empty()) return path;
    const Vec3 begin = path.front().points.back(), end = path.back().points.back();
    path.push_back({Role::travel, {}, path.front().speed, 0, true, {end, begin}});
    return path;
}

}  // namespace

double layer_cost(const LayerParts& layer, const FillChoice& choice, const Jury& jury) {
    Judge judge(jury.machine);
    Nozzle nozzle = warm_start(judge, layer, jury);
    const Toolpath path =
        plan_layer(layer, choice, jury.lines, jury.plan, {nozzle.at[axis_x], nozzle.at[axis_y]});
    std::vector<Command> commands;
    append_layer(commands, with_return(path), layer.z, layer.height, layer.index, nozzle,
                 jury.program);
    for (const Command& command : commands) judge.add(command);
    const Assessment cost = judge.finish();
    const double due = infill_due(layer, path, jury.plan);
    const double value = value_of(jury.goal, cost);
    if (due < least_due || due > most_due) return unsuited * value;
    const double of_infill = cost.motion.by_role[static_cast<std::size_t>(Role::infill)];
    const double share = cost.motion.duration > 0 ? of_infill / cost.motion.duration : 0;
    return value * (1 + share * (due - 1));
}

std::vector<LayerClass> alike_layers(std::span<const LayerParts> parts) {
    std::vector<LayerClass> classes;
    std::map<std::uint64_t, std::size_t> known;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto [place, is_new] = known.try_emplace(hash_of(parts[i]), classes.size());
        if (is_new) classes.push_back({i, {}});
        classes[place->second].members.push_back(i);
    }
    return classes;
}

bool has_direction(const LayerParts& layer, const NamedPattern& pattern) {
    return has_fill(layer, false) || (pattern.has_direction && has_fill(layer, true));
}

bool is_distinct(const LayerParts& layer, const FillChoice& choice, const NamedPattern& first) {
    const bool sparse = has_fill(layer, true), solid = has_fill(layer, false);
    if (!sparse && choice.pattern.name != first.name) return false;
    if (!sparse && !solid) return choice.angle == 0;
    return solid || choice.angle < choice.pattern.symmetry - 1e-9;
}

}  // namespace bead
