#include "stress_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "fem/vtu.h"
#include "strength/load_variants.h"

namespace bead::cli {
namespace {

constexpr double degree = pi / 180;
constexpr double rounding = 1e-7;  // of the loads: reactions below are the solver's

std::string kind_words(const Sheet& sheet) {
    return sheet.mesh.kind == PlaneElement::t6 ? "triangles of 6 nodes" : "square pixels";
}

Json probe_json(const SheetProbe& probe) {
    const Principal p = principal(probe.stress);
    return {{"x", probe.at.x},
            {"y", probe.at.y},
            {"s1", p.first},
            {"s2", p.second},
            {"angle_deg", p.angle / degree},
            {"von_mises", von_mises(probe.stress)},
            {"ux", probe.displacement.x},
            {"uy", probe.displacement.y}};
}

Json answer_json(const SheetAnswer& answer) {
    Json reactions = Json::array(), probes = Json::array();
    for (std::size_t i = 0; i < answer.reactions.size(); ++i)
        reactions.push_back(
            {{"support", i}, {"x_n", answer.reactions[i].x}, {"y_n", answer.reactions[i].y}});
    for (const SheetProbe& probe : answer.probes) probes.push_back(probe_json(probe));
    return {{"work_n_mm", answer.work},    {"max_displacement_mm", answer.largest},
            {"reactions", reactions},      {"probes", probes},
            {"residual", answer.residual}, {"iterations", answer.iterations}};
}

struct Extremes {
    double tension = 0, compression = 0;
    Vec2 tension_at, compression_at;
};

Extremes extremes(const Sheet& sheet, const SheetAnswer& answer) {
    Extremes e;
    for (std::size_t n = 0; n < answer.stress.size(); ++n) {
        const Principal p = principal(answer.stress[n]);
        if (p.first > e.tension) {
            e.tension = p.first;
            e.tension_at = sheet.mesh.nodes[n];
        }
        if (p.second < e.compression) {
            e.compression = p.second;
            e.compression_at = sheet.mesh.nodes[n];
        }
    }
    return e;
}

void print_answer(const Console& console, const StressReport& report, std::size_t number) {
    const SheetAnswer& answer = report.sheet.answers[number];
    console.say("  work of the loads  {:12.6g} N mm\n", answer.work);
    console.say("  moves at most      {:12.6g} mm\n", answer.largest);
    const Extremes e = extremes(report.sheet, answer);
    console.say("  tension to         {:12.4g} MPa at ({:.4g}, {:.4g})\n", e.tension,
                e.tension_at.x, e.tension_at.y);
    console.say("  compression to     {:12.4g} MPa at ({:.4g}, {:.4g})\n", -e.compression,
                e.compression_at.x, e.compression_at.y);
    const double least = rounding * total_force(report.load_case.situations[number].loads);
    const auto seen = [&](double force) { return std::abs(force) < least ? 0.0 : force; };
    for (std::size_t i = 0; i < answer.reactions.size(); ++i)
        console.say("  support {} gives    ({:.5g}, {:.5g}) N\n", i + 1,
                    seen(answer.reactions[i].x), seen(answer.reactions[i].y));
    if (answer.probes.empty()) return;
    console.say("\n  probe                 s1, MPa    s2, MPa   angle, deg   von Mises, MPa\n");
    for (const SheetProbe& probe : answer.probes) {
        const Principal p = principal(probe.stress);
        console.say("  ({:7.5g}, {:7.5g}) {:10.4g} {:10.4g} {:12.1f} {:16.4g}\n", probe.at.x,
                    probe.at.y, p.first, p.second, p.angle / degree, von_mises(probe.stress));
    }
}

std::string factor_words(double factor) {
    return factor > 0 ? fmt::format("{:.4g} times the loads", factor) : "never";
}

void print_buckling(const Console& console, const SolidBuckling& buckling) {
    console.say(
        "  buckles            {} in its plane, {} out of it\n", factor_words(buckling.in_plane),
        buckling.sideways ? factor_words(*buckling.sideways) : std::string("nothing holds it"));
}

void append_buckling(Json& json, const SolidBuckling& buckling) {
    if (buckling.in_plane > 0) json["buckling_factor"] = buckling.in_plane;
    if (buckling.sideways && *buckling.sideways > 0)
        json["sideways_buckling_factor"] = *buckling.sideways;
}

std::vector<float> floats(const std::vector<PlaneTensor>& stress, double (*value)(PlaneTensor)) {
    std::vector<float> values;
    values.reserve(stress.size());
    for (const PlaneTensor& t : stress) values.push_back(float(value(t)));
    return values;
}

void append_fields(const SheetAnswer& answer, const std::string& ending,
                   std::vector<VtuField>& fields) {
    VtuField moved{"displacement_mm" + ending, 3, {}}, first{"s1_direction" + ending, 3, {}};
    VtuField tensor{"stress_mpa" + ending, 6, {}};
    for (std::size_t n = 0; n < answer.stress.size(); ++n) {
        const PlaneTensor& t = answer.stress[n];
        const Vec2 d = unit(principal(t).angle);
        moved.values.insert(moved.values.end(), {float(answer.displacement[2 * n]),
                                                 float(answer.displacement[2 * n + 1]), 0.0F});
        first.values.insert(first.values.end(), {float(d.x), float(d.y), 0.0F});
        tensor.values.insert(tensor.values.end(),
                             {float(t.xx), float(t.yy), 0.0F, float(t.xy), 0.0F, 0.0F});
    }
    fields.push_back(std::move(moved));
    fields.push_back(std::move(tensor));
    fields.push_back({"s1_mpa" + ending, 1,
                      floats(answer.stress, [](PlaneTensor t) { return principal(t).first; })});
    fields.push_back({"s2_mpa" + ending, 1,
                      floats(answer.stress, [](PlaneTensor t) { return principal(t).second; })});
    fields.push_back(std::move(first));
    fields.push_back({"von_mises_mpa" + ending, 1, floats(answer.stress, von_mises)});
}

}  // namespace

void print_stress(const Console& console, const StressReport& report) {
    console.say("{}\n",
                console.strong(report.load_case.title.empty() ? "Stress" : report.load_case.title));
    console.say("  {} elements, {} nodes, {} of {:.3g} mm\n", report.sheet.mesh.count(),
                report.sheet.mesh.nodes.size(), kind_words(report.sheet), report.sheet.size);
    if (report.change_by_mesh)
        console.say("  elements twice as large change the work by {:.2g} %\n",
                    100 * std::abs(*report.change_by_mesh));
    for (std::size_t s = 0; s < report.sheet.answers.size(); ++s) {
        if (report.sheet.answers.size() > 1)
            console.say("\nCase {}, weight {:g}\n", s + 1, report.load_case.situations[s].weight);
        print_answer(console, report, s);
        if (s < report.buckling.size()) print_buckling(console, report.buckling[s]);
    }
}

Json stress_json(const StressReport& report) {
    const std::vector<SheetAnswer>& answers = report.sheet.answers;
    Json result = answer_json(answers.front());
    if (!report.buckling.empty()) append_buckling(result, report.buckling.front());
    double work = 0, largest = 0;
    Json cases = Json::array();
    for (std::size_t s = 0; s < answers.size(); ++s) {
        const double weight = report.load_case.situations[s].weight;
        work += weight * answers[s].work;
        largest = std::max(largest, answers[s].largest);
        Json one{{"weight", weight}};
        one.update(answer_json(answers[s]));
        if (s < report.buckling.size()) append_buckling(one, report.buckling[s]);
        cases.push_back(std::move(one));
    }
    result["work_n_mm"] = answers.size() > 1 ? work : answers.front().work;
    result["max_displacement_mm"] = largest;
    if (report.change_by_mesh) result["work_change_by_mesh"] = *report.change_by_mesh;
    result["element"] = report.sheet.mesh.kind == PlaneElement::t6 ? "T6" : "Q4";
    result["element_size_mm"] = report.sheet.size;
    result["elements"] = report.sheet.mesh.count();
    result["nodes"] = report.sheet.mesh.nodes.size();
    if (answers.size() > 1) result["cases"] = std::move(cases);
    return result;
}

void write_vtu(std::ostream& out, const StressReport& report) {
    std::vector<VtuField> fields;
    for (std::size_t s = 0; s < report.sheet.answers.size(); ++s)
        append_fields(report.sheet.answers[s], s == 0 ? std::string() : fmt::format("_{}", s + 1),
                      fields);
    write_vtu(out, vtu_mesh(report.sheet.mesh), fields);
}

}  // namespace bead::cli
