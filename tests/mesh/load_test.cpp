#include "mesh/load.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "core/error.h"
#include "support/mesh_files.h"
#include "support/shapes.h"

namespace bead {
namespace {

struct Writer {
    std::string name;
    std::function<std::string(const Mesh&)> write;
};

std::vector<Writer> writers() {
    return {{"part.stl", [](const Mesh& mesh) { return binary_stl(mesh); }},
            {"part.STL", ascii_stl},
            {"part.obj", obj},
            {"part.3mf", [](const Mesh& mesh) { return three_mf(mesh); }}};
}

// The message if the bytes are refused, empty if they are a mesh. A mesh must be safe to use.
std::string refusal(const std::string& bytes, const std::string& name) {
    try {
        const Mesh mesh = parse_mesh(bytes, name);
        for (const auto& triangle : mesh.triangles)
            for (const int i : triangle)
                EXPECT_TRUE(i >= 0 && static_cast<std::size_t>(i) < mesh.points.size());
        for (const Vec3 p : mesh.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

RC_GTEST_PROP(load_mesh, reads_what_each_writer_wrote, ()) {
    const Mesh mesh = in_floats(shapes::random_extrusion(*rc::gen::arbitrary<std::uint64_t>(), 7));
    for (const auto& [name, write] : writers())
        RC_ASSERT(corners(parse_mesh(write(mesh), name)) == corners(mesh));
}

RC_GTEST_PROP(load_mesh, reads_gzipped_bytes_as_the_plain_ones, ()) {
    const Mesh mesh = shapes::random_extrusion(*rc::gen::arbitrary<std::uint64_t>(), 7);
    for (const auto& [name, write] : writers()) {
        const std::string bytes = write(mesh);
        const Mesh plain = parse_mesh(bytes, name);
        const Mesh packed = parse_mesh(gzipped(bytes), name + ".gz");
        RC_ASSERT(packed.points == plain.points);
        RC_ASSERT(packed.triangles == plain.triangles);
    }
}

RC_GTEST_PROP(load_mesh, never_breaks_on_truncated_files, ()) {
    const Mesh mesh = shapes::box({1, 2, 3});
    for (const auto& [name, write] : writers()) {
        const std::string bytes = write(mesh);
        const auto kept = *rc::gen::inRange<std::size_t>(0, bytes.size() - 1);
        const std::string message = refusal(bytes.substr(0, kept), name);
        RC_ASSERT(!message.empty() || name == "part.obj");  // OBJ has no end mark
    }
}

RC_GTEST_PROP(load_mesh, never_breaks_on_damaged_files, ()) {
    const Mesh mesh = shapes::box({1, 2, 3});
    for (const auto& [name, write] : writers()) {
        std::string bytes = write(mesh);
        for (int i = 0; i < 5; ++i)
            bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
        refusal(bytes, name);
        refusal(gzipped(bytes), name);
    }
}

TEST(load_mesh, welds_equal_corners) {
    const Mesh mesh = shapes::box({1, 2, 3});
    for (const auto& [name, write] : writers())
        EXPECT_EQ(parse_mesh(write(mesh), name).points.size(), mesh.points.size()) << name;
}

TEST(load_mesh, takes_binary_stl_that_starts_with_solid_or_has_bytes_to_spare) {
    const Mesh mesh = shapes::box({1, 2, 3});
    EXPECT_EQ(corners(parse_mesh(binary_stl(mesh, "solid box"), "a.stl")), corners(mesh));
    EXPECT_EQ(corners(parse_mesh(binary_stl(mesh, "solid box") + "spare", "a.stl")), corners(mesh));
    EXPECT_EQ(corners(parse_mesh(binary_stl(mesh) + "spare", "a.stl")), corners(mesh));
}

TEST(load_mesh, scales_by_the_unit) {
    const Mesh inches = parse_mesh(obj(shapes::box({1, 2, 3})), "a.obj", 25.4);
    EXPECT_NEAR(volume(inches), 6 * 25.4 * 25.4 * 25.4, 1e-6);
}

TEST(load_mesh, cuts_polygons_into_triangles_and_counts_points_from_either_end) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 +1e0 1\nv 9 9 9\n";
    const Mesh mesh =
        parse_mesh(points + "f 4 3 2 1\nf 1 2 5\nf -5 -4 -2\nf 3 4 5\nf 4 1 5\r\n", "pyramid.obj");
    EXPECT_EQ(mesh.triangles.size(), 6U);
    EXPECT_EQ(mesh.points.size(), 5U);  // the unused one is gone
    EXPECT_NEAR(volume(mesh), 1.0 / 3, 1e-12);
}

TEST(load_mesh, reads_files) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const auto file = folder / fmt::format("beadwork_load_test_{}.stl", getpid());
    std::ofstream(file, std::ios::binary) << binary_stl(shapes::box({1, 2, 3}));
    EXPECT_NEAR(volume(load_mesh(file)), 6, 1e-6);
    std::filesystem::remove(file);
    EXPECT_THROW(load_mesh(file), Error);
    EXPECT_THROW(load_mesh(folder), Error);
}

struct BadFile {
    std::string name, bytes, says;
};

std::vector<BadFile> bad_files() {
    const Mesh box = shapes::box({1, 2, 3});
    Mesh flat = box;
    for (Vec3& p : flat.points) p.z = 0;
    Mesh lost = box;
    lost.points[0].y = std::numeric_limits<double>::quiet_NaN();
    Mesh vast = box;
    vast.points[0].x = 1e9;
    const std::string binary = binary_stl(box);
    const std::string packed = gzipped(binary);
    return {
        {"a.stl", "", "empty"},
        {"a.step", "ISO-10303-21", ".stl, .obj or .3mf"},
        {"a.stl", "abc", "too few"},
        {"a.stl", binary.substr(0, binary.size() - 1), "truncated"},
        {"a.stl", "solid a\n facet\n vertex 0 0 0\n", "truncated"},
        {"a.stl", "solid a\nvertex 0 0 zero\nendsolid",
         "a.stl:2: expected a coordinate, got 'zero'"},
        {"a.stl", "solid a\nvertex 0 0 0\nendfacet\nendsolid", "a.stl:3: a facet of 1 corners"},
        {"a.stl", "solid a\nendsolid a", "no triangles"},
        {"a.stl", binary_stl(flat), "no height"},
        {"a.stl", binary_stl(lost), "finite"},
        {"a.stl", ascii_stl(lost), "finite"},
        {"a.stl", binary_stl(vast), "--units"},
        {"a.obj", "v 0 0 0\nv 0 0 1\nv 0 0 2\nf 1 2 3\n", "without area"},
        {"a.obj", "v 0 0\n", "a.obj:1: expected a coordinate"},
        {"a.obj", "v 0 0 0\nf 1 2\n", "a.obj:2: a face needs three corners"},
        {"a.obj", "v 0 0 0\nf 1 2 3\n", "point 2, but there are only 1"},
        {"a.obj", "v 0 0 0\nf 1 -2 3\n", "a.obj:2: '-2' counts back"},
        {"a.obj", "v 0 0 0\nf 1 0 3\n", "a.obj:2: expected the number of a point"},
        {"a.obj", "v 0 0 0\nf 1 99999999999 3\n", "a.obj:2: expected the number of a point"},
        {"a.obj", "no mesh at all", "no triangles"},
        {"a.stl.gz", packed.substr(0, packed.size() / 2), "gzip"},
        {"a.3mf", "not a zip", "zip"},
    };
}

TEST(load_mesh, says_in_one_line_what_is_wrong) {
    for (const auto& [name, bytes, says] : bad_files()) {
        const std::string message = refusal(bytes, name);
        EXPECT_TRUE(message.starts_with(name)) << name << ": " << message;
        EXPECT_NE(message.find(says), std::string::npos) << says << " / " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace bead
