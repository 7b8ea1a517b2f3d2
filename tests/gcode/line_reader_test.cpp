#include "gcode/line_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "gcode/reader.h"
#include "support/mesh_files.h"

namespace bead {
namespace {

std::vector<std::string> lines_of(const std::string& text, const LineLimits& limits) {
    std::istringstream stream(text);
    const TextSource source = stream_source(stream);
    LineReader reader(source, "text", limits);
    std::vector<std::string> lines;
    while (true) {
        std::string_view piece = reader.next(std::int64_t(lines.size()));
        if (piece.empty()) break;
        for (std::size_t end = 0; !piece.empty(); piece.remove_prefix(end + 1)) {
            end = piece.find('\n');
            lines.emplace_back(piece.substr(0, end));
        }
    }
    EXPECT_EQ(reader.bytes(), std::int64_t(text.size()));
    return lines;
}

RC_GTEST_PROP(LineReader, gives_the_same_lines_for_any_size_of_chunk, ()) {
    const auto text =
        *rc::gen::container<std::string>(rc::gen::element('\n', '\r', 'a', 'b', ' ', 'c'));
    const auto chunk = *rc::gen::inRange<std::size_t>(1, 12);
    RC_ASSERT(lines_of(text, {.chunk = chunk}) == lines_of(text, {}));
}

TEST(LineReader, cuts_at_line_ends) {
    const std::vector<std::string> expected{"a\r", "", "b\rc", "d"};
    EXPECT_EQ(lines_of("a\r\n\nb\rc\nd", {.chunk = 3}), expected);
    EXPECT_EQ(lines_of("a\r\n\nb\rc\nd\n", {.chunk = 1}), expected);
    EXPECT_TRUE(lines_of("", {.chunk = 4}).empty());
}

TEST(LineReader, cuts_long_comments_short) {
    const std::vector<std::string> expected{"first", "G1;56789A", "last"};
    for (const std::size_t chunk : {1U, 4U, 9U})
        for (const char* text :
             {"first\nG1;56789ABCDEF\nlast", "first\nG1;56789ABCDEFGHIJKLMNOP\nlast"})
            EXPECT_EQ(lines_of(text, {.chunk = chunk, .longest = 9}), expected) << chunk;
    EXPECT_EQ(lines_of("G1;56789ABCDEF", {.chunk = 4, .longest = 9}), std::vector{expected[1]});
    EXPECT_THROW(lines_of("first\n123456789A;\nlast", {.chunk = 4, .longest = 9}), Error);
}

TEST(LineReader, gives_up_on_a_line_without_end) {
    const TextSource endless = [](std::span<char> place) {
        std::ranges::fill(place, 'x');
        return place.size();
    };
    EXPECT_THROW(LineReader(endless, "text", {}).next(0), Error);
}

class FileSource : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    const std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) /
        testing::UnitTest::GetInstance()->current_test_info()->name();
};

std::string many_moves() {
    std::string text;
    for (int i = 1; i < 200'000; ++i) text += "G1 X" + std::to_string(i % 777) + "\n";
    return text;
}

TEST_F(FileSource, reads_gzip_like_the_plain_file) {
    const std::string text = many_moves();
    for (const std::string& file : {write("a.gcode", text), write("a.gcode.gz", gzipped(text))}) {
        std::int64_t moves = 0;
        const GcodeReport report = read_gcode(file, [&](const Command&) { ++moves; });
        EXPECT_EQ(moves, 199'999) << file;
        EXPECT_EQ(report.bytes, std::int64_t(text.size())) << file;
    }
}

std::string complaint(const std::filesystem::path& file) {
    try {
        read_gcode(file, [](const Command&) {});
    } catch (const Error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST_F(FileSource, reads_the_first_plate_of_an_archive) {
    const std::string file = write("a.gcode.3mf", zipped({{"3D/3dmodel.model", "<model/>"},
                                                          {"Metadata/plate_10.gcode", "G1 X10\n"},
                                                          {"Metadata/plate_2.gcode", many_moves()},
                                                          {"Metadata/plate_2.gcode.md5", "0"},
                                                          {"Metadata/plate_x.gcode", "G1 X9\n"}}));
    std::int64_t moves = 0;
    const GcodeReport report = read_gcode(file, [&](const Command&) { ++moves; });
    EXPECT_EQ(moves, 199'999);
    EXPECT_EQ(report.part, "Metadata/plate_2.gcode");
    EXPECT_EQ(report.bytes, std::int64_t(many_moves().size()));
}

TEST_F(FileSource, says_what_is_wrong_with_an_archive) {
    const std::string plate = zipped({{"Metadata/plate_1.gcode", many_moves()}});
    std::string damaged = plate;
    damaged[damaged.size() / 2] = char(damaged[damaged.size() / 2] ^ 0x55);
    EXPECT_NE(complaint(write("a.3mf", zipped({{"a.model", "x"}}))).find("no plate"),
              std::string::npos);
    EXPECT_NE(complaint(write("b.3mf", plate.substr(0, 1000))).find("complete"), std::string::npos);
    EXPECT_NE(complaint(write("c.3mf", damaged)).find("damaged"), std::string::npos);
    EXPECT_NE(complaint(write("d.3mf", zipped({{"Metadata/plate_1.gcode", "G1 X1\nG1 X1e99"}})))
                  .find("d.3mf (Metadata/plate_1.gcode):2: "),
              std::string::npos);
}

TEST_F(FileSource, complains_by_name) {
    const std::string whole = gzipped(many_moves());
    std::string damaged = whole;
    damaged[damaged.size() / 2] = char(damaged[damaged.size() / 2] ^ 0x55);
    for (const std::string& file :
         {write("cut.gz", whole.substr(0, whole.size() / 2)), write("damaged.gz", damaged),
          write("empty.gcode", ""), write("text.bgcode", "GCDE\1"), std::string(folder_ / "absent"),
          folder_.string()})
        EXPECT_EQ(complaint(file).rfind(file, 0), 0U) << complaint(file);
    EXPECT_NE(complaint(folder_ / "cut.gz").find("cut short"), std::string::npos);
}

}  // namespace
}  // namespace bead
