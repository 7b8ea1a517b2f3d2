#include "smooth/layer_chains.h"

#include <algorithm>
#include <array>

#include "smooth/dense.h"
#include "smooth/infill_chain.h"
#include "smooth/nesting.h"
#include "smooth/segment_grid.h"
#include "smooth/wall_chain.h"

namespace bead {
namespace {

bool is_wall(Role role) { return role == Role::outer_wall || role == Role::wall; }
// Loops of these are begun anywhere and joined; other roles' strokes stay as they lie.
bool is_infill(Role role) { return role == Role::infill; }

class Builder {
  public:
    Builder(const std::vector<Lane>& lanes, const SmoothOptions& options)
        : lanes_(lanes), options_(options), chain_options_{options.link, 64} {}

    LayerChains built() {
        add_walls();
        add_infill();
        for (std::size_t i = 0; i < lanes_.size(); ++i)
            if (!done_[i]) add_alone(i);
        in_phases();
        return std::move(result_);
    }

  private:
    // How far a curve may lie from the polygon that it is found in, no more than the sagitta of
    // ordinary holes.
    [[nodiscard]] double curve_tolerance(Role role) const {
        const SmoothTolerances& tolerances = options_.tolerances;
        if (role == Role::outer_wall) return std::min(0.05, tolerances.outer_wall);
        if (is_infill(role)) return std::min(0.25, tolerances.infill);
        return std::min(0.10, tolerances.wall);
    }
    DenseLine dense(std::size_t i) {
        DenseOptions dense;
        dense.curves = options_.stages.curves;
        dense.tolerance = curve_tolerance(lanes_[i].role);
        DenseLine line = dense_line(lanes_[i], dense);
        result_.arcs += line.curves;
        if (line.rejected > 0) ++result_.kept;
        return line;
    }
    Ring ring(std::size_t i) {
        DenseLine line = dense(i);
        done_[i] = true;
        return ring_of(std::move(line.points), std::move(line.flows));
    }

    void add(Chain chain) {
        result_.links += static_cast<int>(chain.lanes.size()) - 1;
        result_.chains.push_back(std::move(chain));
    }

    [[nodiscard]] ChainOptions options_from(std::size_t lane) const {
        ChainOptions options = chain_options_;
        const SmoothStages& stages = options_.stages;
        if (!stages.order || !stages.seams) options.seam = lanes_[lane].points.front();
        return options;
    }

    void add_walls() {
        for (std::vector<std::size_t> group : nested_walls(lanes_)) {
            const double first = loop_length(lanes_[group[0]].points);
            if (!options_.stages.chains || first < 4 * options_.link) {
                for (const std::size_t i : group) add(wall_chain({i}, {ring(i)}, options_from(i)));
                continue;
            }
            std::vector<Ring> rings;
            const double turn = signed_area(lanes_[group[0]].points);
            for (const std::size_t i : group) {
                Ring one = ring(i);
                const bool other_way = signed_area(lanes_[i].points) * turn < 0;
                rings.push_back(other_way ? reversed(one) : std::move(one));
            }
            const ChainOptions options = options_from(group[0]);
            add(wall_chain(std::move(group), std::move(rings), options));
        }
    }

    // Four fifths of all places of infill loops that have another loop beside them are at most that
    // far from it.
    [[nodiscard]] double infill_spacing(const std::vector<std::size_t>& loops) const {
        std::vector<SegmentGrid::Line> lines(lanes_.size());
        for (std::size_t i = 0; i < lanes_.size(); ++i)
            if (is_infill(lanes_[i].role)) lines[i] = {lanes_[i].points, lanes_[i].closed};
        const double width = width_of(lanes_[loops[0]]);
        const SegmentGrid grid(lines, 15 * width, 2 * width);
        std::vector<double> apart;
        for (const std::size_t i : loops)
            for (const Vec2 point : lanes_[i].points)
                if (const auto other = grid.nearest_other(point, i)) apart.push_back(*other);
        if (apart.empty()) return 0;
        const auto fifth = static_cast<std::ptrdiff_t>(apart.size() * 4 / 5);
        std::ranges::nth_element(apart, apart.begin() + fifth);
        return apart[static_cast<std::size_t>(fifth)];
    }

    void add_infill() {
        std::vector<std::size_t> loops;
        for (std::size_t i = 0; i < lanes_.size(); ++i)
            if (is_infill(lanes_[i].role) && lanes_[i].closed) loops.push_back(i);
        if (loops.empty() || !options_.stages.chains) return;
        std::vector<SegmentGrid::Line> lines;
        lines.reserve(lanes_.size());
        double widest = 0;
        for (const Lane& lane : lanes_) {
            lines.push_back({lane.points, lane.closed});
            widest = std::max(widest, width_of(lane));
        }
        const SegmentGrid grid(lines, 0.9 * widest, 2 * widest);
        const InfillSurroundings surroundings{infill_spacing(loops), grid, 0.9 * widest};
        std::vector<InfillRing> rings;
        rings.reserve(loops.size());
        for (const std::size_t i : loops) rings.push_back({i, ring(i)});
        for (Chain& chain : infill_chains(std::move(rings), surroundings, chain_options_))
            add(std::move(chain));
    }

    void add_alone(std::size_t i) {
        const Lane& lane = lanes_[i];
        if (lane.closed) return add(wall_chain({i}, {ring(i)}, options_from(i)));
        if (!lane.level) {
            ++result_.kept;
            return add(line_chain(i, {lane.points, lane.flows}, false));
        }
        DenseLine line = dense(i);
        const bool reversible = lane.role != Role::top_skin;
        add(line_chain(i, {std::move(line.points), std::move(line.flows)}, reversible));
    }

    void in_phases() {
        std::array<int, role_names.size()> phase_of{};
        phase_of.fill(-1);
        int phases = 0;
        for (const Lane& lane : lanes_) {
            const Role role = is_wall(lane.role) ? Role::wall : lane.role;
            int& phase = phase_of[static_cast<std::size_t>(role)];
            if (phase < 0) phase = phases++;
        }
        const auto phase = [&](const Chain& chain) {
            if (!options_.stages.order) return 0;
            const Role role = lanes_[chain.lanes[0]].role;
            return phase_of[static_cast<std::size_t>(is_wall(role) ? Role::wall : role)];
        };
        const auto key = [&](const Chain& chain) {
            return std::pair(phase(chain), *std::ranges::min_element(chain.lanes));
        };
        std::ranges::stable_sort(result_.chains, {}, key);
        for (const Chain& chain : result_.chains) result_.phases.push_back(phase(chain));
    }

    const std::vector<Lane>& lanes_;
    const SmoothOptions& options_;
    ChainOptions chain_options_;
    std::vector<bool> done_ = std::vector<bool>(lanes_.size(), false);
    LayerChains result_;
};

}  // namespace

LayerChains layer_chains(const std::vector<Lane>& lanes, const SmoothOptions& options) {
    return Builder(lanes, options).built();
}

}  // namespace bead
