#include "job/solid_material_file.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

using test::ScratchFile;

std::string message_of(const std::string& file) {
    try {
        (void)load_solid_material(file);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SolidMaterialFile, ReadsStrength) {
    const ScratchFile file("mine.toml",
                           "young_mpa = 1000\npoisson = 0.3\ntensile_mpa = 20\n"
                           "compressive_mpa = 30\ndensity_g_cm3 = 1.5\nhotend_c = 200\n"
                           "green_scale_plane = 1.2\ngreen_scale_height = 1.3\n");
    const SolidMaterial m = load_solid_material(file.path());
    EXPECT_EQ(m.young, 1000);
    EXPECT_EQ(m.poisson, 0.3);
    EXPECT_EQ(m.tensile, 20);
    EXPECT_EQ(m.compressive, 30);
    EXPECT_EQ(m.density, 1.5);
    EXPECT_EQ(m.green_plane, 1.2);
    EXPECT_EQ(m.green_height, 1.3);
}

TEST(SolidMaterialFile, BearsAsMuchCompressionAsTensionIfItSaysNothing) {
    const ScratchFile file("mine.toml", "tensile_mpa = 20\n");
    EXPECT_EQ(load_solid_material(file.path()).compressive, 20);
    EXPECT_EQ(load_solid_material(file.path()).green_plane, 1);
}

TEST(SolidMaterialFile, OfTheBuiltInOnesIsPlausible) {
    for (const char* name : {"abs", "pla", "petg", "17-4ph", "316l"}) {
        const SolidMaterial m = load_solid_material(name);
        const bool is_steel = m.density > 4;
        EXPECT_TRUE(is_steel ? m.young > 150e3 : m.young > 1500 && m.young < 4000) << name;
        EXPECT_TRUE(m.poisson > 0.25 && m.poisson < 0.4) << name;
        EXPECT_GE(m.compressive, m.tensile) << name;
        EXPECT_EQ(is_steel, m.green_plane > 1.1) << name;
        EXPECT_EQ(is_steel, m.green_height > m.green_plane) << name;
    }
}

TEST(SolidMaterialFile, NamesWhatIsWrong) {
    EXPECT_NE(message_of("pellet-abs-cf").find("says nothing of strength"), std::string::npos);
    EXPECT_NE(message_of("wood").find("wood"), std::string::npos);
    const ScratchFile negative("mine.toml", "tensile_mpa = -1\n");
    EXPECT_NE(message_of(negative.path()).find("mine.toml:1"), std::string::npos)
        << message_of(negative.path());
    const ScratchFile shrunk("mine.toml", "tensile_mpa = 1\ngreen_scale_plane = 20\n");
    EXPECT_NE(message_of(shrunk.path()).find("green_scale_plane"), std::string::npos);
}

}  // namespace
}  // namespace bead
