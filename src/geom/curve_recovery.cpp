#include "geom/curve_recovery.h"

#include <algorithm>

#include "core/expects.h"
#include "geom/cubic_spline.h"
#include "geom/deviation.h"

namespace bead {
namespace {

enum class Joint { smooth, uneven, corner };

Joint joint_at(Vec2 before, Vec2 here, Vec2 after, const RecoveryOptions& options) {
    const Vec2 in = here - before, out = after - here;
    if (std::atan2(std::abs(cross(in, out)), dot(in, out)) >= options.corner) return Joint::corner;
    const double first = length(in), second = length(out);
    const bool even = std::max(first, second) <= options.ratio * std::min(first, second);
    return even ? Joint::smooth : Joint::uneven;
}

// Chords are compared with the curve over them, span by span.
bool stays_near(const Nurbs& curve, const Polyline& points, double tolerance) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Cubic cubic = cubic_of(curve, points, i);
        for (const double part : {0.25, 0.5, 0.75})
            if (segment_distance(points[i], points[i + 1], point_at(cubic, part)) > tolerance)
                return false;
    }
    return true;
}

// A line with what is known of each of its points; the ends of an open line are corners.
struct Jointed {
    Polyline points;
    std::vector<Joint> joints;

    [[nodiscard]] bool is_end(std::size_t i) const { return joints[i] != Joint::smooth; }
    // Whether the chord from i to i + 1 is a line by itself.
    [[nodiscard]] bool is_line(std::size_t i) const { return is_end(i) && is_end(i + 1); }

    // Of both runs that meet at an uneven joint: that of the line beside it, else of the circle.
    [[nodiscard]] std::optional<Vec2> shared_direction(std::size_t i) const {
        if (joints[i] != Joint::uneven) return std::nullopt;
        const std::size_t last =
            points.size() - 1;  // uneven only in a loop, which ends as it begins
        const std::size_t before = i > 0 ? i - 1 : last - 1, after = i < last ? i : 0;
        const Vec2 in = points[before + 1] - points[before];
        const Vec2 out = points[after + 1] - points[after];
        if (is_line(before)) return in / length(in);
        if (is_line(after)) return out / length(out);
        return circle_direction(points[before], points[i], points[after + 1]);
    }
};

RecoveredRun run_of(const Jointed& line, std::size_t first, std::size_t last,
                    const RecoveryOptions& options) {
    const auto at = [&](std::size_t i) {
        return line.points.begin() + static_cast<std::ptrdiff_t>(i);
    };
    RecoveredRun run{{at(first), at(last) + 1}, std::nullopt};
    if (last - first < 2) return run;
    const Polyline& p = run.points;
    const std::size_t n = p.size();
    const Vec2 begin =
        line.shared_direction(first).value_or(circle_start_direction(p[0], p[1], p[2]));
    const Vec2 end =
        line.shared_direction(last).value_or(-circle_start_direction(p[n - 1], p[n - 2], p[n - 3]));
    Nurbs curve = cubic_through(p, begin, end);
    if (stays_near(curve, p, options.tolerance)) run.curve = std::move(curve);
    return run;
}

std::vector<RecoveredRun> runs_of(const Jointed& line, const RecoveryOptions& options) {
    std::vector<RecoveredRun> runs;
    std::size_t first = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        if (!line.is_end(i)) continue;
        runs.push_back(run_of(line, first, i, options));
        first = i;
    }
    return runs;
}

RecoveredRun whole_loop(const Polyline& loop, const RecoveryOptions& options) {
    RecoveredRun run{loop, std::nullopt};
    run.points.push_back(loop.front());
    Nurbs curve = closed_cubic_through(loop);
    if (stays_near(curve, run.points, options.tolerance)) run.curve = std::move(curve);
    return run;
}

}  // namespace

std::vector<RecoveredRun> recovered_runs(const Polyline& line, const RecoveryOptions& options) {
    if (line.size() < 2) return {};
    Jointed jointed{line, std::vector(line.size(), Joint::corner)};
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        jointed.joints[i] = joint_at(line[i - 1], line[i], line[i + 1], options);
    return runs_of(jointed, options);
}

std::vector<RecoveredRun> recovered_loop(const Polyline& loop, const RecoveryOptions& options) {
    const std::size_t n = loop.size();
    BEAD_EXPECTS(n >= 3);
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < n; ++i)
        joints.push_back(joint_at(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n], options));
    // A corner, where both sides are known without looking round; else any end of a line.
    auto start = std::ranges::find(joints, Joint::corner);
    if (start == joints.end()) start = std::ranges::find(joints, Joint::uneven);
    if (start == joints.end()) return {whole_loop(loop, options)};
    const auto shift = static_cast<std::size_t>(start - joints.begin());
    Jointed jointed;
    for (std::size_t i = 0; i <= n; ++i) {
        jointed.points.push_back(loop[(i + shift) % n]);
        jointed.joints.push_back(joints[(i + shift) % n]);
    }
    return runs_of(jointed, options);
}

}  // namespace bead
