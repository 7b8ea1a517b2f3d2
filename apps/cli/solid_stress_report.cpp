#include "solid_stress_report.h"

#include <algorithm>
#include <cmath>

#include "fem/vtu.h"

namespace bead::cli {
namespace {

std::size_t cubes(const SolidAnswer& answer) {
    return std::size_t(std::ranges::count_if(answer.grid.solid, [](float s) { return s != 0; }));
}

// The cubes' corners by their places among the solid nodes, in VTK's order.
VtuMesh mesh_of(const SolidAnswer& answer) {
    VtuMesh mesh;
    mesh.points_per_cell = 8;
    mesh.type = 12;
    const auto n = answer.grid.counts();
    std::vector<int> number(n[0] * n[1] * n[2], -1);
    for (std::size_t k = 0; k < answer.nodes.size(); ++k) {
        number[answer.nodes[k]] = int(k);
        const Vec3 p = answer.grid.place(answer.nodes[k]);
        mesh.points.insert(mesh.points.end(), {float(p.x), float(p.y), float(p.z)});
    }
    for (std::size_t cell = 0; cell < answer.grid.solid.size(); ++cell) {
        if (answer.grid.solid[cell] == 0) continue;
        const std::size_t x = cell % (n[0] - 1), y = cell / (n[0] - 1) % (n[1] - 1);
        const std::size_t first = (cell / ((n[0] - 1) * (n[1] - 1)) * n[1] + y) * n[0] + x;
        for (const std::size_t up : {std::size_t(0), n[0] * n[1]})
            for (const std::size_t step : {std::size_t(0), std::size_t(1), n[0] + 1, n[0]})
                mesh.cells.push_back(number[first + up + step]);
    }
    return mesh;
}

// Without what is the solver's rounding.
Vec3 seen(Vec3 force, double total) {
    constexpr double rounding = 1e-7;
    const auto part = [&](double f) { return std::abs(f) < rounding * total ? 0.0 : f; };
    return {part(force.x), part(force.y), part(force.z)};
}

}  // namespace

void print_solid(const Console& console, const SolidCase& solid, const SolidAnswer& answer) {
    console.say("{}\n", console.strong(solid.title.empty() ? "Stress" : solid.title));
    console.say("  {} cubes of {:.3g} mm, {} nodes, {} iterations\n", cubes(answer),
                answer.grid.size, answer.nodes.size(), answer.iterations);
    console.say("  work of the loads  {:12.6g} N mm\n", answer.work);
    console.say("  moves at most      {:12.6g} mm\n", answer.largest);
    double total = 0;
    for (const BoxLoad& load : solid.loads) total += length(load.force);
    for (std::size_t i = 0; i < answer.reactions.size(); ++i) {
        const Vec3 r = seen(answer.reactions[i], total);
        console.say("  support {} gives    ({:.5g}, {:.5g}, {:.5g}) N\n", i + 1, r.x, r.y, r.z);
    }
    if (answer.probes.empty()) return;
    console.say(
        "\n  probe                          s1, s2, s3, MPa                  von Mises, MPa\n");
    for (const SolidProbe& probe : answer.probes) {
        const auto s = principal_values(probe.stress);
        console.say("  ({:6.4g}, {:6.4g}, {:6.4g}) {:10.4g} {:10.4g} {:10.4g} {:16.4g}\n",
                    probe.at.x, probe.at.y, probe.at.z, s[0], s[1], s[2], von_mises(probe.stress));
    }
}

Json solid_json(const SolidAnswer& answer) {
    Json reactions = Json::array(), probes = Json::array();
    for (std::size_t i = 0; i < answer.reactions.size(); ++i)
        reactions.push_back({{"support", i},
                             {"x_n", answer.reactions[i].x},
                             {"y_n", answer.reactions[i].y},
                             {"z_n", answer.reactions[i].z}});
    for (const SolidProbe& probe : answer.probes) {
        const Tensor3& t = probe.stress;
        const auto s = principal_values(t);
        probes.push_back({{"x", probe.at.x},
                          {"y", probe.at.y},
                          {"z", probe.at.z},
                          {"s1", s[0]},
                          {"s2", s[1]},
                          {"s3", s[2]},
                          {"von_mises", von_mises(t)},
                          {"stress_xx_yy_zz_xy_yz_zx", {t.xx, t.yy, t.zz, t.xy, t.yz, t.zx}},
                          {"ux", probe.displacement.x},
                          {"uy", probe.displacement.y},
                          {"uz", probe.displacement.z}});
    }
    return {{"work_n_mm", answer.work},    {"max_displacement_mm", answer.largest},
            {"reactions", reactions},      {"probes", probes},
            {"residual", answer.residual}, {"iterations", answer.iterations},
            {"element", "hex8"},           {"element_size_mm", answer.grid.size},
            {"elements", cubes(answer)},   {"nodes", answer.nodes.size()}};
}

void write_vtu(std::ostream& out, const SolidAnswer& answer) {
    VtuField moved{"displacement_mm", 3, {}}, first{"s1_mpa", 1, {}}, second{"s2_mpa", 1, {}};
    VtuField third{"s3_mpa", 1, {}};
    VtuField equivalent{"von_mises_mpa", 1, {}}, tensor{"stress_mpa", 6, {}};
    for (std::size_t k = 0; k < answer.nodes.size(); ++k) {
        const Vec3 u = answer.displacement[k];
        const Tensor3& t = answer.stress[k];
        const auto s = principal_values(t);
        moved.values.insert(moved.values.end(), {float(u.x), float(u.y), float(u.z)});
        tensor.values.insert(tensor.values.end(), {float(t.xx), float(t.yy), float(t.zz),
                                                   float(t.xy), float(t.yz), float(t.zx)});
        first.values.push_back(float(s[0]));
        second.values.push_back(float(s[1]));
        third.values.push_back(float(s[2]));
        equivalent.values.push_back(float(von_mises(t)));
    }
    write_vtu(out, mesh_of(answer), {moved, tensor, first, second, third, equivalent});
}

}  // namespace bead::cli
