#include "mesh/mesh.h"

namespace bead {

Box3 bounds(const Mesh& mesh) {
    Box3 box;
    for (const Vec3 p : mesh.points) box.include(p);
    return box;
}

double volume(const Mesh& mesh) {
    if (mesh.points.empty()) return 0;
    const Vec3 origin = mesh.points.front();  // near the part, so that little cancels
    double six_volumes = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto from_origin = [&](int i) {
            return mesh.points[static_cast<std::size_t>(i)] - origin;
        };
        six_volumes += dot(from_origin(a), cross(from_origin(b), from_origin(c)));
    }
    return six_volumes / 6;
}

Mesh moved(Mesh mesh, double angle, Vec3 shift) {
    const Vec2 turn = unit(angle);
    for (Vec3& p : mesh.points) p = at_height(rotated(flat(p), turn), p.z) + shift;
    return mesh;
}

}  // namespace bead
