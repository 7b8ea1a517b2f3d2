#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh/check.h"
#include "mesh/load.h"
#include "support/mesh_files.h"
#include "support/shapes.h"

namespace bead {
namespace {

const std::string cube = "<object id=\"1\">" + mesh_element(shapes::box({1, 1, 1})) + "</object>";

Mesh parsed(const std::string& bytes) { return parse_mesh(bytes, "a.3mf"); }

std::string refusal(const std::string& bytes) {
    try {
        parsed(bytes);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(three_mf, knows_its_unit_unless_told_otherwise) {
    const std::string bytes = three_mf(cube, "<item objectid='1'/>", "inch");
    EXPECT_NEAR(volume(parsed(bytes)), 25.4 * 25.4 * 25.4, 1e-9);
    EXPECT_NEAR(volume(parse_mesh(bytes, "a.3mf", 2)), 8, 1e-9);
    EXPECT_NE(refusal(three_mf(cube, "<item objectid='1'/>", "cubit")).find("cubit"),
              std::string::npos);
}

TEST(three_mf, places_every_item_but_those_not_for_printing) {
    const Mesh mesh = parsed(three_mf(cube,
                                      "<item objectid='1'/>"
                                      "<item objectid='1' transform='1 0 0 0 1 0 0 0 1 10 20 30'/>"
                                      "<item objectid='1' printable='0'/>"));
    EXPECT_NEAR(volume(mesh), 2, 1e-12);
    EXPECT_EQ(bounds(mesh).high, (Vec3{11, 21, 31}));
}

// A quarter turn about z, then a move: the row-vector convention of the format.
TEST(three_mf, turns_before_it_moves) {
    const Mesh mesh =
        parsed(three_mf(cube, "<item objectid='1' transform='0 1 0 -1 0 0 0 0 1 5 0 0'/>"));
    EXPECT_EQ(bounds(mesh).low, (Vec3{4, 0, 0}));
    EXPECT_EQ(bounds(mesh).high, (Vec3{5, 1, 1}));
}

TEST(three_mf, mirrored_copies_still_face_outwards) {
    const Mesh mesh =
        parsed(three_mf(cube, "<item objectid='1' transform='-2 0 0 0 1 0 0 0 1 0 0 0'/>"));
    EXPECT_NEAR(volume(mesh), 2, 1e-12);
    EXPECT_TRUE(check(mesh).is_watertight());
}

TEST(three_mf, follows_components_inner_transform_first) {
    const std::string pair =
        "<object id='2'><components>"
        "<component objectid='1' transform='2 0 0 0 1 0 0 0 1 0 0 0'/>"
        "<component objectid='1' transform='1 0 0 0 1 0 0 0 1 0 5 0'/>"
        "</components></object>";
    const Mesh mesh =
        parsed(three_mf(cube + pair, "<item objectid='2' transform='1 0 0 0 1 0 0 0 3 100 0 0'/>"));
    EXPECT_NEAR(volume(mesh), 2 * 3 + 3, 1e-9);
    EXPECT_EQ(bounds(mesh).low, (Vec3{100, 0, 0}));
    EXPECT_EQ(bounds(mesh).high, (Vec3{102, 6, 3}));
}

TEST(three_mf, finds_objects_in_other_parts_of_the_package) {
    const std::string relations =
        "<Relationships><Relationship Target='/3D/root.model' "
        "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>";
    const std::string root =
        "<model><resources><object id='1'><components>"
        "<component q:path='/3D/Objects/a.model' objectid='1'/></components></object></resources>"
        "<build><item objectid='1'/></build></model>";
    const std::string part = "<model><resources>" + cube + "</resources></model>";
    const Mesh mesh = parsed(zipped(
        {{"_rels/.rels", relations}, {"3D/root.model", root}, {"3D/Objects/a.model", part}}));
    EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

std::string holder(int id, int of) {
    const std::string child = fmt::format("<component objectid='{}'/>", of);
    return fmt::format("<object id='{}'><components>{}{}</components></object>", id, child, child);
}

TEST(three_mf, refuses_what_it_cannot_place) {
    const std::string item = "<item objectid='1'/>";
    EXPECT_NE(refusal(three_mf(cube, "")).find("no object"), std::string::npos);
    EXPECT_NE(refusal(three_mf(cube, "<item objectid='7'/>")).find("'7'"), std::string::npos);
    EXPECT_NE(refusal(three_mf(holder(1, 2) + holder(2, 1), item)).find("circle"),
              std::string::npos);
    EXPECT_NE(refusal(three_mf("<object id='1'><mesh><vertices><vertex x='1' y='2'/></vertices>"
                               "</mesh></object>",
                               item))
                  .find("coordinate z"),
              std::string::npos);
    EXPECT_NE(refusal(three_mf(cube, "<item objectid='1' transform='1 0 0'/>")).find("twelve"),
              std::string::npos);
    EXPECT_NE(refusal(zipped({{"3D/3dmodel.model", "<model"}})).find("XML"), std::string::npos);
    EXPECT_NE(refusal(zipped({{"readme.txt", "hello"}})).find("no 3D model"), std::string::npos);
}

// Thirty levels of two copies each would be a thousand million cubes.
TEST(three_mf, refuses_to_multiply_without_end) {
    std::string objects = cube;
    for (int level = 2; level < 32; ++level) objects += holder(level, level - 1);
    EXPECT_NE(refusal(three_mf(objects, "<item objectid='31'/>")).find("more than"),
              std::string::npos);
}

}  // namespace
}  // namespace bead
