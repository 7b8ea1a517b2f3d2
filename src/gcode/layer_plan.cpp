#include "gcode/layer_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace bead {
namespace {

constexpr double hair = 1e-6;         // mm
constexpr double same_flow = 0.04;    // part by which a path's cross-section may vary
constexpr double e_rounding = 1e-5;   // mm, of filament as files say it
constexpr double usual_height = 0.2;  // mm

Vec3 place_of(const Position& p) { return {p[axis_x], p[axis_y], p[axis_z]}; }

bool goes_on(const Path& path, const Path& next) {
    const auto is_wall = [](Role role) { return role == Role::outer_wall || role == Role::wall; };
    return is_wall(path.role) && is_wall(next.role) &&
           length(path.points.back() - next.points.front()) < hair;
}

// Slicers call the part of an outer wall that overhangs a wall by another name: it is the same
// loop.
void name_overhangs(Toolpath& layer) {
    for (std::size_t first = 0, end = 0; first < layer.size(); first = end) {
        end = first + 1;
        while (end < layer.size() && goes_on(layer[end - 1], layer[end])) ++end;
        const std::span<Path> stroke(&layer[first], end - first);
        if (std::ranges::find(stroke, Role::outer_wall, &Path::role) == stroke.end()) continue;
        for (Path& path : stroke) path.role = Role::outer_wall;
    }
}

std::string_view tag_of(std::string_view comment, std::string_view name) {
    const auto at = comment.find(name);
    return at == std::string_view::npos ? std::string_view{} : comment.substr(0, at + name.size());
}

}  // namespace

class LayerPlanner::Reading {
  public:
    Reading(LayerPlanner& planner, const FileLayer& layer)
        : planner_(planner), style_(planner.style_), layer_(layer) {}

    LayerPlan read() {
        plan_.before = place_now(layer_.before.place, layer_.before.feed);
        find_body();
        note_height();
        Position from = layer_.before.place;
        std::size_t move = 0;
        for (std::size_t i = 0; i < layer_.lines.size(); ++i) {
            if (i == plan_.head_end) plan_.head = place_now(from, feed_);
            if (i == plan_.tail_begin) plan_.tail = place_now(from, feed_);
            note_line(i);
            for (; move < layer_.lines[i].moves_end; ++move) {
                add(from, layer_.moves[move], move);
                from = layer_.moves[move].to;
                feed_ = layer_.moves[move].feed;
            }
        }
        close();
        name_overhangs(plan_.whole);
        count_role();
        plan_.after = place_now(layer_.after.place, layer_.after.feed);
        if (plan_.tail_begin == layer_.lines.size()) plan_.tail = plan_.after;
        if (plan_.head_end == layer_.lines.size()) plan_.head = plan_.after;
        style_.absolute_e = layer_.after.absolute_e;
        check();
        return std::move(plan_);
    }

  private:
    [[nodiscard]] LayerPlan::Place place_now(const Position& at, double feed) const {
        return {at, planner_.pulled_back_, feed, planner_.acceleration_};
    }
    [[nodiscard]] static bool prints(const FileMove& move) { return move.role != Role::travel; }

    // Beads of no feature (priming, wiping) bound the body where others are named.
    void find_body() {
        const auto& moves = layer_.moves;
        const bool named = std::ranges::any_of(
            moves, [](const FileMove& m) { return prints(m) && m.role != Role::other; });
        const auto counts = [&](const FileMove& m) {
            return prints(m) && (!named || m.role != Role::other);
        };
        const auto first = std::ranges::find_if(moves, counts);
        plan_.head_end = plan_.tail_begin = layer_.lines.size();
        first_ = last_ = moves.size();
        if (first == moves.end()) return;
        const auto last = std::find_if(moves.rbegin(), moves.rend(), counts);
        first_ = std::size_t(first - moves.begin());
        last_ = std::size_t(moves.rend() - last) - 1;
        plan_.head_end = line_of(first_);
        plan_.tail_begin = line_of(last_) + 1;
        first_ = plan_.head_end == 0 ? 0 : layer_.lines[plan_.head_end - 1].moves_end;
        plan_.z = first->to[axis_z];
    }
    [[nodiscard]] std::size_t line_of(std::size_t move) const {
        const auto line = std::ranges::upper_bound(layer_.lines, move, {}, &FileLine::moves_end);
        return std::size_t(line - layer_.lines.begin());
    }

    void note_height() {
        if (first_ == layer_.moves.size()) return;
        double height = layer_.layer ? layer_.layer->height : 0;
        if (height <= 0) height = plan_.z - planner_.last_z_;
        if (height <= 0.01 || height > 5)
            height = planner_.height_ > 0 ? planner_.height_ : usual_height;
        planner_.height_ = height;
        planner_.last_z_ = plan_.z;
    }

    [[nodiscard]] bool in_body(std::size_t line) const {
        return line >= plan_.head_end && line < plan_.tail_begin;
    }
    void obstruct(const char* what) {
        if (plan_.obstacle.empty()) plan_.obstacle = what;
    }

    void note_line(std::size_t i) {
        const FileLine& line = layer_.lines[i];
        const std::string_view text = text_of(layer_, i);
        switch (line.use) {
            case LineUse::feature:
                note_feature(text);
                break;
            case LineUse::remark:
                if (text.find("HEIGHT:") != std::string_view::npos && style_.height_tag.empty())
                    style_.height_tag = tag_of(text, "HEIGHT:");
                break;
            case LineUse::limits:
                note_limits(i, text);
                break;
            case LineUse::fan:
                if (in_body(i) && line.value != fan_now(i)) obstruct("the fan changes within");
                break;
            case LineUse::recoil:
                note_firmware(text);
                break;
            case LineUse::other:
                if (in_body(i)) obstruct("something else than motion within");
                break;
            default:
                break;
        }
        if (line.odd_arc && in_body(i)) obstruct("arcs in another plane or of several turns");
        if (line.use != LineUse::limits && line.use != LineUse::remark) group_.clear();
    }
    [[nodiscard]] double fan_now(std::size_t until) const {
        double fan = layer_.fan;
        for (std::size_t i = 0; i < until; ++i)
            if (layer_.lines[i].use == LineUse::fan) fan = layer_.lines[i].value;
        return fan;
    }

    // How far the firmware pulls back is its own affair.
    void note_firmware(std::string_view text) {
        style_.by_firmware = true;
        style_.retract_length = 1;
        planner_.pulled_back_ = text.find("10") != std::string_view::npos ? 1 : 0;
        waiting_ = planner_.pulled_back_ > 0;
    }

    void note_feature(std::string_view text) {
        if (text.find("WIDTH:") != std::string_view::npos) {
            style_.width_tag = tag_of(text, "WIDTH:");
        } else if (text.find("WIPE_") == std::string_view::npos) {
            count_role();
            role_line_ = text;
        }
    }
    void note_limits(std::size_t i, std::string_view text) {
        group_ += text;
        const double asked = layer_.lines[i].value;
        if (asked > 0) planner_.acceleration_ = group_acceleration_ = asked;
        if (group_.size() == text.size() && asked <= 0) group_acceleration_ = 0;
        if (group_acceleration_ > 0) style_.limits[group_acceleration_] = group_;
        const bool more = i + 1 < layer_.lines.size() && layer_.lines[i + 1].use == LineUse::limits;
        if (in_body(i) && group_acceleration_ <= 0 && !more) obstruct("other limits within");
    }

    void add(const Position& from, const FileMove& move, std::size_t index) {
        const Vec3 a = place_of(from), b = place_of(move.to);
        const double way = length(flat(b - a));
        if (prints(move)) {
            note_print(a, b, move.role, index);
            print(a, b, move);
        } else {
            if (way < hair && move.filament < -hair) note_retraction(move);
            if (way < hair && move.filament > hair) note_return(move);
            if (way < hair && move.to[axis_z] > from[axis_z] + hair)
                note_lift(move, from, index >= first_ && index <= last_);
            if (move.filament != 0)
                planner_.pulled_back_ = std::max(0.0, planner_.pulled_back_ - move.filament);
            if (planner_.pulled_back_ < 1e-4) planner_.pulled_back_ = 0;
            if (way > hair) travel(a, b, move);
        }
    }

    void note_print(Vec3 a, Vec3 b, Role role, std::size_t index) {
        if (role != counted_role_) count_role();
        counted_role_ = role;
        ++count_;
        if (index < first_ || index > last_) return;
        if (std::abs(b.z - a.z) > hair) obstruct("Z moves while printing");
        if (std::abs(b.z - plan_.z) > hair) obstruct("beads at several heights");
    }
    // The word that most beads of the role go by in a layer.
    void count_role() {
        if (count_ == 0 || role_line_.empty()) return;
        std::string& line = style_.role_lines[std::size_t(counted_role_)];
        std::size_t& most = most_[std::size_t(counted_role_)];
        const std::size_t count = counts_[{counted_role_, role_line_}] += count_;
        count_ = 0;
        if (count <= most) return;
        line = role_line_;
        most = count;
    }

    void note_retraction(const FileMove& move) {
        style_.retract_length = std::max(-move.filament, planner_.pulled_back_ - move.filament);
        style_.retract_speed = move.feed;
        waiting_ = true;
    }
    void note_return(const FileMove& move) {
        style_.return_speed = move.feed;
        waiting_ = false;
    }
    void note_lift(const FileMove& move, const Position& from, bool inside) {
        style_.z_speed = move.feed;
        if (!waiting_ || !inside) return;
        const double lift = move.to[axis_z] - from[axis_z];
        if (std::abs(from[axis_z] - plan_.z) < hair && lift < 5) style_.lift = lift;
    }

    void travel(Vec3 a, Vec3 b, const FileMove& move) {
        const bool retracted = planner_.pulled_back_ > 0;
        if (open_.points.empty() || open_.role != Role::travel || open_.speed != move.feed ||
            open_.retracted != retracted) {
            close();
            open_ = {Role::travel, {}, move.feed, 0, retracted, {a}};
        }
        open_.points.push_back(b);
    }

    // A path goes on as long as role, speed and flow do.
    void print(Vec3 a, Vec3 b, const FileMove& move) {
        const double way = length(b - a),
                     cross_section = pi / 4 * style_.filament * style_.filament;
        const double amount = move.filament * cross_section;
        const double error = e_rounding * cross_section;
        const double mean = way_ > 0 ? amount_ / way_ : 0;
        const bool same = !open_.points.empty() && open_.role == move.role &&
                          open_.speed == move.feed && bead_ == move.bead &&
                          open_.acceleration == planner_.acceleration_ &&
                          std::abs(amount - mean * way) < same_flow * mean * way + error;
        if (!same) {
            close();
            bead_ = move.bead;
            open_ = {.role = move.role,
                     .bead = {0, move.bead.height > 0 ? move.bead.height : planner_.height_},
                     .speed = move.feed,
                     .acceleration = planner_.acceleration_,
                     .retracted = false,
                     .points = {a}};
        }
        open_.points.push_back(b);
        amount_ += amount;
        way_ += way;
    }

    void close() {
        if (open_.points.size() > 1) {
            if (open_.role != Role::travel) open_.bead = bead_of(amount_ / way_, open_.bead.height);
            plan_.whole.push_back(std::move(open_));
        }
        open_ = {};
        amount_ = way_ = 0;
    }

    void check() {
        if (first_ == layer_.moves.size()) return;
        set_free();
        const std::array states{&layer_.before, &layer_.after};
        for (const FileState* const state : states) {
            if (state->unit != 1) obstruct("in inches");
            if (state->renamed_xy) obstruct("places renamed by the firmware");
        }
        if (layer_.before.relative_xyz) obstruct("relative coordinates");
        set_body();
    }
    void set_free() {
        plan_.head_free = is_free(0, plan_.head_end) && !beads_before();
        plan_.tail_free = is_free(plan_.tail_begin, layer_.lines.size()) && !beads_behind();
    }
    [[nodiscard]] bool is_free(std::size_t from, std::size_t to) const {
        return std::none_of(layer_.lines.begin() + std::ptrdiff_t(from),
                            layer_.lines.begin() + std::ptrdiff_t(to),
                            [](const FileLine& line) { return line.use == LineUse::other; });
    }
    [[nodiscard]] bool beads_before() const {
        return std::any_of(layer_.moves.begin(), layer_.moves.begin() + std::ptrdiff_t(first_),
                           prints);
    }
    [[nodiscard]] bool beads_behind() const {
        return std::any_of(layer_.moves.begin() + std::ptrdiff_t(last_) + 1, layer_.moves.end(),
                           prints);
    }
    // Without what stands before its first bead or behind its last. Beads of head and tail, if any,
    // were closed off by the travel between or are of another role.
    void set_body() {
        const auto is_of_body = [&](const Path& path) {
            return path.role != Role::travel &&
                   (beads_before() || beads_behind() ? path.role != Role::other : true);
        };
        const auto first = std::ranges::find_if(plan_.whole, is_of_body);
        const auto last = std::find_if(plan_.whole.rbegin(), plan_.whole.rend(), is_of_body);
        if (first == plan_.whole.end()) return obstruct("nothing printed");
        plan_.body.assign(first, last.base());
    }

    LayerPlanner& planner_;
    MotionStyle& style_;
    const FileLayer& layer_;
    LayerPlan plan_;
    std::size_t first_ = 0, last_ = 0;  // moves of the body
    double feed_ = 0;
    std::string role_line_, group_;
    double group_acceleration_ = 0;
    std::map<std::pair<Role, std::string>, std::size_t> counts_;
    Role counted_role_ = Role::travel;
    std::size_t count_ = 0;
    PerRole<std::size_t> most_{};
    bool waiting_ = false;
    Path open_;
    Bead bead_;
    double amount_ = 0, way_ = 0;  // mm³, mm of the open path
};

LayerPlan LayerPlanner::plan(const FileLayer& layer) { return Reading(*this, layer).read(); }

}  // namespace bead
