#include "job/case_file.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "geom/clip.h"
#include "job/case_checks.h"
#include "job/data_file.h"
#include "job/outline_svg.h"
#include "job/solid_material_file.h"
#include "job/toml_reader.h"
#include "mesh/load.h"
#include "slice/slice.h"
#include "toolpath/path.h"

namespace bead {
namespace {

constexpr double flatness = 0.002;  // mm, of the polygons that stand for circles
constexpr double radian = pi / 180;
constexpr double farthest = 1e5;  // mm
constexpr Range places{.low = -farthest, .high = farthest};
constexpr Range widths{.low = 0.01, .high = 1000}, heights{.low = 0.01, .high = 1000};  // mm
constexpr Range fill_range{.low = 0, .high = 1, .open_low = true};

Vec2 point(std::array<double, 2> xy) { return {xy[0], xy[1]}; }

// A polygon of the file; points that repeat the one before, and a last one that repeats the first,
// go.
Polyline loop_of(TomlReader& file, const std::string& key,
                 const std::vector<std::array<double, 2>>& pairs) {
    Polyline loop;
    for (const std::array<double, 2>& pair : pairs)
        if (loop.empty() || loop.back() != point(pair)) loop.push_back(point(pair));
    if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    if (loop.size() < 3) file.refuse(key, "needs at least 3 different points");
    if (is_flat(loop)) file.refuse(key, "has no area; its points lie on one line");
    if (const auto place = self_crossing(loop))
        file.refuse(key,
                    fmt::format("crosses itself at ({:.4g}, {:.4g}); give its points in order, "
                                "once round",
                                place->x, place->y));
    return loop;
}

Polyline circle_loop(const Circle& circle) {
    const double step = 2 * std::acos(1 - std::min(0.05, flatness / circle.radius));
    const int count = 4 * std::max(16, int(std::ceil(pi / 2 / step)));
    Polyline loop;
    for (int i = 0; i < count; ++i)
        loop.push_back(circle.centre + circle.radius * unit(2 * pi * i / count));
    return loop;
}

std::string beside(const std::string& name, const std::string& file) {
    return (std::filesystem::path(name).parent_path() / file).string();
}

// `material.name` is one of those that are built in, or a file beside the case's.
std::string material_name(TomlReader& file, const std::string& name) {
    const std::string material = file.text("material.name", "");
    return material.ends_with(".toml") ? beside(name, material) : material;
}

template <class Load>
auto named_material(TomlReader& file, const Load& load, const std::string& material) {
    try {
        return load(material);
    } catch (const Error& error) {
        file.refuse("material.name", std::string("= \"") + material + "\": " + error.what());
    }
}

SolidMaterial read_material(TomlReader& file, const std::string& name) {
    const std::string named = material_name(file, name);
    SolidMaterial m;
    if (!named.empty()) m = named_material(file, load_solid_material, named);
    m.young = file.number("material.young_mpa", m.young, solid_mpa);
    m.poisson = file.number("material.poisson", m.poisson, {.low = 0, .high = 0.49});
    m.tensile = file.number("material.tensile_mpa", m.tensile, solid_mpa);
    m.compressive = file.number("material.compressive_mpa", m.compressive, solid_mpa);
    m.density = file.number("material.density_g_cm3", m.density, solid_density);
    constexpr Range scales{.low = 0.5, .high = 2};
    m.green_plane = file.number("material.green_scale_plane", m.green_plane, scales);
    m.green_height = file.number("material.green_scale_height", m.green_height, scales);
    return m;
}

std::optional<PrintHeat> read_heat(TomlReader& file, const std::string& name) {
    const std::string named = material_name(file, name);
    std::optional<PrintHeat> heat;
    if (!named.empty()) heat = named_material(file, load_print_heat, named);
    const bool told = file.place_of("material.hotend_c") && file.place_of("material.bed_c");
    if (!heat && !told) {
        for (const char* key : {"material.hotend_c", "material.bed_c"})
            if (file.place_of(key))
                file.refuse(key, "stands alone; give hotend_c and bed_c, or name");
        return heat;
    }
    if (!heat) heat.emplace();
    constexpr Range celsius{.low = 0, .high = 600};
    const double hotend = file.number("material.hotend_c", heat->hotend, celsius);
    if (file.place_of("material.hotend_c")) heat->hotend_first = hotend;
    heat->hotend = hotend;
    heat->bed = file.number("material.bed_c", heat->bed, celsius);
    return heat;
}

PrintWish read_print(TomlReader& file, const std::string& name) {
    constexpr std::string_view sections[] = {"rectangle", "stadium"};
    PrintWish p;
    p.bead_width = file.number("print.bead_width_mm", p.bead_width, widths);
    p.layer_height = file.number("print.layer_height_mm", p.layer_height, heights);
    if (file.choice("print.section", 0, sections) == 1) {
        if (p.bead_width < p.layer_height)
            file.refuse("print.section",
                        "= \"stadium\" needs beads at least as wide as high; give "
                        "a wider bead_width_mm or a lower layer_height_mm");
        p.bead_width = spacing({p.bead_width, p.layer_height});
    }
    p.fill = file.number("print.fill", p.fill, fill_range);
    p.walls = file.integer("print.walls", p.walls, {.low = 0, .high = 100});
    p.heat = read_heat(file, name);
    return p;
}

Circle read_circle(TomlReader& file, const std::string& key) {
    Circle circle;
    if (!file.place_of(key + ".center")) file.refuse(key, "has no center = [x, y]");
    circle.centre = point(file.numbers<2>(key + ".center", {}, places));
    circle.radius = file.number(key + ".radius", 0, {0, farthest, true});
    if (circle.radius == 0) file.refuse(key, "has no radius");
    return circle;
}

Stretch read_stretch(TomlReader& file, const std::string& key) {
    Stretch stretch;
    if (file.place_of(key + ".on")) {
        CircleArc arc{.circle = read_circle(file, key + ".on")};
        const auto degrees = file.numbers<2>(key + ".arc_deg", {0, 360}, {-720, 720});
        arc.begin = degrees[0] * radian;
        arc.end = degrees[1] * radian;
        while (arc.end <= arc.begin) arc.end += 2 * pi;
        if (arc.end > arc.begin + 2 * pi + 1e-9)
            file.refuse(key + ".arc_deg", "goes round more than once");
        stretch.arc = arc;
        return stretch;
    }
    for (const char* end : {".from", ".to"})
        if (!file.place_of(key + end))
            file.refuse(key, fmt::format("has no {}; give from and to, or on", end + 1));
    stretch.from = point(file.numbers<2>(key + ".from", {}, places));
    stretch.to = point(file.numbers<2>(key + ".to", {}, places));
    return stretch;
}

Support read_support(TomlReader& file, const std::string& key) {
    constexpr std::string_view words[] = {"xy", "x", "y"};
    Support support;
    support.on = read_stretch(file, key);
    const std::size_t fix = file.choice(key + ".fix", 0, words);
    support.x = fix != 2;
    support.y = fix != 1;
    return support;
}

Load read_load(TomlReader& file, const std::string& key) {
    Load load;
    load.on = read_stretch(file, key);
    if (!file.place_of(key + ".force_n")) file.refuse(key, "has no force_n = [x, y]");
    load.force = point(file.numbers<2>(key + ".force_n", {}, {-1e9, 1e9}));
    load.bearing = file.flag(key + ".bearing", false);
    if (load.bearing && !load.on.arc)
        file.refuse(key + ".bearing", "needs on = {center, radius}: a pin is round");
    load.turn = radian * file.number(key + ".turn_deg", 0, {.low = 0, .high = 180});
    load.move = file.number(key + ".move_mm", 0, {.low = 0, .high = farthest});
    return load;
}

// `prefix` is "" for the one at the top, "case[2]." for one of several.
Situation read_situation(TomlReader& file, const std::string& prefix) {
    Situation situation;
    const std::size_t supports = file.tables(prefix + "support");
    for (std::size_t i = 0; i < supports; ++i)
        situation.supports.push_back(read_support(file, fmt::format("{}support[{}]", prefix, i)));
    const std::size_t loads = file.tables(prefix + "load");
    for (std::size_t i = 0; i < loads; ++i)
        situation.loads.push_back(read_load(file, fmt::format("{}load[{}]", prefix, i)));
    return situation;
}

std::vector<Situation> read_situations(TomlReader& file) {
    std::vector<Situation> situations;
    const std::size_t cases = file.tables("case");
    for (std::size_t i = 0; i < cases; ++i) {
        const std::string key = fmt::format("case[{}].", i);
        situations.push_back(read_situation(file, key));
        situations.back().weight = file.number(key + "weight", 1, positive);
    }
    if (cases > 0) return situations;
    return {read_situation(file, "")};
}

// The section half-way up; low and high up it must be the same. The mesh's height is the part's
// thickness.
Region section_of(TomlReader& file, const Mesh& mesh, double& thickness) {
    constexpr double same = 0.01;  // of the area
    thickness = bounds(mesh).size().z;
    const double layer = thickness / 5;
    const Slices slices =
        slice(mesh, {.layer_height = layer, .first_layer_height = layer, .threads = 1});
    if (slices.layers.size() < 5) return {};
    const Region& middle = slices.layers[2].region;
    for (const std::size_t k : {0U, 4U}) {
        const Region& other = slices.layers[k].region;
        const double off = area(difference(middle, other)) + area(difference(other, middle));
        if (off > same * area(middle))
            file.refuse("model",
                        fmt::format("has no constant section: {:.3g} mm up it differs from that "
                                    "half-way up by {:.3g} of {:.4g} mm²; extrude one outline",
                                    (double(k) + 0.5) * layer, off, area(middle)));
    }
    return middle;
}

Region read_part(TomlReader& file, const std::string& name, double& thickness) {
    const std::string svg = file.text("outline_svg", ""), model = file.text("model", "");
    const int ways =
        int(file.place_of("outline").has_value()) + int(!svg.empty()) + int(!model.empty());
    if (ways != 1)
        file.refuse("outline", ways == 0 ? "is missing; or give outline_svg or model"
                                         : "cannot stand beside outline_svg or model");
    if (!model.empty()) return section_of(file, load_mesh(beside(name, model)), thickness);
    if (!svg.empty()) {
        const DataFile text = file_on_disk("outline", beside(name, svg));
        return outline_of_svg(text.text, text.place);
    }
    return region_of({loop_of(file, "outline", file.pairs("outline", places))}, FillRule::even_odd);
}

void cut_holes(TomlReader& file, LoadCase& result) {
    const auto cut = [&](const Polyline& loop, const std::string& key) {
        const Region hole = region_of({loop}, FillRule::even_odd);
        if (area(hole) < 1e-6) file.refuse(key, "is too small to be a hole; leave it out");
        if (area(intersection(result.part, hole)) < 1e-6)
            file.refuse(key, "lies outside the part; move it or leave it out");
        result.part = difference(result.part, hole);
    };
    const auto holes = file.pair_lists("holes", places);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const std::string key = fmt::format("holes[{}]", i);
        cut(loop_of(file, key, holes[i]), key);
    }
    const std::size_t circles = file.tables("circles");
    for (std::size_t i = 0; i < circles; ++i) {
        const std::string key = fmt::format("circles[{}]", i);
        result.circles.push_back(read_circle(file, key));
        cut(circle_loop(result.circles.back()), key);
    }
}

const char* source_of(TomlReader& file) {
    for (const char* key : {"outline_svg", "model"})
        if (file.place_of(key)) return key;
    return "outline";
}

std::string pieces_words(const Region& part) {
    if (part.empty())
        return "leaves nothing of the part; give an outline with area, and holes smaller than it";
    const auto less = [](const Polygon& a, const Polygon& b) { return area(a) < area(b); };
    const Polygon& least = *std::ranges::min_element(part, less);
    const Vec2 place = bounds(least.outer).centre();
    return fmt::format(
        "leaves {} separate pieces, one of {:.3g} mm² about ({:.4g}, {:.4g}); a case is one part",
        part.size(), area(least), place.x, place.y);
}

LoadCase plane_case(TomlReader& file, const std::string& name) {
    LoadCase result;
    result.title = file.text("title", "");
    double thickness = 0;
    result.part = read_part(file, name, thickness);
    cut_holes(file, result);
    if (result.part.size() != 1) file.refuse(source_of(file), pieces_words(result.part));
    if (thickness == 0 && !file.place_of("thickness_mm")) file.refuse("thickness_mm", "is missing");
    constexpr Range thick{.low = 0, .high = farthest, .open_low = true};
    result.thickness = file.number("thickness_mm", thickness, thick);
    if (file.place_of("guided")) result.guided = file.flag("guided", false);
    result.material = read_material(file, name);
    result.print = read_print(file, name);
    result.situations = read_situations(file);
    for (std::size_t i = 0; i < file.tables("probe"); ++i) {
        const std::string key = fmt::format("probe[{}]", i);
        if (!file.place_of(key + ".at")) file.refuse(key, "has no at = [x, y]");
        result.probes.push_back(point(file.numbers<2>(key + ".at", {}, places)));
    }
    const bool several = file.tables("case") > 0;
    if (several && (file.tables("load") > 0 || file.tables("support") > 0))
        file.refuse("case",
                    "cannot stand beside load or support at the top; move them into a case");
    file.finish();
    check_boundary(file, result);
    if (file.place_of("print")) check_printable(result, name);
    return result;
}

Box3 read_box(TomlReader& file, const std::string& key) {
    const auto corners = file.number_lists(key, 2, 3, places);
    Box3 box;
    for (const std::vector<double>& corner : corners)
        box.include({corner[0], corner[1], corner[2]});
    return box;
}

SolidCase solid_case(TomlReader& file, const std::string& name) {
    SolidCase result;
    result.title = file.text("title", "");
    result.mesh = load_mesh(beside(name, file.text("model", "")));
    result.material = read_material(file, name);
    for (std::size_t i = 0; i < file.tables("support"); ++i) {
        const std::string key = fmt::format("support[{}]", i);
        constexpr std::string_view words[] = {"xyz", "x", "y", "z", "xy", "xz", "yz"};
        if (!file.place_of(key + ".box")) file.refuse(key, "has no box, as others have");
        const std::string_view fix = words[file.choice(key + ".fix", 0, words)];
        const auto holds = [&](char axis) { return fix.find(axis) != fix.npos; };
        result.supports.push_back(
            {read_box(file, key + ".box"), holds('x'), holds('y'), holds('z')});
    }
    for (std::size_t i = 0; i < file.tables("load"); ++i) {
        const std::string key = fmt::format("load[{}]", i);
        if (!file.place_of(key + ".box")) file.refuse(key, "has no box, as others have");
        if (!file.place_of(key + ".force_n")) file.refuse(key, "has no force_n = [x, y, z]");
        const auto force = file.numbers<3>(key + ".force_n", {}, {-1e9, 1e9});
        result.loads.push_back({read_box(file, key + ".box"), {force[0], force[1], force[2]}});
    }
    for (std::size_t i = 0; i < file.tables("probe"); ++i) {
        const std::string key = fmt::format("probe[{}]", i);
        if (!file.place_of(key + ".at")) file.refuse(key, "has no at = [x, y, z]");
        const auto at = file.numbers<3>(key + ".at", {}, places);
        result.probes.push_back({at[0], at[1], at[2]});
    }
    read_print(file, name);
    file.number("thickness_mm", 0, positive);
    file.finish();
    check_boxes(file, result);
    return result;
}

bool has_boxes(TomlReader& file) {
    for (const char* table : {"support", "load"})
        for (std::size_t i = 0; i < file.tables(table); ++i)
            if (file.place_of(fmt::format("{}[{}].box", table, i))) return true;
    return false;
}

}  // namespace

AnyCase parsed_case(std::string_view text, const std::string& name) {
    {
        TomlReader probe(text, name);
        if (has_boxes(probe)) {
            TomlReader file(text, name);
            if (!file.place_of("model"))
                file.refuse("model", "is missing; a case with boxes is one of a mesh");
            return solid_case(file, name);
        }
    }
    TomlReader file(text, name);
    return plane_case(file, name);
}

AnyCase read_case(const std::string& file) {
    const DataFile text = file_on_disk("case", file);
    return parsed_case(text.text, text.place);
}

LoadCase read_plane_case(const std::string& file) {
    AnyCase any = read_case(file);
    if (std::holds_alternative<SolidCase>(any))
        throw Error(file +
                    ": is a case in space (boxes); give stretches of an outline, from and to");
    return std::get<LoadCase>(std::move(any));
}

namespace {

// The largest piece of the part that no bead gets into.
Polygon largest_lost(const Region& part, const Region& kept, double width) {
    Polygon largest{part.front().outer, {}};
    double most = 0;
    for (const Polygon& piece : difference(part, offset(kept, 0.05 * width)))
        if (area(piece) > most) {
            most = area(piece);
            largest = piece;
        }
    return largest;
}

}  // namespace

void check_printable(const LoadCase& load_case, const std::string& name) {
    constexpr double highest = 1.5;  // of the thickness: what rounds to one layer
    if (load_case.print.layer_height > highest * load_case.thickness)
        throw Error(
            fmt::format("{}: print.layer_height_mm is {:g}, the part {:g} mm thick; make "
                        "layers lower",
                        name, load_case.print.layer_height, load_case.thickness));
    const double width = load_case.print.bead_width;
    const Region kept = opened(load_case.part, 0.499 * width);
    if (kept.size() == load_case.part.size()) return;
    const Vec2 place = bounds(largest_lost(load_case.part, kept, width).outer).centre();
    throw Error(
        fmt::format("{}: the part is thinner than a bead ({:g} mm) near ({:.4g}, {:.4g}); "
                    "make it thicker or print.bead_width_mm smaller",
                    name, width, place.x, place.y));
}

std::optional<std::string> unprinted_words(const LoadCase& load_case) {
    constexpr double worth_a_word = 2;  // squares of a bead's width
    const double width = load_case.print.bead_width;
    const Region kept = offset(opened(load_case.part, 0.499 * width), 0.05 * width);
    if (area(difference(load_case.part, kept)) < worth_a_word * width * width) return std::nullopt;
    const Polygon lost = largest_lost(load_case.part, opened(load_case.part, 0.499 * width), width);
    if (area(lost) < worth_a_word * width * width) return std::nullopt;
    const Vec2 place = bounds(lost.outer).centre();
    return fmt::format(
        "{:.3g} mm² of the part near ({:.4g}, {:.4g}) are thinner than a bead "
        "({:g} mm) and will not be printed",
        area(lost), place.x, place.y, width);
}

}  // namespace bead
