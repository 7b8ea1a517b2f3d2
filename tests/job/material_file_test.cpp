#include "job/material_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

using namespace test;

TEST(MaterialFile, ReadsEveryKey) {
    const ScratchFile file("mine.toml",
                           "density_g_cm3 = 1.1\nhotend_c = 250\nhotend_first_c = 245\nbed_c = 70\n"
                           "heat_capacity_j_gk = 1.5\nlatent_j_g = 40\n");
    const Material m = load_material(file.path());
    EXPECT_EQ(m.density, 1.1);
    EXPECT_EQ(m.hotend, 250);
    EXPECT_EQ(m.hotend_first, 245);
    EXPECT_EQ(m.bed, 70);
    EXPECT_EQ(m.heat_capacity, 1.5);
    EXPECT_EQ(m.latent, 40);
}

TEST(MaterialFile, TakesTheFirstLayerAsTheOthersIfItSaysNothing) {
    const ScratchFile file("mine.toml", "hotend_c = 250\n");
    EXPECT_EQ(load_material(file.path()).hotend_first, 250);
    EXPECT_EQ(load_material(file.path()).density, load_material("pla").density);
}

TEST(MaterialFile, RefusesWhatItDoesNotKnow) {
    const ScratchFile file("mine.toml", "density = 1.2\n");
    try {
        load_material(file.path());
        FAIL();
    } catch (const Error& e) {
        const std::string text = e.what();
        EXPECT_EQ(e.fault(), Fault::input);
        EXPECT_NE(text.find("did you mean density_g_cm3?"), text.npos) << text;
    }
    EXPECT_THROW(load_material("wood"), Error);
}

TEST(BuiltInMaterials, AreThoseOfTheContractAndPlausible) {
    const std::vector<std::string> names = material_names();
    for (const char* name : {"pla", "abs", "petg", "pellet-abs-cf"})
        EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
    for (const std::string& name : names) {
        const Material m = load_material(name);
        const bool is_steel = name == "17-4ph" || name == "316l";  // in a binder
        EXPECT_TRUE(is_steel ? m.density > 4 && m.density < 8 : m.density > 0.9 && m.density < 2)
            << name;
        EXPECT_TRUE(m.bed < m.hotend_first && m.hotend_first <= m.hotend) << name;
        EXPECT_TRUE(is_steel ? m.heat_capacity > 0.4 && m.heat_capacity < 1
                             : m.heat_capacity > 1 && m.heat_capacity < 2.5)
            << name;
    }
}

}  // namespace
}  // namespace bead
