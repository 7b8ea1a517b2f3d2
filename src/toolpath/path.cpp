#include "toolpath/path.h"

namespace bead {

double length(const Path& path) {
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        sum += length(path.points[i] - path.points[i - 1]);
    return sum;
}

double volume(const Path& path) {
    return path.role == Role::travel ? 0 : length(path) * section(path.bead);
}

}  // namespace bead
