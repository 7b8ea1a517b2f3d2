// beadwork stress: displacements and stresses of a part under load, by finite elements.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "geom/polygon.h"
#include "job/case_file.h"
#include "options.h"
#include "solid_stress_report.h"
#include "stress_picture.h"
#include "stress_report.h"

namespace bead::cli {
namespace {

struct StressCall {
    std::string file, vtu, picture, elements = "auto";
    double size = 0;
    int most = 500;
    bool buckling = false;
    OutputOptions output;
};

const std::map<std::string, Elements> element_names{{"auto", Elements::automatic},
                                                    {"triangles", Elements::triangles},
                                                    {"pixels", Elements::pixels}};

template <class Write>
void write_asked(const std::string& place, const Write& write_to) {
    if (place.empty()) return;
    OutputFile file(place);
    write_to(file.stream());
    file.keep();
}

void check_converged(const std::string& file, bool converged, double residual, int iterations) {
    if (converged) return;
    throw Error(fmt::format("{}: not solved: after {} iterations {:.1e} of the load is still out "
                            "of balance; allow more (--iterations) or use larger elements (--h)",
                            file, iterations, residual),
                Fault::not_converged);
}

// How much the mesh matters: the same on elements twice as large.
std::optional<double> change_by_mesh(const LoadCase& load_case, const Sheet& sheet,
                                     const SheetOptions& options) {
    SheetOptions coarser = options;
    coarser.size = 2 * sheet.size;
    if (sheet.mesh.kind == PlaneElement::q4) coarser.elements = Elements::pixels;
    const Sheet coarse = solved_sheet(load_case, coarser);
    if (coarse.failure || !coarse.answers.front().converged) return std::nullopt;
    const double work = sheet.answers.front().work;
    return work > 0 ? (work - coarse.answers.front().work) / work : 0;
}

std::vector<SolidBuckling> buckling_of(const LoadCase& load_case) {
    std::vector<SolidBuckling> found;
    for (std::size_t s = 0; s < load_case.situations.size(); ++s)
        found.push_back(solid_buckling(load_case, s));
    return found;
}

// Refused before the machine runs out of memory.
void expect_tractable(const StressCall& options, double elements, double bytes_per_element) {
    constexpr double most_bytes = 16e9;
    if (elements * bytes_per_element <= most_bytes) return;
    throw Error(
        fmt::format("{}: --h {:g}: {:.3g} million elements, some {:.3g} GB; give larger ones",
                    options.file, options.size, elements / 1e6,
                    elements * bytes_per_element * 1e-9),
        Fault::infeasible);
}

void stress_plane(const LoadCase& load_case, const StressCall& options) {
    const Console console = console_of(options.output);
    const double squares = area(load_case.part) / (options.size * options.size);
    if (options.size > 0 && options.elements == "triangles")
        expect_tractable(options, 2.3 * squares, 6000);
    if (options.size > 0) expect_tractable(options, squares, 300);
    const SheetOptions how{
        .size = options.size, .elements = element_names.at(options.elements), .most = options.most};
    const Sheet sheet = solved_sheet(load_case, how);
    if (sheet.failure) throw Error(options.file + ": " + *sheet.failure);
    for (const SheetAnswer& answer : sheet.answers)
        check_converged(options.file, answer.converged, answer.residual, answer.iterations);
    const StressReport report{
        load_case, sheet, change_by_mesh(load_case, sheet, how),
        options.buckling ? buckling_of(load_case) : std::vector<SolidBuckling>{}};
    print_stress(console, report);
    write_asked(options.vtu, [&](std::ostream& out) { write_vtu(out, report); });
    write_asked(options.picture,
                [&](std::ostream& out) { out << stress_picture(load_case, sheet); });
    if (options.output.json.empty()) return;
    Json result = result_head("stress", {options.file});
    result.update(stress_json(report));
    write_result(options.output.json, result);
}

void stress_solid(const SolidCase& solid, const StressCall& options) {
    if (!options.picture.empty())
        throw Error("--picture: draws cases of the plane; look at -o OUT.vtu instead",
                    Fault::usage);
    for (const auto& [is_given, name] : {std::pair{options.buckling, "--buckling"},
                                         std::pair{options.elements != "auto", "--elements"}})
        if (is_given)
            throw Error(fmt::format("{}: is for cases of the plane; this one is of a mesh and "
                                    "boxes, leave it out",
                                    name),
                        Fault::usage);
    const Vec3 box = bounds(solid.mesh).size();
    if (options.size > 0)
        expect_tractable(options, box.x * box.y * box.z / std::pow(options.size, 3), 300);
    const Console console = console_of(options.output);
    const SolidAnswer answer = solved_solid(solid, {.size = options.size, .most = options.most});
    if (answer.failure) throw Error(options.file + ": " + *answer.failure);
    check_converged(options.file, answer.converged, answer.residual, answer.iterations);
    print_solid(console, solid, answer);
    write_asked(options.vtu, [&](std::ostream& out) { write_vtu(out, answer); });
    if (options.output.json.empty()) return;
    Json result = result_head("stress", {options.file});
    result.update(solid_json(answer));
    write_result(options.output.json, result);
}

void stress(const StressCall& options) {
    const AnyCase any = read_case(options.file);
    if (const auto* solid = std::get_if<SolidCase>(&any))
        stress_solid(*solid, options);
    else
        stress_plane(std::get<LoadCase>(any), options);
}

}  // namespace

void add_stress(CLI::App& app) {
    const auto options = std::make_shared<StressCall>();
    CLI::App& command =
        *app.add_subcommand("stress", "displacements and stresses of a part under load");
    command.footer(
        "Example: where is the bracket in tension, and in which direction?\n"
        "  beadwork stress examples/cases/bracket.toml --picture bracket.svg -o bracket.vtu");
    command.add_option("CASE", options->file, "CASE.toml: a part, its supports and loads")
        ->required();
    command.add_option("-o,--output", options->vtu, "write the fields for ParaView")
        ->type_name("OUT.vtu");
    command.add_option("--picture", options->picture, "draw the principal stresses")
        ->type_name("OUT.svg");
    command.add_option("--h", options->size, "mm, size of elements; 0: chosen by the part's area")
        ->check(CLI::Range(0.0, 1e5));
    command.add_option("--elements", options->elements, "auto, triangles or pixels")
        ->check(CLI::IsMember({"auto", "triangles", "pixels"}))
        ->capture_default_str();
    command.add_option("--iterations", options->most, "at most, where the solver iterates")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_flag("--buckling", options->buckling,
                     "also when the solid part buckles, in its plane and out of it");
    declare(command, options->output);
    command.callback([options] { stress(*options); });
}

}  // namespace bead::cli
