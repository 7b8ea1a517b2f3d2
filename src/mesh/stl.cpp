#include "mesh/stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "mesh/text.h"
#include "mesh/weld.h"

namespace bead {
namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of comment and the number of triangles
constexpr std::size_t facet_size = 50;   // normal, three corners, two spare bytes

static_assert(std::endian::native == std::endian::little,
              "binary STL is read as it lies in memory");

template <class Value>
Value read_as(const char* place) {
    Value value;
    std::memcpy(&value, place, sizeof value);
    return value;
}

std::size_t promised_size(std::string_view bytes) {
    return header_size + facet_size * read_as<std::uint32_t>(bytes.data() + header_size - 4);
}

// Binary files may start with "solid" too. They have zero bytes early on, text has none.
bool is_ascii(std::string_view bytes) {
    constexpr std::size_t look_at = 1024;
    if (bytes.size() >= header_size && bytes.size() == promised_size(bytes)) return false;
    Words words(bytes.substr(0, look_at));
    const std::string_view first = words.next();
    return (first.starts_with("solid") || first.starts_with("SOLID")) &&
           bytes.substr(0, look_at).find('\0') == std::string_view::npos;
}

Vec3 corner_at(const char* place) {
    return {read_as<float>(place), read_as<float>(place + 4), read_as<float>(place + 8)};
}

Mesh parse_binary(std::string_view bytes, std::string_view name) {
    if (bytes.size() < header_size)
        throw Error(
            fmt::format("{}: {} bytes are too few for an STL file; is the download complete?", name,
                        bytes.size()));
    if (bytes.size() < promised_size(bytes))
        throw Error(
            fmt::format("{}: truncated or not STL: the header promises {} bytes, there are {}",
                        name, promised_size(bytes), bytes.size()));
    Mesh mesh;
    mesh.triangles.resize((promised_size(bytes) - header_size) / facet_size);
    Welder welder(mesh.triangles.size() * 3 / 5);
    const char* place = bytes.data() + header_size;
    for (auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = welder.index(corner_at(place + 12 * (k + 1)));
        place += facet_size;
    }
    mesh.points = std::move(welder).points();
    return mesh;
}

bool says(std::string_view word, std::string_view keyword) {
    return std::ranges::equal(word, keyword, [](char a, char b) {
        return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
    });
}

double coordinate(Words& words, std::string_view name) {
    const std::string_view word = words.next();
    if (const auto value = number(word)) return *value;
    throw Error(
        fmt::format("{}:{}: expected a coordinate, got '{:.20}'", name, words.line(), word));
}

Vec3 corner(Words& words, std::string_view name) {
    const double x = coordinate(words, name);
    const double y = coordinate(words, name);
    return {x, y, coordinate(words, name)};
}

// Only vertex, endfacet and endsolid matter; a name after solid may hold any word.
Mesh parse_ascii(std::string_view bytes, std::string_view name) {
    Mesh mesh;
    Welder welder(bytes.size() / 400);
    Words words(bytes);
    std::array<int, 3> triangle{};
    std::size_t corners = 0;
    bool complete = false;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (says(word, "vertex")) {
            const int index = welder.index(corner(words, name));
            if (corners < 3) triangle[corners] = index;
            ++corners;
        } else if (says(word, "endfacet")) {
            if (corners != 3)
                throw Error(fmt::format("{}:{}: a facet of {} corners; STL has three", name,
                                        words.line(), corners));
            mesh.triangles.push_back(triangle);
            corners = 0;
        } else if (says(word, "solid") || says(word, "endsolid")) {
            complete = says(word, "endsolid");
            words.skip_line();
        }
    }
    if (!complete) throw Error(fmt::format("{}: truncated: it ends without 'endsolid'", name));
    mesh.points = std::move(welder).points();
    return mesh;
}

}  // namespace

ParsedMesh parse_stl(std::string_view bytes, std::string_view name) {
    return {is_ascii(bytes) ? parse_ascii(bytes, name) : parse_binary(bytes, name)};
}

}  // namespace bead
