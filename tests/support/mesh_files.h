// Small writers of the mesh formats that are read, to test the readers with.
#pragma once
#include <fmt/format.h>
#include <zip.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>

#include "mesh/mesh.h"

namespace bead {

inline Vec3 corner(const Mesh& mesh, const std::array<int, 3>& triangle, std::size_t k) {
    return mesh.points[static_cast<std::size_t>(triangle[k])];
}

// What a mesh is, whatever its indices: the corners of its triangles in order.
inline std::vector<Vec3> corners(const Mesh& mesh) {
    std::vector<Vec3> result;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) result.push_back(corner(mesh, triangle, k));
    return result;
}

// With coordinates that a float holds, so that a binary STL file keeps them.
inline Mesh in_floats(Mesh mesh) {
    for (Vec3& p : mesh.points)
        p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    return mesh;
}

template <class Value>
void append_bytes(std::string& bytes, Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

inline std::string binary_stl(const Mesh& mesh, std::string header = "binary") {
    header.resize(80);
    std::string bytes = header;
    append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        bytes.append(12, '\0');  // normal
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = corner(mesh, triangle, k);
            for (const double x : {p.x, p.y, p.z}) append_bytes(bytes, static_cast<float>(x));
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

inline std::string ascii_stl(const Mesh& mesh) {
    std::string text = "solid a vertex 1 2 3\n";
    for (const auto& triangle : mesh.triangles) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = corner(mesh, triangle, k);
            text += fmt::format("   vertex {} {} {}\n", p.x, p.y, p.z);
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid a\n";
}

inline std::string obj(const Mesh& mesh) {
    std::string text = "# a comment\no part\n";
    for (const Vec3 p : mesh.points) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles)
        text += fmt::format("f {}//1 {}/2/1 {}\n", a + 1, b + 1, c + 1);
    return text;
}

// The <mesh> element of a 3MF object.
inline std::string mesh_element(const Mesh& mesh) {
    std::string text = "<mesh><vertices>";
    for (const Vec3 p : mesh.points)
        text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", p.x, p.y, p.z);
    text += "</vertices><triangles>";
    for (const auto& [a, b, c] : mesh.triangles)
        text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", a, b, c);
    return text + "</triangles></mesh>";
}

inline std::string zipped(const std::map<std::string, std::string>& files) {
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(target);
    zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
    for (const auto& [path, text] : files)
        zip_file_add(archive, path.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0),
                     ZIP_FL_ENC_UTF_8);
    zip_close(archive);
    zip_source_open(target);
    zip_source_seek(target, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(zip_source_tell(target)), '\0');
    zip_source_seek(target, 0, SEEK_SET);
    zip_source_read(target, bytes.data(), bytes.size());
    zip_source_close(target);
    zip_source_free(target);
    return bytes;
}

inline std::string gzipped(const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

// A 3MF file from what stands within <resources> and <build>.
inline std::string three_mf(const std::string& resources, const std::string& build,
                            const std::string& unit = "millimeter") {
    return zipped(
        {{"3D/3dmodel.model",
          fmt::format("<?xml version=\"1.0\"?><model unit=\"{}\"><resources>{}</resources>"
                      "<build>{}</build></model>",
                      unit, resources, build)}});
}

inline std::string three_mf(const Mesh& mesh) {
    return three_mf("<object id=\"1\">" + mesh_element(mesh) + "</object>",
                    "<item objectid=\"1\"/>");
}

}  // namespace bead
