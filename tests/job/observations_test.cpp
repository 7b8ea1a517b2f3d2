#include "job/observations.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/table3.h"

namespace bead {
namespace {

ObservationTable parsed(const std::string& text) { return parsed_observations(text, "a/p.csv"); }

std::string fault_of_table(const std::string& text) {
    try {
        parsed(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "no fault";
}

const std::string head = "a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s,energy_mj,group\n";

TEST(Observations, ReadTheTableOfThePublication) {
    const ObservationTable table =
        read_observations(BEAD_SOURCE_DIR "/tests/data/somade2023/table3_calibration.csv");
    const std::vector<Observation> expected = test::table3();
    ASSERT_EQ(table.prints.size(), expected.size());
    EXPECT_FALSE(table.of_files);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Observation& seen = table.prints[i].seen;
        EXPECT_EQ(seen.group, expected[i].group);
        EXPECT_NEAR(seen.energy, expected[i].energy, 1e-9);
        EXPECT_EQ(seen.features->A, expected[i].features->A);
        EXPECT_EQ(seen.features->H, expected[i].features->H);
    }
    EXPECT_TRUE(table.prints[0].seen.name.ends_with(".csv:2"));
}

TEST(Observations, DoNotCareHowTheTableIsWritten) {
    for (const char* text : {
             "a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s,energy_mj\n1,2,3,4,5000\n",
             "\xEF\xBB\xBFh_s;energy_j;A_mm2_per_s2;note;C_mm;B_mm2_per_s2\r\n4;5;1;x;3;2\r\n",
             "# mine\n\nenergy_mWs\ta_mm2_per_s2\tb_mm2_per_s2\tc_mm\th_s\n5e3\t1\t+2\t3.0\t4",
             "\"a_mm2_per_s2\", b_mm2_per_s2 "
             ",c_mm,h_s,energy_kwh\n1,2,3,\"4\",1.3888888888888889e-6",
         }) {
        const ObservationTable table = parsed(text);
        ASSERT_EQ(table.prints.size(), 1U) << text;
        const Observation& seen = table.prints[0].seen;
        EXPECT_NEAR(seen.energy, 5, 1e-9) << text;
        EXPECT_EQ(seen.features->A, 1);
        EXPECT_EQ(seen.features->B, 2);
        EXPECT_EQ(seen.features->C, 3);
        EXPECT_EQ(seen.features->H, 4);
        EXPECT_EQ(seen.group, "");
    }
}

TEST(Observations, MayBeOfFilesBesideTheTable) {
    const ObservationTable table =
        parsed("gcode,energy_wh,shape\nbox.gcode,1,box\n/tmp/l.gcode,2,L\n");
    EXPECT_TRUE(table.of_files);
    EXPECT_EQ(table.prints[0].gcode, "a/box.gcode");
    EXPECT_EQ(table.prints[1].gcode, "/tmp/l.gcode");
    EXPECT_EQ(table.prints[1].seen.energy, 7200);
    EXPECT_EQ(table.prints[1].seen.group, "L");
    EXPECT_NE(table.kind.find("gcode"), std::string::npos);
}

TEST(Observations, MayBeTimesAndFilament) {
    const auto table = parsed("duration_s,filament_g,energy_wh,heat_ups\n3600,10,80,0\n");
    EXPECT_FALSE(table.prints[0].seen.features.has_value());
    EXPECT_EQ(table.prints[0].seen.duration, 3600);
    EXPECT_EQ(table.prints[0].seen.heat_ups, 0);
}

TEST(Observations, NameWhatIsWrongAndWhere) {
    const struct {
        std::string text, words;
    } faults[] = {
        {"", "empty"},
        {head, "no rows"},
        {"a_mm2_per_s2,b_mm2_per_s2,h_s,energy_mj\n1,2,3,4\n", "p.csv:1: has no column c_mm"},
        {"gcode\nx.gcode\n", "energy_mj"},
        {"a_mm2_per_s2,a_mm2_per_s2,energy_mj\n", "two columns a_mm2_per_s2"},
        {"energy_j,energy_mj,gcode\n1,2,x\n", "energy_mj and energy_j"},
        {head + "1,2,,4,5,g\n", "p.csv:2: c_mm is empty"},
        {head + "1,2,3,4,5,\n", "group is empty"},
        {head + "1,2,3,4,5,g\n1,2,3,4,0,g\n", "p.csv:3: energy_mj is 0"},
        {head + "1,2,3,4,-5,g\n", "energy_mj is -5"},
        {head + "1,-2,3,4,5,g\n", "b_mm2_per_s2 is -2"},
        {head + "nan,2,3,4,5,g\n", "a_mm2_per_s2 is nan"},
        {head + "1e300,2,3,4,5,g\n", "1e300"},
        {head + "1,2,3,inf,5,g\n", "h_s is inf"},
        {head + "1,2,3,4 s,5,g\n", "4 s"},
        {head + "1,5,2,3,4,5,g\n", "7 cells where the header has 6"},
        {head + "1,2\n", "2 cells"},
        {"a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s,energy_j,duration_s\n1,2,3,900,5,400\n",
         "more than both axes have"},
        {std::string("a\0b", 3), "not a text file"},
    };
    for (const auto& fault : faults) {
        const std::string message = fault_of_table(fault.text);
        EXPECT_NE(message.find(fault.words), std::string::npos) << fault.text << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
        EXPECT_EQ(message.rfind("a/p.csv", 0), 0U) << message;
    }
    EXPECT_THROW(read_observations("/nonexistent.csv"), Error);
}

}  // namespace
}  // namespace bead
