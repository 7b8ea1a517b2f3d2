// What counts as the same line, and what counts as a fault.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "gcode/text.h"

namespace bead {
namespace {

TEST(Syntax, has_many_spellings_of_one_move) {
    for (const char* text : {"G1 X10.5 Y-2 E.5 F600", "G1X10.5Y-2E.5F600", "g1x10.5y-2e.5f600",
                             "G01 X+10.50 Y-2.0 E0.5 F600", "  G1\tX 10.5 Y -2 E .5 F 600  ",
                             "N12 G1 X10.5 Y-2 E.5 F600*49", "n12 G1 X10.5 Y-2 E.5 F600 *49",
                             "G1 X10.5 Y-2 E.5 F600 ; to X99", "G1 X10.5 (X99) Y-2(;)E.5 F600",
                             "(first) G1 X10.5 Y-2 E.5 F600", "\xEF\xBB\xBFG1 X10.5 Y-2 E.5 F600",
                             "G1 X1.05e1 Y-2 E5e-1 F600", "G1 X10.5 Y-2 E.5 F600 (open"}) {
        const Reading reading = reading_of(text);
        ASSERT_EQ(reading.commands.size(), 2U) << text;  // a layer begins with it
        EXPECT_EQ(reading.last<Move>().to, (Position{10.5, -2, 0, 0.5})) << text;
        EXPECT_EQ(reading.last<Move>().feed, 10) << text;
        EXPECT_EQ(reading.report.malformed, 0) << text;
    }
}

TEST(Syntax, takes_crlf_for_lf) {
    const std::string lf = ";TYPE:Perimeter\nG1 X1\n;LAYER_CHANGE\n;Z:0.2\nG1 X2 E1\nG28\n";
    std::string crlf;
    for (const char c : lf) crlf += c == '\n' ? "\r\n" : std::string(1, c);
    const Reading a = reading_of(lf), b = reading_of(crlf);
    ASSERT_EQ(a.commands.size(), b.commands.size());
    EXPECT_EQ(b.last<Move>().role, Role::wall);
    EXPECT_EQ(b.last<LayerStart>().z, 0.2);
    EXPECT_EQ(b.report.malformed, 0);
    EXPECT_EQ(b.report.lines, a.report.lines);
}

TEST(Syntax, reads_an_exponent_only_where_it_can_be_no_word) {
    EXPECT_EQ(reading_of("G1 X1e2").last<Move>().to, (Position{100, 0, 0, 0}));
    EXPECT_EQ(reading_of("G1 X1E2").last<Move>().to, (Position{1, 0, 0, 2}));
    EXPECT_EQ(reading_of("g1x1e2").last<Move>().to, (Position{1, 0, 0, 2}));
}

TEST(Syntax, ignores_a_word_that_is_no_number_and_counts_its_line) {
    for (const char* word : {"X", "X-", "X.", "X1,5", "X1.2.3", "X--1", "X?", "Xabc", "X1-2"}) {
        const Reading reading = reading_of(std::string("G1 Y1\n\nG1 ") + word + " Y2\nG1 Y\n");
        EXPECT_EQ(reading.last<Move>().to, (Position{0, 2, 0, 0})) << word;
        EXPECT_EQ(reading.report.malformed, 2) << word;
        EXPECT_EQ(reading.report.first_malformed, 3) << word;
    }
}

TEST(Syntax, counts_lines_that_start_with_no_command) {
    const Reading reading = reading_of("%\nG1 X1\nX5 Y5\n12\n*33\nN7\n");
    EXPECT_EQ(reading.report.malformed, 3);
    EXPECT_EQ(reading.commands.size(), 1U);
}

TEST(Syntax, counts_a_wrong_checksum_but_reads_the_line) {
    const Reading reading = reading_of("N3 G1 X5*102\nN4 G1 X6*1\nN5 G1 X7*\nG1 X8\n");
    EXPECT_EQ(reading.all<Move>().size(), 4U);
    EXPECT_EQ(reading.report.malformed, 2);
    EXPECT_EQ(reading.report.first_malformed, 2);
}

TEST(Syntax, does_not_take_a_broken_g92_for_an_empty_one) {
    const Reading reading = reading_of("G1 X5\nG92 X\nG1 Y1\n");
    EXPECT_EQ(reading.last<Move>().to, (Position{5, 1, 0, 0}));
    EXPECT_TRUE(reading.all<SetPosition>().empty());
    EXPECT_EQ(reading.report.malformed, 1);
}

TEST(Syntax, reads_a_last_line_that_is_cut_off) {
    EXPECT_EQ(reading_of("G1 X1\nG1 X12").last<Move>().to[axis_x], 12);
    EXPECT_EQ(reading_of("G1 X1\nG1 X2 Y").report.malformed, 1);
}

std::string syntax_complaint(const std::string& text) {
    try {
        reading_of(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
    return "no syntax_complaint";
}

TEST(Syntax, refuses_numbers_out_of_range_with_their_line) {
    for (const char* word :
         {"X1e300", "Xinf", "XNaN", "X-1000001", "Z2000000", "E2000000000", "F1e12", "Y1e999"})
        EXPECT_EQ(syntax_complaint(std::string("G28\nG1 ") + word).rfind("part.gcode:2: ", 0), 0U)
            << word;
    EXPECT_EQ(syntax_complaint("G91\nG1 X900000\nG1 X900000\n").rfind("part.gcode:3: ", 0), 0U);
    EXPECT_EQ(syntax_complaint("G20\nG1 X900000\n").rfind("part.gcode:2: ", 0), 0U);
    EXPECT_EQ(syntax_complaint("G28\nG92 X2000000\n").rfind("part.gcode:2: ", 0), 0U);
}

TEST(Syntax, refuses_what_is_no_gcode) {
    EXPECT_NE(syntax_complaint("").find("nothing moves"), std::string::npos);
    EXPECT_NE(syntax_complaint("; a remark\nM104 S200\n").find("nothing moves"), std::string::npos);
    EXPECT_NE(syntax_complaint("solid cube\nfacet normal 0 0 1\n").find("nothing moves"),
              std::string::npos);
    EXPECT_EQ(syntax_complaint(std::string("G28\nG1 X\0 1\n", 11))
                  .rfind("part.gcode:2: there is a NUL", 0),
              0U);
    EXPECT_NE(syntax_complaint("GCDE\1").find("bgcode"), std::string::npos);
    EXPECT_NE(syntax_complaint("PK\3\4zip").find("archive"), std::string::npos);
    EXPECT_NE(syntax_complaint("\x1f\x8bzip").find("gzip"), std::string::npos);
}

TEST(Syntax, reads_around_comments_of_any_length) {
    const std::string picture(10'000'000, 'A');
    const Reading reading = reading_of("G1 X1\n; " + picture + "\nG1 X2 ;" + picture + "\nG1 X3\n");
    EXPECT_EQ(reading.all<Move>().size(), 3U);
    EXPECT_EQ(reading.report.lines, 4);
}

TEST(Syntax, refuses_lines_beyond_a_megabyte) {
    const std::string most(std::size_t{1} << 20, ' ');
    EXPECT_EQ(syntax_complaint("G28\n" + most + "\n"), "no syntax_complaint");
    EXPECT_EQ(
        syntax_complaint("G28\n" + most + " \nG28\n").rfind("part.gcode:2: the line is longer", 0),
        0U);
    EXPECT_EQ(syntax_complaint("G28\n" + most + most).rfind("part.gcode:2: the line is longer", 0),
              0U);
}

}  // namespace
}  // namespace bead
