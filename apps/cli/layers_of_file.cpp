#include "layers_of_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gcode/number.h"
#include "gcode/reader.h"
#include "gcode/slicer_notes.h"
#include "strength/printed_pixels.h"
#include "study/green_part.h"
#include "study/part_beads.h"
#include "toolpath/laid_layers.h"

namespace bead::cli {
namespace {

constexpr double usual_filament = 1.75;  // mm

// PrusaSlicer and its kin write the diameters of all extruders.
double filament_of(const std::string& file, const PrintedFileOptions& options) {
    if (options.filament > 0) return options.filament;
    const SlicerNotes notes = slicer_notes(file);
    const auto found = notes.settings.find("filament_diameter");
    if (found == notes.settings.end()) return usual_filament;
    const std::string& text = found->second;
    const double diameter = read_number(text.data(), text.data() + text.size(), false).value;
    return diameter > 0.1 && diameter < 20 ? diameter : usual_filament;
}

std::vector<Toolpath> sintered_layers(const std::string& file, const LoadCase& load_case,
                                      const PrintedFileOptions& options) {
    LaidLayers laid(filament_of(file, options),
                    load_case.print.layer_height * load_case.material.green_height);
    read_gcode(std::filesystem::path(file), [&](const Command& command) { laid.add(command); });
    std::vector<Toolpath> layers;
    for (LaidLayer& layer : std::move(laid).finished())
        layers.push_back(as_sintered(std::move(layer.paths), load_case.material));
    return layers;
}

[[noreturn]] void refuse_size(const std::string& file, const std::vector<Toolpath>& layers,
                              const LoadCase& load_case, const PrintedFileOptions& options) {
    const Vec2 laid = covered_box(layers).size(), part = bounds(load_case.part).size();
    const bool told = options.turn.has_value() || !options.origin.empty();
    throw Error(
        fmt::format("{}: what it prints ({:.1f} x {:.1f} mm) is not the case's part "
                    "({:.1f} x {:.1f} mm), {}",
                    file, laid.x, laid.y, part.x, part.y,
                    told ? "not where --turn and --origin say; leave them out to search"
                         : "however it is turned; print the case's outline"));
}

void check_height(const std::string& file, const std::vector<Toolpath>& layers, double thickness) {
    double height = 0, highest = 0;
    for (const Toolpath& layer : layers) {
        height += height_of(layer);
        highest = std::max(highest, height_of(layer));
    }
    if (std::abs(height - thickness) <= highest + 1e-6) return;
    throw Error(
        fmt::format("{}: its layers are {:.4g} mm high together, the case's part {:.4g} mm; print "
                    "it as thick or set thickness_mm",
                    file, height, thickness));
}

void note_left_out(PrintedFile& printed, const std::string& file, double left_out) {
    constexpr double worth_a_word = 1;  // mm³
    if (left_out > worth_a_word)
        printed.warnings.push_back(fmt::format(
            "{}: {:.0f} mm³ lie apart from the heaviest part and are left out", file, left_out));
}

void note_turn(PrintedFile& printed, const std::string& file, const PrintedFileOptions& options) {
    const double turn = printed.place.turn * 180 / pi;
    if (options.turn || (turn == 0 && !printed.place.mirrored)) return;
    printed.warnings.push_back(fmt::format("{}: stands {}turned by {:.4g}° on the bed; taken so",
                                           file, printed.place.mirrored ? "upside down, " : "",
                                           turn));
}

}  // namespace

void declare(CLI::App& command, PrintedFileOptions& options) {
    command
        .add_option("--filament", options.filament,
                    "mm, diameter; without it as the file says, else 1.75")
        ->check(CLI::Range(0.1, 20.0));
    command
        .add_option("--turn", options.turn,
                    "degrees by which the files' part stands turned on the bed, counter-clockwise; "
                    "without it that is found")
        ->check(CLI::Range(-360.0, 360.0));
    command
        .add_option("--origin", options.origin,
                    "mm, where on the bed the case's (0, 0) lies; without it that is found")
        ->type_name("X Y")
        ->expected(2)
        ->check(CLI::Range(-1e5, 1e5));
}

PrintedFile printed_file(const std::string& file, const LoadCase& load_case,
                         const PrintedFileOptions& options) {
    PartBeads beads = part_beads(sintered_layers(file, load_case, options));
    if (beads.layers.empty()) throw Error(file + ": lays no bead of a part; is it a print?");
    BedPlaceWish wish;
    if (options.turn) wish.turn = *options.turn * pi / 180;
    if (options.origin.size() == 2)
        wish.origin = Vec2{options.origin[0], options.origin[1]} / load_case.material.green_plane;
    const std::optional<BedPlace> place = bed_place(beads.layers, load_case.part, wish);
    if (!place) refuse_size(file, beads.layers, load_case, options);
    check_height(file, beads.layers, load_case.thickness);
    PrintedFile printed{in_case(*place, std::move(beads.layers)), *place, {}};
    printed.place.origin = load_case.material.green_plane * place->origin;
    note_left_out(printed, file, beads.left_out);
    note_turn(printed, file, options);
    return printed;
}

}  // namespace bead::cli
