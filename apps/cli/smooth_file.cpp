#include "smooth_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "gcode/layer_plan.h"
#include "gcode/motion_text.h"
#include "smooth/travel_kind.h"
#include "vibration/piece.h"
#include "vibration/timed.h"

namespace bead::cli {
namespace {

constexpr std::size_t most_layers = 64, most_moves = 200'000;  // read before they are smoothed
constexpr double same_volume = 0.003;                          // part
constexpr double most_turned = 10;                             // mm, of travel
constexpr const char* slower = "would take longer";
constexpr double most_beyond = 2;  // mm, outside the layer's old box

struct Item {
    FileLayer layer;
    LayerPlan plan;
    MotionStyle style;  // as of this layer
    std::int64_t bytes = 0;
    bool last = false;
    Vec2 start;  // where the file's nozzle is before the layer's first bead is headed for
    std::string reason;
    Toolpath before;
    SmoothedLayer after;
    double before_time = 0, after_time = 0;  // s, by the law
};

MotionState state_of(const LayerPlan::Place& place) {
    return {place.at, place.pulled_back, place.feed, place.acceleration};
}
Vec2 flat(const Position& at) { return {at[axis_x], at[axis_y]}; }

double deposited(const Toolpath& layer) {
    double sum = 0;
    for (const Path& path : layer) sum += volume(path);
    return sum;
}

struct Bounds {
    double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    void add(Vec3 p) {
        x0 = std::min(x0, p.x), y0 = std::min(y0, p.y);
        x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
    }
};
Bounds bounds_of(const Toolpath& layer) {
    Bounds bounds;
    for (const Path& path : layer)
        for (const Vec3& point : path.points) bounds.add(point);
    return bounds;
}
// Beads keep to the layer; travel may turn outside it.
bool is_within(const Toolpath& layer, const Bounds& old, const Bounds& with_way) {
    const auto holds = [](const Bounds& b, double margin, const Path& path) {
        return std::ranges::all_of(path.points, [&](Vec3 p) {
            return p.x > b.x0 - margin && p.x < b.x1 + margin && p.y > b.y0 - margin &&
                   p.y < b.y1 + margin;
        });
    };
    return std::ranges::all_of(layer, [&](const Path& path) {
        return path.role == Role::travel ? holds(with_way, most_turned, path)
                                         : holds(old, most_beyond, path);
    });
}

Path way_to(const Toolpath& layer, Vec2 from, double speed) {
    const Vec3 to = layer.front().points.front();
    return {Role::travel, {}, speed, 0, false, {{from.x, from.y, to.z}, to}};
}

Toolpath::const_iterator first_bead(const Toolpath& layer) {
    return std::ranges::find_if(layer, [](const Path& path) { return path.role != Role::travel; });
}

// Whether filament is pulled back on the way to the layer's first bead.
bool comes_retracted(const Toolpath& layer) {
    return std::any_of(layer.begin(), first_bead(layer),
                       [](const Path& path) { return path.retracted; });
}

// How a layer is come to: from where the nozzle really is, as the file does.
struct Coming {
    Vec2 from;
    double speed = 0;  // mm/s
    bool retracted = false;
};

Toolpath from_place(Toolpath layer, const Coming& coming) {
    const bool retracted = coming.retracted || comes_retracted(layer);
    layer.erase(layer.begin(), first_bead(layer));
    if (layer.empty()) return layer;
    Path way = way_to(layer, coming.from, coming.speed);
    way.retracted = retracted;
    if (distance(coming.from, bead::flat(layer.front().points.front())) > 1e-3)
        layer.insert(layer.begin(), std::move(way));
    return layer;
}

class Smoother {
  public:
    Smoother(std::ostream& out, const SmoothFileOptions& options, const LayerPairs& watch)
        : out_(out), options_(options), watch_(watch) {}

    SmoothedFile run(const TextSource& source) {
        LayerReader reader(source, options_.read);
        LayerPlanner planner(options_.filament);
        std::optional<FileLayer> next = reader.next();
        while (next) {
            std::vector<Item> batch;
            std::size_t moves = 0;
            while (next && batch.size() < most_layers && moves < most_moves) {
                moves += next->moves.size();
                Item item;
                item.layer = std::move(*next);
                item.plan = planner.plan(item.layer);
                item.style = planner.style();
                next = reader.next();
                item.bytes = reader.bytes();
                item.last = !next;
                batch.push_back(std::move(item));
            }
            smooth(batch);
            write(batch);
        }
        result_.file = reader.finish();
        return std::move(result_);
    }

  private:
    void smooth(std::vector<Item>& batch) {
        for (Item& item : batch) {
            item.start = item.plan.head_free ? there_ : flat(item.plan.head.at);
            if (has_body(item))
                there_ = flat(item.plan.tail_free ? item.plan.tail.at : item.plan.after.at);
            else
                there_ = flat(item.plan.after.at);
        }
        parallel_for(batch.size(), options_.threads, [&](std::size_t i) { smooth(batch[i]); });
    }

    [[nodiscard]] static bool has_body(const Item& item) {
        return item.plan.head_end < item.layer.lines.size() && !item.plan.whole.empty();
    }

    void smooth(Item& item) const {
        item.reason = item.plan.obstacle;
        if (!has_body(item)) return;
        item.before = from_place(item.plan.body.empty() ? item.plan.whole : item.plan.body,
                                 coming(item, item.start));
        item.before_time = time_of(item, item.before);
        if (!item.reason.empty()) return;
        SmoothOptions options = options_.smooth;
        options.start = item.start;
        options.retraction = retraction_way(speed_of(item), options_.firmware, item.style);
        // Nobody says what these beads are: they keep their order.
        const bool named = std::ranges::any_of(item.plan.body, [](const Path& path) {
            return path.role != Role::travel && path.role != Role::other;
        });
        if (!named) options.stages.order = options.stages.chains = false;
        const double printed_before = printed_in(item, item.before);
        const auto smooth_by = [&](const SmoothStages& stages) {
            options.stages = stages;
            item.after = smoothed(item.plan.body, options);
            item.reason = fault_of(item, printed_before);
        };
        SmoothStages stages = options.stages;
        smooth_by(stages);
        // Islands are printed one by one in the file, walls before infill in all of them by us; the
        // links of short loops are most of their length.
        if (item.reason == slower && (stages.order || stages.chains)) {
            stages.order = stages.chains = false;
            smooth_by(stages);
        }
        if (!item.reason.empty()) item.after = {};
    }

    // Why it must not be taken; empty if it may. Tells how long it takes by the law.
    std::string fault_of(Item& item, double printed_before) const {
        const double was = deposited(item.plan.body), is = deposited(item.after.path);
        if (!(std::abs(is - was) <= same_volume * was)) return "volume would change";
        const Bounds old = bounds_of(item.plan.body);
        Bounds with_way = old;
        with_way.add({item.start.x, item.start.y, 0});
        if (!is_within(item.after.path, old, with_way)) return "would lead out of the layer";
        const Toolpath path = from_place(item.after.path, coming(item, item.start));
        item.after_time = time_of(item, path);
        return printed_in(item, path) > printed_before ? slower : "";
    }

    static Coming coming(const Item& item, Vec2 from) {
        const bool retracted = item.plan.before.pulled_back > 0 || comes_retracted(item.plan.whole);
        return {from, speed_of(item), retracted};
    }

    static double speed_of(const Item& item) { return usual_pace(item.plan.whole).speed; }

    double printed_in(const Item& item, const Toolpath& layer) const {
        return firmware_time(layer, options_.firmware, item.style);
    }

    double time_of(const Item& item, const Toolpath& layer) const {
        double sum = 0;
        timed(pieces_of(layer, speed_of(item)), options_.law,
              [&](const MotionSegment& segment) { sum += segment.duration; });
        return sum;
    }

    void write(std::vector<Item>& batch) {
        std::vector<LayerPair> pairs;
        for (Item& item : batch) {
            LayerPair pair;
            pair.index = result_.layers;
            pair.z = item.plan.z;
            pair.bytes = item.bytes;
            write(item, pair);
            if (!has_body(item)) continue;
            ++result_.layers;
            pairs.push_back(std::move(pair));
        }
        if (watch_) watch_(pairs);
    }

    void write(Item& item, LayerPair& pair) {
        if (!has_body(item)) return write_as_it_was(item);
        pair.before = std::move(item.before);
        pair.before_time = item.before_time;
        pair.after_time = item.after_time;
        if (!item.reason.empty()) {
            ++result_.left[item.reason];
            pair.after = pair.before;
            pair.after_time = pair.before_time;
            write_as_it_was(item);
        } else {
            pair.smoothed = true;
            write_smoothed(item, pair);
            count(item.after);
        }
    }

    void count(const SmoothedLayer& after) {
        ++result_.smoothed;
        result_.chains += after.chains;
        result_.links += after.links;
        result_.arcs += after.arcs;
        result_.blends += after.blends;
        result_.kept += after.kept;
    }

    void write_as_it_was(const Item& item) {
        const bool moves = std::ranges::any_of(item.layer.lines, [](const FileLine& line) {
            return line.use != LineUse::remark && line.use != LineUse::aside;
        });
        if (moves) restore(item, state_of(item.plan.before));
        out_ << item.layer.text;
        if (moves) ours_ = state_of(item.plan.after), away_ = false;
    }

    void restore(const Item& item, const MotionState& to) {
        if (!away_) return;
        MotionText text(item.style, ours_);
        text.restore(to);
        out_ << text.text();
        ours_ = to;
        away_ = false;
    }

    // Lines that are not motion, in their order.
    void write_rest(const Item& item, std::size_t from, std::size_t to, bool within) {
        for (std::size_t i = from; i < to; ++i) {
            const LineUse use = item.layer.lines[i].use;
            const bool stays = use == LineUse::remark || use == LineUse::aside ||
                               (!within && (use == LineUse::fan || use == LineUse::limits));
            const std::string_view text = text_of(item.layer, i);
            const bool empty =
                within && text.find_first_not_of(" \t\r\n") == std::string_view::npos;
            if (stays && !empty && !(within && text.find("HEIGHT:") != std::string_view::npos))
                out_ << text;
        }
    }
    void write_text(const Item& item, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) out_ << text_of(item.layer, i);
    }

    void write_smoothed(Item& item, LayerPair& pair) {
        const LayerPlan& plan = item.plan;
        const std::size_t count = item.layer.lines.size();
        if (plan.head_free) {
            write_rest(item, 0, plan.head_end, false);
        } else {
            restore(item, state_of(plan.before));
            write_text(item, 0, plan.head_end);
            ours_ = state_of(plan.head);
        }
        ours_.acceleration = plan.head.acceleration;
        write_rest(item, plan.head_end, plan.tail_begin, true);
        pair.after = from_place(item.after.path, coming(item, flat(ours_.at)));
        write_motion(item, pair.after);
        if (plan.tail_free && !item.last) {
            write_rest(item, plan.tail_begin, count, false);
            ours_.acceleration = plan.after.acceleration;
        } else {
            restore(item, state_of(plan.tail));
            write_text(item, plan.tail_begin, count);
            ours_ = state_of(plan.after);
        }
    }

    void write_motion(const Item& item, const Toolpath& layer) {
        MotionText text(item.style, ours_);
        text.fit_arcs(options_.arc_tolerance);
        text.follow(layer, item.plan.z);
        text.ask(item.plan.tail.acceleration);
        out_ << text.text();
        ours_ = text.state();
        away_ = true;
        result_.filament_after += text.filament();
    }

    std::ostream& out_;
    const SmoothFileOptions& options_;
    const LayerPairs& watch_;
    SmoothedFile result_;
    MotionState ours_;   // where the written text leads
    bool away_ = false;  // that is elsewhere than the file is
    Vec2 there_;         // where the file's beads ended
};

}  // namespace

SmoothedFile smooth_file(const TextSource& source, std::ostream& out,
                         const SmoothFileOptions& options, const LayerPairs& watch) {
    return Smoother(out, options, watch).run(source);
}

}  // namespace bead::cli
