// Sums over the paths of a layer, for laws about what must stay.
#pragma once
#include <algorithm>
#include <optional>

#include "toolpath/path.h"

namespace bead::test {

inline std::size_t count(const Toolpath& layer, Role role) {
    return static_cast<std::size_t>(
        std::ranges::count_if(layer, [&](const Path& path) { return path.role == role; }));
}

inline double extruded(const Toolpath& layer, std::optional<Role> role = {}) {
    double sum = 0;
    for (const Path& path : layer)
        if (role ? path.role == *role : path.role != Role::travel) sum += length(path);
    return sum;
}

inline double deposited(const Toolpath& layer, std::optional<Role> role = {}) {
    double sum = 0;
    for (const Path& path : layer)
        if (!role || path.role == *role) sum += volume(path);
    return sum;
}

inline bool is_same(const Toolpath& a, const Toolpath& b) {
    return std::ranges::equal(a, b, [](const Path& p, const Path& q) {
        return p.role == q.role && p.bead == q.bead && p.speed == q.speed && p.points == q.points &&
               p.acceleration == q.acceleration && p.retracted == q.retracted;
    });
}

// Every path begins where the one before ended.
inline bool is_connected(const Toolpath& layer) {
    for (std::size_t i = 1; i < layer.size(); ++i)
        if (length(layer[i].points.front() - layer[i - 1].points.back()) > 1e-6) return false;
    return true;
}

}  // namespace bead::test
