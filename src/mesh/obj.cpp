#include "mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "mesh/text.h"
#include "mesh/weld.h"

namespace bead {
namespace {

struct Place {
    std::string_view name;
    long line = 0;
};

[[noreturn]] void fail(const Place& place, std::string_view what) {
    throw Error(fmt::format("{}:{}: {}", place.name, place.line, what));
}

Vec3 point(Words& words, const Place& place) {
    std::array<double, 3> xyz{};
    for (double& value : xyz) {
        const std::string_view word = words.next();
        const auto parsed = number(word);
        if (!parsed) fail(place, fmt::format("expected a coordinate, got '{:.20}'", word));
        value = *parsed;
    }
    return {xyz[0], xyz[1], xyz[2]};
}

// "7", "7/1", "7//3" or "7/1/3": counted from 1, or back from the latest point if negative.
// Whether the point exists is known only at the file's end.
int corner(std::string_view word, std::size_t points_so_far, const Place& place) {
    const char* const end = word.data() + std::min(word.find('/'), word.size());
    int number = 0;
    const auto [stop, fault] = std::from_chars(word.data(), end, number);
    if (fault != std::errc{} || stop != end || number == 0)
        fail(place, fmt::format("expected the number of a point, got '{:.20}'", word));
    if (number > 0) return number - 1;
    if (-static_cast<long>(number) > static_cast<long>(points_so_far))
        fail(place, fmt::format("'{:.20}' counts back beyond the first point", word));
    return static_cast<int>(points_so_far) + number;
}

void add_face(Mesh& mesh, Words& words, const Place& place) {
    std::vector<int> corners;
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
        corners.push_back(corner(word, mesh.points.size(), place));
    if (corners.size() < 3) fail(place, "a face needs three corners");
    for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

void weld(Mesh& mesh, std::string_view name) {
    Welder welder(mesh.points.size());
    std::vector<int> index;
    index.reserve(mesh.points.size());
    for (const Vec3& p : mesh.points) index.push_back(welder.index(p));
    for (auto& triangle : mesh.triangles)
        for (int& c : triangle) {
            if (static_cast<std::size_t>(c) >= index.size())
                throw Error(fmt::format("{}: a face refers to point {}, but there are only {}",
                                        name, c + 1L, index.size()));
            c = index[static_cast<std::size_t>(c)];
        }
    mesh.points = std::move(welder).points();
}

}  // namespace

ParsedMesh parse_obj(std::string_view bytes, std::string_view name) {
    Mesh mesh;
    Place place{name, 0};
    while (!bytes.empty()) {
        ++place.line;
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        Words words(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        const std::string_view kind = words.next();
        if (kind == "v") mesh.points.push_back(point(words, place));
        if (kind == "f") add_face(mesh, words, place);
    }
    weld(mesh, name);
    return {std::move(mesh)};
}

}  // namespace bead
