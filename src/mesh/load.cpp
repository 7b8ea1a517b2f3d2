#include "mesh/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "core/error.h"
#include "mesh/facet.h"
#include "mesh/gunzip.h"
#include "mesh/obj.h"
#include "mesh/stl.h"
#include "mesh/three_mf.h"

namespace bead {
namespace {

constexpr std::size_t most_bytes = std::size_t{2} << 30U;  // unpacked; 43 million STL triangles
constexpr double most_mm = 1e5;  // no printer is that large: the unit is wrong or the file is

struct Format {
    std::string_view ending;
    ParsedMesh (*parse)(std::string_view bytes, std::string_view name);
};
constexpr Format formats[] = {
    {".stl", parse_stl},
    {".obj", parse_obj},
    {".3mf", parse_three_mf},
};

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

const Format& format_of(std::string_view name) {
    std::string ending = lower_case(name);
    if (ending.ends_with(".gz")) ending.resize(ending.size() - 3);
    for (const Format& format : formats)
        if (ending.ends_with(format.ending)) return format;
    throw Error(
        fmt::format("{}: not a mesh by its name; use .stl, .obj or .3mf (or .gz of it)", name));
}

std::string content(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code fault;
    if (!std::filesystem::exists(file, fault))
        throw Error(name + ": no such file; is its path right?");
    if (!std::filesystem::is_regular_file(file, fault))
        throw Error(name + ": not a file; name the mesh itself");
    const std::uintmax_t size = std::filesystem::file_size(file, fault);
    if (fault || size > most_bytes)
        throw Error(
            fmt::format("{}: larger than the {} MB that are read; leave out what is not printed, "
                        "or use fewer triangles",
                        name, most_bytes >> 20U));
    std::string bytes(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw Error(name + ": cannot be read; check its permissions");
    return bytes;
}

// Points that no triangle uses would count in the bounds.
void drop_unused_points(Mesh& mesh) {
    std::vector<int> place(mesh.points.size(), -1);
    for (const auto& triangle : mesh.triangles)
        for (const int corner : triangle) place[static_cast<std::size_t>(corner)] = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] < 0) continue;
        place[i] = static_cast<int>(used);
        mesh.points[used++] = mesh.points[i];
    }
    if (used == place.size()) return;
    mesh.points.resize(used);
    for (auto& triangle : mesh.triangles)
        for (int& corner : triangle) corner = place[static_cast<std::size_t>(corner)];
}

void scale(Mesh& mesh, double factor) {
    for (Vec3& p : mesh.points) p = factor * p;
}

void demand_usable(const Mesh& mesh, std::string_view name) {
    const auto fail = [&](std::string_view what) {
        throw Error(fmt::format("{}: {}", name, what));
    };
    if (mesh.triangles.empty()) fail("holds no triangles");
    double farthest = 0;
    for (const Vec3& p : mesh.points) {
        const double off = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        if (!std::isfinite(p.x + p.y + p.z)) fail("has coordinates that are not finite numbers");
        farthest = std::max(farthest, off);
    }
    if (farthest > most_mm)
        fail(fmt::format("reaches out to {:.3g} mm; give the file's unit by --units", farthest));
    if (bounds(mesh).size().z <= 0) fail("has no height; a flat mesh cannot be printed");
    if (std::ranges::none_of(mesh.triangles, [&](const auto& t) { return has_area(mesh, t); }))
        fail("has only triangles without area");
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& file, std::optional<double> unit_mm) {
    return parse_mesh(content(file), file.string(), unit_mm);
}

Mesh parse_mesh(std::string_view bytes, std::string_view name, std::optional<double> unit_mm) {
    const Format& format = format_of(name);
    if (bytes.empty()) throw Error(fmt::format("{}: is empty", name));
    ParsedMesh parsed = is_gzip(bytes) ? format.parse(gunzipped(bytes, name, most_bytes), name)
                                       : format.parse(bytes, name);
    drop_unused_points(parsed.mesh);
    scale(parsed.mesh, unit_mm.value_or(parsed.unit_mm));
    demand_usable(parsed.mesh, name);
    return std::move(parsed.mesh);
}

}  // namespace bead
