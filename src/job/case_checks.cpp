#include "job/case_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/stretch.h"
#include "geom/along.h"

namespace bead {
namespace {

struct Side {
    Vec2 a, b;
    std::size_t number = 0;
};

std::optional<Vec2> crossing(const Side& s, const Side& t) {
    const Vec2 u = s.b - s.a, v = t.b - t.a, w = t.a - s.a;
    const double turn = cross(u, v);
    if (std::abs(turn) <= 1e-12 * length(u) * length(v)) {
        // Parallel: they meet only if they lie on one line and overlap.
        if (std::abs(cross(u, w)) > 1e-9 * length(u)) return std::nullopt;
        const double square = dot(u, u);
        const double from = dot(w, u) / square, to = dot(t.b - s.a, u) / square;
        if (std::max(from, to) < 1e-9 || std::min(from, to) > 1 - 1e-9) return std::nullopt;
        return t.a;
    }
    const double along_s = cross(w, v) / turn, along_t = cross(w, u) / turn;
    if (along_s < 0 || along_s > 1 || along_t < 0 || along_t > 1) return std::nullopt;
    return lerp(s.a, s.b, along_s);
}

// Neighbours share a corner; they may only not fold back onto each other.
bool folds_back(const Side& s, const Side& t) {
    const Vec2 u = s.b - s.a, v = t.b - t.a;
    return std::abs(cross(u, v)) <= 1e-12 * length(u) * length(v) && dot(u, v) < 0;
}

std::string name_of(const LoadCase& load_case, std::size_t situation, const char* table,
                    std::size_t i) {
    const std::string inner = fmt::format("{}[{}]", table, i);
    return load_case.situations.size() > 1 ? fmt::format("case[{}].{}", situation, inner) : inner;
}

// A single case may still be written as [[case]].
std::string key_of(TomlReader& file, const LoadCase& load_case, std::size_t situation,
                   const char* table, std::size_t i) {
    if (load_case.situations.size() == 1 && file.place_of("case"))
        return fmt::format("case[0].{}[{}]", table, i);
    return name_of(load_case, situation, table, i);
}

void check_stretch(TomlReader& file, const std::string& key, const Region& part,
                   const Stretch& stretch) {
    if (stretch_lines(part, stretch)) return;
    if (stretch.arc)
        file.refuse(key + ".on",
                    "has no boundary of the part on it between its angles; give "
                    "the circle and angles of an arc of the outline or a hole");
    for (const auto& [end, place] :
         {std::pair{".from", stretch.from}, std::pair{".to", stretch.to}})
        if (const double far = boundary_distance(part, place); far > boundary_tolerance)
            file.refuse(key + end, fmt::format("= [{:g}, {:g}] is not on the boundary, which is "
                                               "{:.3g} mm away; move it there",
                                               place.x, place.y, far));
    file.refuse(key, "goes from one loop of the boundary to another; give both ends on one");
}

double pull(const Region& part, const Load& load) {
    double sum = 0;
    const auto lines = stretch_lines(part, load.on);
    for (const Polyline& line : *lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            sum += distance(line[i], line[i + 1]) * traction(load, lerp(line[i], line[i + 1], 0.5));
    return sum;
}

void check_load(TomlReader& file, const std::string& key, const Region& part, const Load& load) {
    check_stretch(file, key, part, load.on);
    if (length(load.force) == 0) file.refuse(key + ".force_n", "is no force; say how many newtons");
    if (!load.on.arc && distance(load.on.from, load.on.to) < 1e-6)
        file.refuse(key,
                    "pulls at a single point, where the displacement is infinite; give it a "
                    "stretch");
    const auto spans = stretch_spans(part, load.on);
    const double round = measured_loops(part)[spans->front().loop].length;
    if (load.move > round / 2)
        file.refuse(
            key + ".move_mm",
            fmt::format("goes further than half-way round, {:.4g} mm; give less", round / 2));
    if (pull(part, load) < 1e-9)
        file.refuse(key,
                    "presses on the empty side: the force points away from its whole arc; turn one "
                    "of them round");
}

// Rigid motions are two shifts and a turn; what is held must leave none of them free. The points'
// equations (1, 0, -y) and (0, 1, x) are added up into a 3 x 3 matrix about their middle.
struct Held3 {
    double xx = 0, yy = 0, x_turn = 0, y_turn = 0, turn = 0;
};

Held3 held_by(const LoadCase& load_case, const Situation& situation, Vec2 middle, double size) {
    Held3 h;
    const auto hold = [&](const Support& support, Vec2 p) {
        const Vec2 r = (p - middle) / size;
        if (support.x) {
            h.xx += 1;
            h.x_turn -= r.y;
            h.turn += r.y * r.y;
        }
        if (support.y) {
            h.yy += 1;
            h.y_turn += r.x;
            h.turn += r.x * r.x;
        }
    };
    for (const Support& support : situation.supports) {
        const auto lines = stretch_lines(load_case.part, support.on);
        for (const Polyline& line : *lines)
            for (const Vec2 p : line) hold(support, p);
    }
    return h;
}

void check_held(TomlReader& file, const std::string& key, const LoadCase& load_case,
                const Situation& situation) {
    const Box2 box = bounds(load_case.part);
    const Held3 h = held_by(load_case, situation, box.centre(), length(box.size()));
    if (h.xx == 0) file.refuse(key, "lets the part slide along x; fix x somewhere");
    if (h.yy == 0) file.refuse(key, "lets the part slide along y; fix y somewhere");
    if (h.turn - h.x_turn * h.x_turn / h.xx - h.y_turn * h.y_turn / h.yy < 1e-10)
        file.refuse(key, "lets the part turn about a point; hold it in a second place");
}

// Whether the supports hold every point of the load's stretch in every direction it pulls in.
bool held_everywhere(const LoadCase& load_case, const Situation& situation, const Load& load) {
    constexpr int samples = 64;
    const std::vector<MeasuredLoop> loops = measured_loops(load_case.part);
    const auto is_held = [&](std::size_t loop, double at, bool Support::*direction) {
        return std::ranges::any_of(situation.supports, [&](const Support& support) {
            const auto spans = stretch_spans(load_case.part, support.on);
            return support.*direction && std::ranges::any_of(*spans, [&](const BoundarySpan& s) {
                       const double length = loops[loop].length;
                       const double once = s.from + std::fmod(at - s.from + 2 * length, length);
                       return s.loop == loop && once <= s.to;
                   });
        });
    };
    const bool x = load.force.x != 0 || load.turn > 0, y = load.force.y != 0 || load.turn > 0;
    const auto spans = stretch_spans(load_case.part, load.on);
    return std::ranges::all_of(*spans, [&](const BoundarySpan& span) {
        for (int i = 0; i < samples; ++i) {
            const double at = std::lerp(span.from, span.to, (i + 0.5) / samples);
            if (x && !is_held(span.loop, at, &Support::x)) return false;
            if (y && !is_held(span.loop, at, &Support::y)) return false;
        }
        return true;
    });
}

}  // namespace

bool is_flat(const Polyline& loop) {
    const Vec2 a = loop.front();
    const Vec2 b = *std::ranges::max_element(loop, {}, [&](Vec2 p) { return distance(a, p); });
    return std::ranges::all_of(
        loop, [&](Vec2 p) { return std::abs(cross(p - a, b - a)) <= 1e-6 * distance(a, b); });
}

std::optional<Vec2> self_crossing(const Polyline& loop) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sides.push_back({loop[i], loop[(i + 1) % loop.size()], i});
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (sides[i].a == sides[i].b) return sides[i].a;
        if (folds_back(sides[i], sides[(i + 1) % sides.size()])) return sides[i].b;
    }
    const auto low = [](const Side& s) { return std::min(s.a.x, s.b.x); };
    const auto high = [](const Side& s) { return std::max(s.a.x, s.b.x); };
    std::ranges::sort(sides, {}, low);
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size() && low(sides[j]) <= high(sides[i]); ++j) {
            const std::size_t apart =
                (sides[j].number + loop.size() - sides[i].number) % loop.size();
            if (apart == 1 || apart + 1 == loop.size()) continue;
            if (const auto place = crossing(sides[i], sides[j])) return place;
        }
    return std::nullopt;
}

void check_boundary(TomlReader& file, const LoadCase& load_case) {
    for (std::size_t s = 0; s < load_case.situations.size(); ++s) {
        const Situation& situation = load_case.situations[s];
        const auto key = [&](const char* table, std::size_t i) {
            return key_of(file, load_case, s, table, i);
        };
        const std::string where = file.place_of("case") ? fmt::format("case[{}].", s) : "";
        if (situation.supports.empty())
            file.refuse(where + "support", "is missing; nothing holds the part");
        if (situation.loads.empty()) file.refuse(where + "load", "is missing; nothing pulls");
        for (std::size_t i = 0; i < situation.supports.size(); ++i)
            check_stretch(file, key("support", i), load_case.part, situation.supports[i].on);
        for (std::size_t i = 0; i < situation.loads.size(); ++i)
            check_load(file, key("load", i), load_case.part, situation.loads[i]);
        check_held(file, where + "support", load_case, situation);
        for (std::size_t i = 0; i < situation.loads.size(); ++i)
            if (held_everywhere(load_case, situation, situation.loads[i]))
                file.refuse(key("load", i),
                            "pulls only where supports hold the part; move it or them");
    }
    for (std::size_t i = 0; i < load_case.probes.size(); ++i) {
        const Vec2 p = load_case.probes[i];
        if (contains(load_case.part, p)) continue;
        if (boundary_distance(load_case.part, p) > boundary_tolerance)
            file.refuse(fmt::format("probe[{}].at", i), "lies outside the part; move it");
    }
}

void check_boxes(TomlReader& file, const SolidCase& solid) {
    if (solid.supports.empty()) file.refuse("support", "is missing; nothing holds the part");
    if (solid.loads.empty()) file.refuse("load", "is missing; nothing pulls");
    const Box3 part = bounds(solid.mesh);
    const auto check = [&](const Box3& box, const std::string& key) {
        if (box.low.x > part.high.x || box.high.x < part.low.x || box.low.y > part.high.y ||
            box.high.y < part.low.y || box.low.z > part.high.z || box.high.z < part.low.z)
            file.refuse(key, "does not touch the part; move it");
    };
    for (std::size_t i = 0; i < solid.supports.size(); ++i)
        check(solid.supports[i].box, fmt::format("support[{}].box", i));
    for (std::size_t i = 0; i < solid.loads.size(); ++i) {
        check(solid.loads[i].box, fmt::format("load[{}].box", i));
        if (length(solid.loads[i].force) == 0)
            file.refuse(fmt::format("load[{}].force_n", i), "is no force; say how many newtons");
    }
    for (std::size_t i = 0; i < solid.probes.size(); ++i)
        check({solid.probes[i], solid.probes[i]}, fmt::format("probe[{}].at", i));
}

}  // namespace bead
