#include "gcode/line_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/error.h"
#include "gcode/reader.h"

namespace bead {
namespace {

std::vector<std::string> lines_of(const std::string& text, std::size_t chunk) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    const auto bytes = for_each_line(stream_source(stream), "text", {.chunk = chunk},
                                     [&](std::string_view line) { lines.emplace_back(line); });
    EXPECT_EQ(bytes, std::int64_t(text.size()));
    return lines;
}

RC_GTEST_PROP(LineReader, gives_the_same_lines_for_any_size_of_chunk, ()) {
    const auto text =
        *rc::gen::container<std::string>(rc::gen::element('\n', '\r', 'a', 'b', ' ', 'c'));
    const auto chunk = *rc::gen::inRange<std::size_t>(1, 12);
    RC_ASSERT(lines_of(text, chunk) == lines_of(text, 1 << 20));
}

TEST(LineReader, cuts_at_line_ends) {
    const std::vector<std::string> expected{"a", "", "b\rc", "d"};
    EXPECT_EQ(lines_of("a\r\n\nb\rc\nd", 3), expected);
    EXPECT_EQ(lines_of("a\r\n\nb\rc\nd\n", 1), expected);
    EXPECT_TRUE(lines_of("", 4).empty());
}

TEST(LineReader, gives_up_on_a_line_without_end) {
    const TextSource endless = [](std::span<char> place) {
        std::ranges::fill(place, 'x');
        return place.size();
    };
    EXPECT_THROW(for_each_line(endless, "text", {}, [](std::string_view) {}), Error);
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

std::string gzipped(const std::string& text) {
    std::string out(compressBound(text.size()) + 64, '\0');
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = unsigned(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = unsigned(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

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

TEST_F(FileSource, complains_by_name) {
    const auto complaint = [](const std::filesystem::path& file) -> std::string {
        try {
            read_gcode(file, [](const Command&) {});
        } catch (const Error& error) {
            return error.what();
        }
        return "no complaint";
    };
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
