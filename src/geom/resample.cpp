#include "geom/resample.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {

Polyline resampled(const Polyline& line, double step) {
    BEAD_EXPECTS(step > 0 && line.size() >= 2);
    const double whole = length(line);
    const int count = std::max(1, static_cast<int>(std::lround(whole / step)));
    Polyline even{line.front()};
    double passed = 0;
    std::size_t k = 1;
    for (int i = 1; i < count; ++i) {
        const double at = whole * i / count;
        while (k + 1 < line.size() && passed + distance(line[k - 1], line[k]) < at)
            passed += distance(line[k - 1], line[k]), ++k;
        const double part = distance(line[k - 1], line[k]);
        even.push_back(
            lerp(line[k - 1], line[k], part > 0 ? std::clamp((at - passed) / part, 0.0, 1.0) : 0));
    }
    even.push_back(line.back());
    return even;
}

Polyline smoothed(Polyline line, int passes) {
    Polyline next = line;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 1; i + 1 < line.size(); ++i)
            next[i] = 0.5 * line[i] + 0.25 * (line[i - 1] + line[i + 1]);
        std::swap(line, next);
    }
    return line;
}

Polyline part_of(const Polyline& line, double from, double to) {
    Polyline part;
    double passed = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double piece = distance(line[i - 1], line[i]);
        const double begin = std::max(from, passed), end = std::min(to, passed + piece);
        if (piece > 0 && begin < end) {
            if (part.empty()) part.push_back(lerp(line[i - 1], line[i], (begin - passed) / piece));
            part.push_back(lerp(line[i - 1], line[i], (end - passed) / piece));
        }
        passed += piece;
    }
    return part;
}

Polyline shifted_aside(const Polyline& line, double by) {
    Polyline moved;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 along = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
        const double size = length(along);
        moved.push_back(size > 0 ? line[i] + by / size * left_of(along) : line[i]);
    }
    return moved;
}

}  // namespace bead
