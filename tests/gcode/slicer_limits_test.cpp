#include "gcode/slicer_limits.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <string>

#include "core/error.h"

namespace bead {
namespace {

const std::string footer =
    "; estimated printing time (normal mode) = 1d 2h 3m 4s\n"
    "; estimated printing time (silent mode) = 9h\n"
    "; machine_max_acceleration_x = 960,1000\n"
    "; machine_max_acceleration_extruding = 1500\n"
    "; machine_max_acceleration_travel = 0\n"
    "; machine_max_feedrate_z = 12\r\n"
    "; machine_max_jerk_e = 2.5,1\n";

class SlicerLimits : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(file_); }
    void write(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }
    void write_gzipped(const std::string& text) const {
        gzFile const out = gzopen(file_.c_str(), "wb");
        gzwrite(out, text.data(), unsigned(text.size()));
        gzclose(out);
    }
    const std::filesystem::path file_ =
        std::filesystem::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string long_print() {
    std::string text = "; machine_max_jerk_x = 99\n";
    while (text.size() < 300'000) text += "G1 X1\nG1 X2\n";
    return text;
}

TEST_F(SlicerLimits, stand_at_the_end_of_a_plain_or_gzipped_file) {
    for (const bool gzip : {false, true}) {
        if (gzip)
            write_gzipped(long_print() + footer);
        else
            write(long_print() + footer);
        const auto limits = slicer_limits(file_);
        ASSERT_TRUE(limits);
        EXPECT_EQ(limits->max_acceleration[axis_x], 960);
        EXPECT_EQ(limits->acceleration, 1500);
        EXPECT_EQ(limits->max_feedrate[axis_z], 12);
        EXPECT_EQ(limits->jerk[axis_e], 2.5);
        EXPECT_FALSE(limits->jerk[axis_x] || limits->travel_acceleration);
        EXPECT_EQ(slicer_estimate(file_), 86400 + 2 * 3600 + 3 * 60 + 4);
    }
}

TEST_F(SlicerLimits, are_absent_where_nothing_is_said) {
    write("G28\n;; machine_max_jerk_x = 8\nG1 X1 ; machine_max_jerk_y = 8\n");
    EXPECT_FALSE(slicer_limits(file_));
    EXPECT_FALSE(slicer_estimate(file_));
    write("");
    EXPECT_FALSE(slicer_limits(file_));
}

TEST_F(SlicerLimits, do_not_count_when_the_slicer_ignores_them) {
    write(footer + "; machine_limits_usage = ignore\n");
    EXPECT_FALSE(slicer_limits(file_));
}

TEST_F(SlicerLimits, come_with_curas_estimate) {
    const std::string layers = long_print() + ";TIME_ELAPSED:3\nG1 X9\n;TIME_ELAPSED:7000.5\n";
    write(";FLAVOR:Marlin\n;TIME:7123\n" + layers);
    EXPECT_EQ(slicer_estimate(file_), 7123);
    write(";FLAVOR:Marlin\n;TIME:6666\n" + layers);  // the engine's, before anybody knew
    EXPECT_EQ(slicer_estimate(file_), 7000.5);
}

TEST_F(SlicerLimits, need_a_file) { EXPECT_THROW(slicer_limits(file_), Error); }

}  // namespace
}  // namespace bead
