#include "job/marlin_dump.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "job/limit_table.h"
#include "support/job_errors.h"

namespace bead {
namespace {

using test::complaint_of;
using test::says;

PrinterFile read_dump(const std::string& text) { return read_marlin_dump({"dump.txt", text}, {}); }

const std::vector<std::string> dump{"G21    ; Units in mm (mm)",
                                    "; Steps per unit:",
                                    "M92 X80.00 Y80.50 Z400.00 E93.00",
                                    "; Maximum feedrates (units/s):",
                                    "M203 X500.00 Y501.00 Z5.00 E25.00",
                                    "M201 X502.00 Y503.00 Z100.00 E5000.00",
                                    "M204 P504.00 R505.00 T506.00",
                                    "; Advanced: B<min_segment_time_us> S<min_feedrate>",
                                    "M205 B20000.00 S0.00 T0.00 X10.00 Y11.00 Z0.30 E5.00",
                                    "M301 P21.73 I1.54 D76.55",
                                    "M900 K0.05"};

std::string joined(const std::vector<std::string>& lines, const std::string& before = "") {
    std::string text;
    for (const std::string& line : lines) text.append(before).append(line).append("\r\n");
    return text;
}

void expect_dump(const Limits& l) {
    EXPECT_EQ(l.steps_per_mm, (std::array<double, 4>{80, 80.5, 400, 93}));
    EXPECT_EQ(l.max_feedrate, (std::array<double, 4>{500, 501, 5, 25}));
    EXPECT_EQ(l.max_acceleration, (std::array<double, 4>{502, 503, 100, 5000}));
    EXPECT_EQ(l.acceleration, 504);
    EXPECT_EQ(l.retract_acceleration, 505);
    EXPECT_EQ(l.travel_acceleration, 506);
    EXPECT_EQ(l.jerk, (std::array<double, 4>{10, 11, 0.3, 5}));
}

TEST(MarlinDump, IsReadWhateverStandsBeforeItsLines) {
    for (const char* before : {"", "echo:  ", "echo:; ", "Recv: echo: ", "; ", "\t"}) {
        const PrinterFile file = read_dump(joined(dump, before));
        expect_dump(file.printer.limits);
        EXPECT_FALSE(file.says.firmware) << "X Y Z jerk may be Marlin's or Prusa's";
        EXPECT_EQ(file.says.limits.front().source, "dump.txt:3 (M92)");
    }
}

TEST(MarlinDump, WithJunctionDeviationIsMarlins) {
    const PrinterFile file = read_dump("echo:  M205 B20000.00 S0.00 T0.00 J0.08 E5.00\n");
    EXPECT_EQ(file.printer.limits.junction_deviation, 0.08);
    EXPECT_EQ(file.printer.limits.jerk[3], 5);
    EXPECT_EQ(file.says.firmware->firmware, Firmware::marlin_jd);
}

TEST(MarlinDump, OfOldFirmwareSharesValues) {
    const Limits l =
        read_dump("M204 S3000.00\nM205 S0.00 T0.00 B20000 X20.00 Z0.40 E6.00\n").printer.limits;
    EXPECT_EQ(l.acceleration, 3000);
    EXPECT_EQ(l.travel_acceleration, 3000);
    EXPECT_EQ(l.jerk[0], 20);
    EXPECT_EQ(l.jerk[1], 20);
}

TEST(MarlinDump, OfSeveralExtrudersCountsTheFirst) {
    EXPECT_EQ(read_dump("M92 T0 E93\nM92 T1 E409\n").printer.limits.steps_per_mm[3], 93);
}

TEST(MarlinDump, PassesOverWhatIsNoLimitAndSaysSo) {
    for (const std::string value :
         {"0", "0.00", "-5", "nan", "1e9", "", "5x", "99999999999999999999"}) {
        const PrinterFile file = read_dump("M92 X80\nM203 X" + value + " Y7\n");
        EXPECT_EQ(file.printer.limits.max_feedrate[0], Limits{}.max_feedrate[0]) << value;
        EXPECT_EQ(file.printer.limits.max_feedrate[1], 7);
        ASSERT_EQ(file.says.warnings.size(), 1U) << value;
        EXPECT_TRUE(says(file.says.warnings[0], "dump.txt:2: M203 X" + value));
    }
}

TEST(MarlinDump, ThatIsNoneIsRefused) {
    for (const std::string text : {"", "M503\nok\n", "G1 X5\n", "M92\n", "M203 X0\n"})
        EXPECT_TRUE(says(complaint_of([&] { read_dump(text); }), "M503")) << text;
    EXPECT_TRUE(
        says(complaint_of([&] { read_dump("echo:  G20 ; inches\nM92 X80\n"); }), "dump.txt:1"));
}

RC_GTEST_PROP(MarlinDump, order_of_lines_does_not_matter, ()) {
    std::vector<std::string> lines = dump;
    std::shuffle(lines.begin(), lines.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
    expect_dump(read_dump(joined(lines)).printer.limits);
}

}  // namespace
}  // namespace bead
