#include "fem/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fem/grid_multigrid.h"

namespace bead {
namespace {

using Corners = std::array<std::size_t, 8>;  // x fastest, then y, then z

Corners corners_of(const VoxelGrid& grid, std::size_t cell) {
    const auto n = grid.counts();
    const std::size_t x = cell % (n[0] - 1), y = cell / (n[0] - 1) % (n[1] - 1);
    const std::size_t z = cell / ((n[0] - 1) * (n[1] - 1));
    const std::size_t first = (z * n[1] + y) * n[0] + x, up = n[0] * n[1];
    return {first,      first + 1,      first + n[0],      first + n[0] + 1,
            first + up, first + up + 1, first + up + n[0], first + up + n[0] + 1};
}

std::vector<std::uint8_t> solid_nodes(const VoxelGrid& grid) {
    const auto n = grid.counts();
    std::vector<std::uint8_t> mark(n[0] * n[1] * n[2], 0);
    for (std::size_t cell = 0; cell < grid.solid.size(); ++cell)
        if (grid.solid[cell] != 0)
            for (const std::size_t node : corners_of(grid, cell)) mark[node] = 1;
    return mark;
}

bool within(const Box3& box, Vec3 p, double slack) {
    return p.x >= box.low.x - slack && p.x <= box.high.x + slack && p.y >= box.low.y - slack &&
           p.y <= box.high.y + slack && p.z >= box.low.z - slack && p.z <= box.high.z + slack;
}

// A box between two layers of nodes is widened by half a cube. Empty: it touches nothing solid.
std::vector<std::uint8_t> nodes_in(const VoxelGrid& grid, const std::vector<std::uint8_t>& solid,
                                   const Box3& box) {
    std::vector<std::uint8_t> mark(solid.size(), 0);
    for (const double slack : {0.01, 0.51}) {
        bool any = false;
        for (std::size_t node = 0; node < mark.size(); ++node)
            if (solid[node] != 0 && within(box, grid.place(node), slack * grid.size)) {
                mark[node] = 1;
                any = true;
            }
        if (any) return mark;
    }
    return {};
}

// What each node bears: of cubes wholly in the box, else of faces, else of nodes.
std::vector<float> shares(const VoxelGrid& grid, const std::vector<std::uint8_t>& inside) {
    constexpr std::size_t faces[6][4] = {{0, 2, 4, 6}, {1, 3, 5, 7}, {0, 1, 4, 5},
                                         {2, 3, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}};
    std::vector<float> by_cube(inside.size(), 0), by_face = by_cube;
    bool cubes = false, any_face = false;
    for (std::size_t cell = 0; cell < grid.solid.size(); ++cell) {
        if (grid.solid[cell] == 0) continue;
        const Corners c = corners_of(grid, cell);
        const auto is_in = [&](std::size_t k) { return inside[c[k]] != 0; };
        if (std::ranges::all_of(c, [&](std::size_t node) { return inside[node] != 0; })) {
            cubes = true;
            for (const std::size_t node : c) by_cube[node] += 1;
        }
        for (const auto& face : faces)
            if (std::ranges::all_of(face, is_in)) {
                any_face = true;
                for (const std::size_t k : face) by_face[c[k]] += 1;
            }
    }
    if (cubes) return by_cube;
    if (any_face) return by_face;
    return {inside.begin(), inside.end()};
}

struct Problem {
    std::vector<std::uint8_t> held;
    std::vector<double> load;
    std::optional<std::string> failure;
};

std::string where(const char* table, std::size_t i) {
    return std::string(table) + "[" + std::to_string(i) +
           "].box touches nothing of the part; "
           "make cubes smaller (--h) or move it";
}

Problem problem_of(const SolidCase& solid, const VoxelGrid& grid,
                   const std::vector<std::uint8_t>& nodes) {
    Problem p{std::vector<std::uint8_t>(3 * nodes.size(), 0),
              std::vector<double>(3 * nodes.size(), 0.0),
              {}};
    for (std::size_t s = 0; s < solid.supports.size(); ++s) {
        const BoxSupport& support = solid.supports[s];
        const std::vector<std::uint8_t> inside = nodes_in(grid, nodes, support.box);
        if (inside.empty()) p.failure = where("support", s);
        for (std::size_t node = 0; node < inside.size(); ++node) {
            if (inside[node] == 0) continue;
            if (support.x) p.held[3 * node] = 1;
            if (support.y) p.held[3 * node + 1] = 1;
            if (support.z) p.held[3 * node + 2] = 1;
        }
    }
    for (std::size_t l = 0; l < solid.loads.size(); ++l) {
        const std::vector<std::uint8_t> inside = nodes_in(grid, nodes, solid.loads[l].box);
        if (inside.empty()) {
            p.failure = where("load", l);
            continue;
        }
        const std::vector<float> share = shares(grid, inside);
        double total = 0;
        for (const float value : share) total += double(value);
        for (std::size_t node = 0; node < share.size(); ++node) {
            const Vec3 force = double(share[node]) / total * solid.loads[l].force;
            p.load[3 * node] += force.x;
            p.load[3 * node + 1] += force.y;
            p.load[3 * node + 2] += force.z;
        }
    }
    return p;
}

// The six motions of a rigid body that the held unknowns leave free, by the rank of their
// equations.
bool holds(const VoxelGrid& grid, std::span<const std::uint8_t> held) {
    double gram[6][6] = {};
    const auto n = grid.counts();
    const double size = grid.size * double(std::max({n[0], n[1], n[2]}));
    const Vec3 middle =
        grid.origin + 0.5 * grid.size * Vec3{double(n[0]), double(n[1]), double(n[2])};
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i] == 0) continue;
        const Vec3 r = 1 / size * (grid.place(i / 3) - middle);
        const double rows[3][6] = {
            {1, 0, 0, 0, r.z, -r.y}, {0, 1, 0, -r.z, 0, r.x}, {0, 0, 1, r.y, -r.x, 0}};
        for (int a = 0; a < 6; ++a)
            for (int b = 0; b < 6; ++b) gram[a][b] += rows[i % 3][a] * rows[i % 3][b];
    }
    for (int k = 0; k < 6; ++k) {  // Gauss, with the largest of what is left as pivot
        int best = k;
        for (int j = k; j < 6; ++j)
            if (gram[j][j] > gram[best][best]) best = j;
        for (int j = 0; j < 6; ++j) std::swap(gram[k][j], gram[best][j]);
        for (int j = 0; j < 6; ++j) std::swap(gram[j][k], gram[j][best]);
        if (gram[k][k] < 1e-9) return false;
        for (int i = k + 1; i < 6; ++i) {
            const double factor = gram[i][k] / gram[k][k];
            for (int j = k; j < 6; ++j) gram[i][j] -= factor * gram[k][j];
        }
    }
    return true;
}

ElasticGrid elastic(const VoxelGrid& grid, const SolidMaterial& m) {
    const double mu = m.young / (2 * (1 + m.poisson));
    const double lambda = 2 * mu * m.poisson / (1 - 2 * m.poisson);
    return {3, grid.cells, grid.solid, {}, lambda * grid.size, mu * grid.size};
}

// A cube's stress at a place in [-1, 1]³.
Tensor3 stress_in(const VoxelGrid& grid, const SolidMaterial& m, const Corners& corners,
                  std::span<const double> u, Vec3 place) {
    double slope[3][3] = {};
    for (std::size_t k = 0; k < 8; ++k) {
        const Vec3 s{k % 2 == 0 ? -1.0 : 1.0, k / 2 % 2 == 0 ? -1.0 : 1.0, k < 4 ? -1.0 : 1.0};
        const double x = 1 + s.x * place.x, y = 1 + s.y * place.y, z = 1 + s.z * place.z;
        const double d[3] = {s.x * y * z / 8, s.y * x * z / 8, s.z * x * y / 8};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t a = 0; a < 3; ++a)
                slope[c][a] += u[3 * corners[k] + c] * d[a] * 2 / grid.size;
    }
    const double mu = m.young / (2 * (1 + m.poisson));
    const double trace =
        2 * mu * m.poisson / (1 - 2 * m.poisson) * (slope[0][0] + slope[1][1] + slope[2][2]);
    return {trace + 2 * mu * slope[0][0],     trace + 2 * mu * slope[1][1],
            trace + 2 * mu * slope[2][2],     mu * (slope[0][1] + slope[1][0]),
            mu * (slope[1][2] + slope[2][1]), mu * (slope[2][0] + slope[0][2])};
}

std::vector<Tensor3> node_stresses(const VoxelGrid& grid, const SolidMaterial& m,
                                   std::span<const double> u) {
    std::vector<Tensor3> stress(u.size() / 3);
    std::vector<std::uint8_t> count(stress.size(), 0);
    for (std::size_t cell = 0; cell < grid.solid.size(); ++cell) {
        if (grid.solid[cell] == 0) continue;
        const Corners corners = corners_of(grid, cell);
        for (std::size_t k = 0; k < 8; ++k) {
            const Vec3 at{k % 2 == 0 ? -1.0 : 1.0, k / 2 % 2 == 0 ? -1.0 : 1.0, k < 4 ? -1.0 : 1.0};
            stress[corners[k]] = stress[corners[k]] + stress_in(grid, m, corners, u, at);
            ++count[corners[k]];
        }
    }
    for (std::size_t node = 0; node < stress.size(); ++node)
        if (count[node] > 1) stress[node] = 1.0 / count[node] * stress[node];
    return stress;
}

SolidProbe probe_at(const VoxelGrid& grid, std::span<const double> u,
                    const std::vector<Tensor3>& stress, Vec3 at) {
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t cell = 0; cell < grid.solid.size(); ++cell) {
        if (grid.solid[cell] == 0) continue;
        const Vec3 centre = grid.place(corners_of(grid, cell)[0]) + 0.5 * grid.size * Vec3{1, 1, 1};
        if (const double far = length(at - centre); far < least) {
            least = far;
            nearest = cell;
        }
    }
    const Corners corners = corners_of(grid, nearest);
    const Vec3 t = 1 / grid.size * (at - grid.place(corners[0]));
    const double x = std::clamp(t.x, 0.0, 1.0), y = std::clamp(t.y, 0.0, 1.0);
    const double z = std::clamp(t.z, 0.0, 1.0);
    SolidProbe probe{at, {}, {}};
    for (std::size_t k = 0; k < 8; ++k) {
        const double share =
            (k % 2 == 0 ? 1 - x : x) * (k / 2 % 2 == 0 ? 1 - y : y) * (k < 4 ? 1 - z : z);
        const std::size_t node = corners[k];
        probe.displacement =
            probe.displacement + share * Vec3{u[3 * node], u[3 * node + 1], u[3 * node + 2]};
        probe.stress = probe.stress + share * stress[node];
    }
    return probe;
}

// K u - f on what each support holds.
std::vector<Vec3> reactions_of(const SolidCase& solid, const SolidAnswer& answer,
                               const ElasticGrid& elastic_grid, const Problem& problem,
                               std::span<const double> u, const std::vector<std::uint8_t>& nodes) {
    const std::size_t count = nodes.size();
    std::vector<double> by_component(3 * count), forces(3 * count);
    for (std::size_t i = 0; i < u.size(); ++i) by_component[i % 3 * count + i / 3] = u[i];
    multiply(elastic_grid, by_component.data(), forces.data());
    std::vector<std::uint8_t> held = problem.held;
    std::vector<Vec3> result;
    for (const BoxSupport& support : solid.supports) {
        Vec3 sum;
        const std::vector<std::uint8_t> inside = nodes_in(answer.grid, nodes, support.box);
        for (std::size_t node = 0; node < inside.size(); ++node) {
            if (inside[node] == 0) continue;
            const auto take = [&](std::size_t c, bool holds_it) {
                if (!holds_it || std::exchange(held[3 * node + c], std::uint8_t(0)) == 0)
                    return 0.0;
                return forces[c * count + node] - problem.load[3 * node + c];
            };
            sum = sum + Vec3{take(0, support.x), take(1, support.y), take(2, support.z)};
        }
        result.push_back(sum);
    }
    return result;
}

}  // namespace

SolidAnswer solved_solid(const SolidCase& solid, const SolidOptions& options) {
    SolidAnswer answer;
    const double size =
        options.size > 0 ? options.size : std::cbrt(std::abs(volume(solid.mesh))) / 40;
    answer.grid = voxels(solid.mesh, size);
    const std::vector<std::uint8_t> nodes = solid_nodes(answer.grid);
    const Problem problem = problem_of(solid, answer.grid, nodes);
    answer.failure = problem.failure;
    if (!answer.failure && !holds(answer.grid, problem.held))
        answer.failure = "the supports let the part move; hold it in more places or directions";
    if (answer.failure) return answer;
    const ElasticGrid grid = elastic(answer.grid, solid.material);
    const Displacement u = multigrid_solution(
        grid, problem.held, problem.load, {.tolerance = options.tolerance, .most = options.most});
    answer.converged = u.converged;
    answer.residual = u.residual;
    answer.iterations = u.iterations;
    for (std::size_t i = 0; i < u.values.size(); ++i) answer.work += problem.load[i] * u.values[i];
    answer.reactions = reactions_of(solid, answer, grid, problem, u.values, nodes);
    const std::vector<Tensor3> stress = node_stresses(answer.grid, solid.material, u.values);
    for (const Vec3 at : solid.probes)
        answer.probes.push_back(probe_at(answer.grid, u.values, stress, at));
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (nodes[node] == 0) continue;
        answer.nodes.push_back(node);
        answer.displacement.push_back(
            {u.values[3 * node], u.values[3 * node + 1], u.values[3 * node + 2]});
        answer.stress.push_back(stress[node]);
        answer.largest = std::max(answer.largest, length(answer.displacement.back()));
    }
    return answer;
}

}  // namespace bead
