#include "study/layer_cost.h"

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
    nozzle.at = {jury.machine.printer.bed[0] / 2, jury.machine.printer.bed[1] / 2,
                 layer.z - layer.height, 0};
    SetPosition here;
    for (std::size_t i = 0; i < nozzle.at.size(); ++i) here.to[i] = nozzle.at[i];
    start.push_back({here});
    for (const Command& command : start) judge.add(command);
    return nozzle;
}

}  // namespace

LayerCost layer_cost(const LayerParts& layer, const FillChoice& choice, const Jury& jury) {
    Judge judge(jury.machine);
    Nozzle nozzle = warm_start(judge, layer, jury);
    const Toolpath path =
        plan_layer(layer, choice, jury.lines, jury.plan, {nozzle.at[axis_x], nozzle.at[axis_y]});
    std::vector<Command> commands;
    append_layer(commands, path, layer.z, layer.height, layer.index, nozzle, jury.program);
    for (const Command& command : commands) judge.add(command);
    const Assessment cost = judge.finish();
    return {value_of(jury.goal, cost), cost.motion.extruded};
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

bool is_distinct(const LayerParts& layer, const FillChoice& choice) {
    const bool sparse = has_fill(layer, true), solid = has_fill(layer, false);
    if (!sparse && choice.pattern.name != patterns[0].name) return false;
    if (!sparse && !solid) return choice.angle == 0;
    return solid || choice.angle < choice.pattern.symmetry - 1e-9;
}

}  // namespace bead
