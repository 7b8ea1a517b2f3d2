// Models made by others, if they are at hand: each is read, and its layers add up to its volume.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "mesh/check.h"
#include "mesh/load.h"
#include "slice/slice.h"

namespace bead {
namespace {

struct Model {
    const char* file;
    double unit_mm = 1;
    bool overlaps = false;  // what lies in several shells counts several times in the mesh's volume
};

constexpr Model models[] = {
    {"3dbenchy.3mf"},
    {"broken_featuretype_inch.stl", 25.4},
    {"broken_nonmanifold_crash.obj", 1, true},
    {"klipper_ringing_tower.stl"},
    {"mk3_x_carriage.stl"},
    {"plate_holes.stl"},
    {"prusa_extruder_idler.obj"},
    {"spot_90mm.stl"},
    {"voron0_z_motor_mount.stl"},
};

std::filesystem::path models_folder() {
    const char* const shared = std::getenv("BEAD_SHARED");
    return std::filesystem::path(shared != nullptr ? shared : BEAD_SOURCE_DIR "/../shared") /
           "models";
}

TEST(models, layers_add_up_to_the_volume) {
    if (!std::filesystem::exists(models_folder()))
        GTEST_SKIP() << "NOT TESTED: no models in " << models_folder() << "; set BEAD_SHARED";
    for (const auto& [file, unit_mm, overlaps] : models) {
        const Mesh mesh = load_mesh(models_folder() / file, unit_mm);
        const Slices slices = slice(mesh, {.layer_height = 0.1, .first_layer_height = 0.1});
        double sum = 0;
        for (const Layer& layer : slices.layers) sum += area(layer.region) * layer.height;
        EXPECT_EQ(slices.dropped_outlines, 0) << file;
        EXPECT_LT(sum, 1.01 * volume(mesh)) << file;
        EXPECT_GT(sum, (overlaps ? 0.8 : 0.99) * volume(mesh)) << file;
    }
}

}  // namespace
}  // namespace bead
