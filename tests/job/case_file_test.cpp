#include "job/case_file.h"

#include <gtest/gtest.h>

#include "job/outline_svg.h"
#include "job/solid_material_file.h"
#include "support/job_errors.h"

namespace bead {
namespace {

using test::says;

constexpr const char* good = R"(
title = "strip"
thickness_mm = 2
outline = [[0, 0], [40, 0], [40, 10], [0, 10]]
circles = [{ center = [20, 5], radius = 2 }]
[material]
young_mpa = 1000
poisson = 0.3
[[support]]
from = [0, 0]
to = [0, 10]
[[load]]
from = [40, 0]
to = [40, 10]
force_n = [5, 0]
turn_deg = 10
move_mm = 2
[[probe]]
at = [10, 5]
[print]
bead_width_mm = 0.5
fill = 0.3
)";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
    return test::complaint_of([&] { parsed_case(text, "part.toml"); });
}

TEST(CaseFile, SaysWhatItSays) {
    const auto c = std::get<LoadCase>(parsed_case(good, "part.toml"));
    EXPECT_EQ(c.title, "strip");
    EXPECT_EQ(c.thickness, 2);
    EXPECT_EQ(c.material.young, 1000);
    EXPECT_NEAR(area(c.part), 400 - 4 * pi, 0.02);
    ASSERT_EQ(c.situations.size(), 1U);
    EXPECT_TRUE(c.situations[0].supports[0].x && c.situations[0].supports[0].y);
    EXPECT_EQ(c.situations[0].loads[0].force, (Vec2{5, 0}));
    EXPECT_NEAR(c.situations[0].loads[0].turn, pi / 18, 1e-12);
    EXPECT_EQ(c.situations[0].loads[0].move, 2);
    EXPECT_EQ(c.print.fill, 0.3);
    EXPECT_EQ(c.probes.size(), 1U);
}

TEST(CaseFile, NamesAMaterialAndSaysWhatIsOtherwise) {
    const auto c = std::get<LoadCase>(
        parsed_case(changed("[material]\n", "[material]\nname = \"petg\"\nbed_c = 70\n"), "x"));
    EXPECT_EQ(c.material.young, 1000);
    EXPECT_EQ(c.material.density, load_solid_material("petg").density);
    ASSERT_TRUE(c.print.heat);
    EXPECT_EQ(c.print.heat->hotend, load_print_heat("petg").hotend);
    EXPECT_EQ(c.print.heat->bed, 70);
    EXPECT_FALSE(std::get<LoadCase>(parsed_case(good, "x")).print.heat);
    const auto told = std::get<LoadCase>(
        parsed_case(changed("[material]\n", "[material]\nhotend_c = 300\nbed_c = 90\n"), "x"));
    EXPECT_EQ(told.print.heat->hotend_first, 300);
}

TEST(CaseFile, TakesSeveralSituations) {
    std::string text = changed("[[support]]", "[[case]]\nweight = 3\n[[case.support]]");
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("[[load]]", "[[case.load]]");
    replace("[[probe]]",
            "[[case]]\n[[case.support]]\nfrom=[40,0]\nto=[40,10]\nfix=\"xy\"\n[[case.load]]\n"
            "on={center=[20,5],radius=2}\nbearing=true\nforce_n=[0,1]\n[[probe]]");
    const auto c = std::get<LoadCase>(parsed_case(text, "part.toml"));
    ASSERT_EQ(c.situations.size(), 2U);
    EXPECT_EQ(c.situations[0].weight, 3);
    EXPECT_TRUE(c.situations[1].loads[0].bearing);
    EXPECT_TRUE(c.situations[1].loads[0].on.arc.has_value());
}

TEST(CaseFile, NamesWhatIsWrongAndWhere) {
    struct Row {
        const char *from, *to, *words;
    };
    const Row rows[]{
        {"fill = 0.3", "fil = 0.3", "part.toml:22: print.fil is not a key"},
        {"turn_deg = 10", "turn = 10", "load[0].turn is not a key"},
        {"[0, 10]]\ncirc", "[0, 10], [40, 5]]\ncirc", "outline crosses itself at (40"},
        {"[40, 10], [0, 10]]", "[0, 10], [40, 10]]", "outline crosses itself at (20, 5)"},
        {"from = [40, 0]", "from = [41, 0]",
         "load[0].from = [41, 0] is not on the boundary, which"},
        {"force_n = [5, 0]", "force_n = [0, 0]", "load[0].force_n is no force"},
        {"force_n = [5, 0]", "", "load[0] has no force_n"},
        {"to = [40, 10]\nforce", "to = [40, 0]\nforce", "single point"},
        {"to = [0, 10]", "to = [0, 10]\nfix = \"x\"", "slide along y"},
        {"to = [0, 10]", "to = [0, 0]", "turn about a point"},
        {"[[load]]\nfrom = [40, 0]\nto = [40, 10]\nforce_n = [5, 0]\nturn_deg = 10\nmove_mm = 2\n",
         "", "load is missing"},
        {"[[support]]\nfrom = [0, 0]\nto = [0, 10]\n", "", "support is missing"},
        {"at = [10, 5]", "at = [10, 50]", "probe[0].at lies outside"},
        {"radius = 2 }", "radius = 2, x = 1 }", "circles[0].x is not a key"},
        {"center = [20, 5]", "center = [20, 50]", "circles[0] lies outside"},
        {"radius = 2 }", "radius = 6 }", "2 separate pieces"},
        {"thickness_mm = 2", "", "thickness_mm is missing"},
        {"thickness_mm = 2", "thickness_mm = -2", "thickness_mm is -2 but must be above 0"},
        {"from = [0, 0]\nto = [0, 10]", "on = { center = [20, 5], radius = 3 }",
         "support[0].on has no boundary"},
        {"outline = ", "outline = 3 #", "outline must be an array"},
        {"poisson = 0.3", "poisson = 0.5", "poisson"},
        {"poisson = 0.3", "name = \"cheese\"", "part.toml:8: material.name = \"cheese\": unknown"},
        {"poisson = 0.3", "name = \"pellet-abs-cf\"", "says nothing of strength"},
        {"poisson = 0.3", "bed_c = 60", "material.bed_c stands alone"},
        {"fill = 0.3", "layer_height_mm = 5", "layer_height_mm is 5, the part 2 mm thick"},
        {"move_mm = 2", "move_mm = 80", "load[0].move_mm goes further than half-way round, 50 mm"},
        {"[40, 0], [40, 10], [0, 10]]", "[40, 0], [20, 0]]", "outline has no area; its points"},
        {"[40, 10], [0, 10]]", "[0, 0], [0, 0]]", "outline needs at least 3 different points"},
        {"[40, 0], [40, 10]", "[1e30, 0], [1e30, 10]", "outline[1] is 1e+30 but must be"},
        {"circles", "holes = [[[5, 5], [9, 5], [7, 5]]]\ncircles", "holes[0] has no area"},
        {"circles", "holes = [[[5, 5], [9, 9], [9, 5], [5, 9]]]\ncircles",
         "holes[0] crosses itself at (7, 7)"},
        {"radius = 2 }", "radius = 1e-6 }", "circles[0] is too small to be a hole"},
        {"at = [10, 5]", "", "probe[0] has no at = [x, y]"},
        {"from = [40, 0]\nto = [40, 10]", "from = [0, 2]\nto = [0, 8]",
         "load[0] pulls only where supports hold"},
        {"young_mpa = 1000", "young_mpa = 1e300", "young_mpa is 1e+300 but must be at least"},
        {"fill = 0.3", "layer_height_mm = 1e-7", "layer_height_mm is 1e-07 but must be at least"},
        {"bead_width_mm = 0.5", "bead_width_mm = 4", "thinner than a bead (4 mm) near (20"},
    };
    for (const Row& row : rows) {
        const std::string text = complaint(changed(row.from, row.to));
        EXPECT_TRUE(says(text, row.words)) << row.to << ": " << text;
        EXPECT_TRUE(text.starts_with("part.toml:")) << text;
    }
}

// Polygons may be closed by their first point, and say a point twice.
TEST(CaseFile, PassesOverPointsThatRepeat) {
    const auto part = [](const std::string& from, const std::string& to) {
        return std::get<LoadCase>(parsed_case(changed(from, to), "x")).part;
    };
    const std::string hole = "holes = [[[5, 4], [9, 4], [9, 8]]]\ncircles";
    const double once = area(part("circles", hole));
    EXPECT_NEAR(once, 400 - 4 * pi - 8, 0.02);
    EXPECT_EQ(area(part("circles", "holes = [[[5, 4], [9, 4], [9, 4], [9, 8], [5, 4]]]\ncircles")),
              once);
    EXPECT_EQ(area(part("[0, 10]]", "[0, 10], [0, 10], [0, 0]]")),
              area(part("fill = 0.3", "fill = 0.3")));
}

// A stadium of 0.6 mm by 0.6 mm is a disc: 0.283 mm² in place of 0.36.
TEST(CaseFile, TakesBeadsAsRectanglesOrStadiums) {
    const auto section = [](const std::string& more) {
        const PrintWish p =
            std::get<LoadCase>(
                parsed_case(changed("bead_width_mm = 0.5", "bead_width_mm = 0.6\n" + more), "x"))
                .print;
        return p.bead_width * p.layer_height;
    };
    EXPECT_NEAR(section(""), 0.36, 1e-12);
    EXPECT_NEAR(section("section = \"rectangle\""), 0.36, 1e-12);
    EXPECT_NEAR(section("section = \"stadium\""), pi * 0.09, 1e-12);
    EXPECT_TRUE(says(complaint(changed("bead_width_mm = 0.5",
                                       "section = \"stadium\"\n"
                                       "bead_width_mm = 0.5")),
                     "print.section = \"stadium\" needs beads at least as wide as high"));
}

// Held in one direction, the load still pulls in the other.
TEST(CaseFile, TakesLoadsOnSupportsThatSlide) {
    std::string text = changed("to = [0, 10]",
                               "to = [0, 10]\n[[support]]\nfrom = [40, 0]\nto = [40, 10]\n"
                               "fix = \"y\"");
    EXPECT_NO_THROW(parsed_case(text, "x"));
    text.replace(text.find("fix = \"y\""), 9, "fix = \"x\"");
    text.replace(text.find("turn_deg = 10"), 13, "");
    EXPECT_TRUE(says(complaint(text), "load[0] pulls only where supports hold"));
}

TEST(CaseFile, TellsWhatIsTooThinToPrint) {
    const auto words = [](const std::string& from, const std::string& to) {
        return unprinted_words(std::get<LoadCase>(parsed_case(changed(from, to), "x")));
    };
    EXPECT_FALSE(words("fill = 0.3", "fill = 0.3"));
    const auto thin =
        words("[40, 10], [0, 10]]", "[40, 10], [10, 10], [10, 15], [9.7, 15], [9.7, 10], [0, 10]]");
    ASSERT_TRUE(thin);
    EXPECT_TRUE(says(*thin, "near (9.85, 12")) << *thin;
}

TEST(CaseFile, KnowsTheEmptySideOfAHole) {
    const std::string text = complaint(
        changed("from = [40, 0]\nto = [40, 10]",
                "on = { center = [20, 5], radius = 2 }\narc_deg = [90, 270]\nbearing = true"));
    EXPECT_TRUE(says(text, "empty side")) << text;
}

TEST(CaseFile, NeedsAMeshForBoxes) {
    const std::string text =
        complaint(changed("from = [0, 0]\nto = [0, 10]", "box = [[0, 0, 0], [1, 1, 1]]"));
    EXPECT_TRUE(says(text, "model is missing")) << text;
}

TEST(OutlineSvg, ReadsShapesAndTransforms) {
    const char* text =
        R"svg(<svg xmlns="x" width="40mm" viewBox="0 0 80 40"><g transform="translate(2,0) scale(2)">
        <path d="M 0 0 h 20 v 10 l-20 0z M5,5 a2 2 0 1 0 4 0 a2 2 0 1 0 -4 0"/></g></svg>)svg";
    const Region part = outline_of_svg(text, "part.svg");
    ASSERT_EQ(part.size(), 1U);
    EXPECT_EQ(part[0].holes.size(), 1U);
    EXPECT_NEAR(area(part), 200 - 4 * pi, 0.05);
    const Box2 box = bounds(part);
    EXPECT_NEAR(box.low.x, 1, 1e-6);
    EXPECT_NEAR(box.high.y, 20, 1e-6);
}

TEST(OutlineSvg, PassesOverWhatIsNotShown) {
    const char* text =
        R"svg(<svg width="40mm" viewBox="0 0 40 40"><defs><rect width="9" height="9"/></defs>
        <rect width="20" height="10"/><rect x="30" width="5" height="5" display="none"/>
        <g style="fill:red;display:none"><circle cx="35" cy="35" r="2"/></g></svg>)svg";
    const Region part = outline_of_svg(text, "part.svg");
    ASSERT_EQ(part.size(), 1U);
    EXPECT_NEAR(area(part), 200, 1e-6);
}

TEST(OutlineSvg, NamesWhereAShapeCrossesItself) {
    const std::string words = test::complaint_of([&] {
        outline_of_svg("<svg viewBox='0 0 40 40'><path d='M0 0 L20 10 20 0 0 10z'/></svg>",
                       "part.svg");
    });
    EXPECT_TRUE(says(words, "part.svg: a shape crosses itself at (10, 35)")) << words;
}

TEST(OutlineSvg, RefusesWhatIsNone) {
    for (const char* text : {"", "<svg/>", "<html/>", "<svg><path d='M 0 0 X'/></svg>",
                             "<svg><path d='M 0 0 L 1e9 0 0 1e9z'/></svg>",
                             "<svg><rect width='3' height='4' transform='spin(3)'/></svg>"}) {
        const std::string words = test::complaint_of([&] { outline_of_svg(text, "part.svg"); });
        EXPECT_TRUE(words.starts_with("part.svg: ")) << text << words;
    }
}

}  // namespace
}  // namespace bead
