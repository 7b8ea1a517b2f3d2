#include "core/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>
#include <string>

#include "core/error.h"

namespace bead {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& place) {
    std::ostringstream text;
    text << std::ifstream(place).rdbuf();
    return text.str();
}

class OutputFileTest : public testing::Test {
  protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("output_file_" + std::to_string(::getpid()));
        fs::create_directory(folder);
        place = folder / "part.gcode";
    }
    void TearDown() override { fs::remove_all(folder); }
    [[nodiscard]] long files() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }
    fs::path folder, place;
};

TEST_F(OutputFileTest, appears_with_every_byte_when_kept) {
    const std::string text(100'000, 'x');
    OutputFile file(place);
    file.stream() << text;
    EXPECT_FALSE(fs::exists(place));
    file.keep();
    EXPECT_EQ(text_of(place), text);
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, leaves_nothing_when_not_kept) {
    { OutputFile(place).stream() << "half"; }
    EXPECT_EQ(files(), 0);
}

TEST_F(OutputFileTest, leaves_the_old_file_alone_until_kept) {
    std::ofstream(place) << "old";
    { OutputFile(place).stream() << "half"; }
    EXPECT_EQ(text_of(place), "old");
    OutputFile file(place);
    file.stream() << "new";
    file.keep();
    EXPECT_EQ(text_of(place), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, keeps_the_permissions_of_what_it_replaces) {
    std::ofstream(place) << "old";
    for (const auto mode : {fs::perms::owner_read, fs::perms(0640), fs::perms(0755)}) {
        fs::permissions(place, mode);
        OutputFile file(place);
        file.stream() << "new";
        file.keep();
        EXPECT_EQ(fs::status(place).permissions(), mode);
    }
}

TEST_F(OutputFileTest, replaces_what_a_link_leads_to) {
    const fs::path near = folder / "link", far = folder / "link to link";
    std::ofstream(place) << "old";
    fs::create_symlink(place.filename(), near);
    fs::create_symlink(near, far);
    OutputFile file(far);
    file.stream() << "new";
    file.keep();
    EXPECT_TRUE(fs::is_symlink(far) && fs::is_symlink(near) && !fs::is_symlink(place));
    EXPECT_EQ(text_of(place), "new");
    EXPECT_EQ(files(), 3);
}

TEST_F(OutputFileTest, says_where_it_cannot_write) {
    const fs::path nowhere = folder / "missing" / "part.gcode";
    try {
        OutputFile file(nowhere);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(nowhere.string()), std::string::npos);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_EQ(error.fault(), Fault::other);
    }
}

TEST_F(OutputFileTest, refuses_a_folder) { EXPECT_THROW(OutputFile{folder}, Error); }

TEST_F(OutputFileTest, refuses_a_folder_without_permission) {
    if (::geteuid() == 0) GTEST_SKIP() << "THE SUPERUSER MAY WRITE EVERYWHERE";
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THROW(OutputFile{place}, Error);
    fs::permissions(folder, fs::perms::owner_all);
}

TEST(OutputFile, notices_a_full_disk) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "NO /dev/full HERE";
    OutputFile little("/dev/full"), much("/dev/full");
    little.stream() << "x";
    EXPECT_THROW(little.keep(), Error);
    much.stream() << std::string(1'000'000, 'x');
    EXPECT_THROW(much.keep(), Error);
    EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST(OutputFile, writes_straight_to_a_device) {
    OutputFile file("/dev/null");
    file.stream() << "x";
    file.keep();
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace bead
