#include "gcode/slicer_notes.h"

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
    "; machine_max_feedrate_z = 12\r\n"
    "; printer_model =\n"
    "; machine_max_jerk_e = 2.5,1\n";

class SlicerNotesOfFile : public testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(file_); }
    void write(const std::string& text) const { std::ofstream(file_, std::ios::binary) << text; }
    void write_gzipped(const std::string& text) const {
        gzFile const out = gzopen(file_.c_str(), "wb");
        gzwrite(out, text.data(), unsigned(text.size()));
        gzclose(out);
    }
    [[nodiscard]] std::string setting(const std::string& name) const {
        const SlicerNotes notes = slicer_notes(file_);
        const auto found = notes.settings.find(name);
        return found == notes.settings.end() ? "none" : found->second;
    }
    const std::filesystem::path file_ =
        std::filesystem::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string long_print() {
    std::string text;
    while (text.size() < 300'000) text += "G1 X1\nG1 X2\n";
    return text;
}

TEST_F(SlicerNotesOfFile, stand_at_the_end_of_a_plain_or_gzipped_file) {
    for (const bool gzip : {false, true}) {
        const std::string text = "; machine_max_jerk_x = 99\n" + long_print() + footer;
        gzip ? write_gzipped(text) : write(text);
        EXPECT_EQ(setting("machine_max_acceleration_x"), "960,1000");
        EXPECT_EQ(setting("machine_max_feedrate_z"), "12");
        EXPECT_EQ(setting("machine_max_jerk_e"), "2.5,1");
        EXPECT_EQ(setting("printer_model"), "");
        EXPECT_EQ(setting("machine_max_jerk_x"), "none") << "not in a block, far from the end";
        EXPECT_EQ(slicer_notes(file_).estimate, 86400 + 2 * 3600 + 3 * 60 + 4);
    }
}

TEST_F(SlicerNotesOfFile, stand_in_a_block_at_the_top) {
    write(
        "; HEADER_BLOCK_START\n; model printing time: 13m 4s; total estimated time: 1h 19m 33s\n"
        "; HEADER_BLOCK_END\n; CONFIG_BLOCK_START\n; machine_max_speed_x = 500,200\n"
        "; CONFIG_BLOCK_END\n; machine_max_jerk_x = 9\n" +
        long_print());
    EXPECT_EQ(setting("machine_max_speed_x"), "500,200");
    EXPECT_EQ(setting("machine_max_jerk_x"), "none");
    EXPECT_EQ(slicer_notes(file_).estimate, 3600 + 19 * 60 + 33);
}

TEST_F(SlicerNotesOfFile, are_absent_where_nothing_is_said) {
    for (const char* text : {"", "G28\n;; machine_max_jerk_x = 8\nG1 X1 ; machine_max_jerk_y = 8\n",
                             "; CONFIG_BLOCK_START\n", "; = 3\n;  = 4\n; A b = 5\n"}) {
        write(text);
        EXPECT_TRUE(slicer_notes(file_).settings.empty()) << text;
        EXPECT_FALSE(slicer_notes(file_).estimate);
    }
}

TEST_F(SlicerNotesOfFile, come_with_curas_estimate) {
    const std::string layers = long_print() + ";TIME_ELAPSED:3\nG1 X9\n;TIME_ELAPSED:7000.5\n";
    write(";FLAVOR:Marlin\n;TIME:7123\n" + layers);
    EXPECT_EQ(slicer_notes(file_).estimate, 7123);
    write(";FLAVOR:Marlin\n;TIME:6666\n" + layers);  // the engine's, before anybody knew
    EXPECT_EQ(slicer_notes(file_).estimate, 7000.5);
}

TEST_F(SlicerNotesOfFile, need_a_file) { EXPECT_THROW(slicer_notes(file_), Error); }

}  // namespace
}  // namespace bead
