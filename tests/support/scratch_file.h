// A text file in the test's temporary folder, gone when it goes out of scope; tests may run at
// once.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace bead::test {

class ScratchFile {
  public:
    ScratchFile(const std::string& name, std::string_view text)
        : path_(std::filesystem::path(testing::TempDir()) /
                (std::to_string(getpid()) + '-' + name)) {
        std::ofstream(path_, std::ios::binary) << text;
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile() { std::filesystem::remove(path_); }

    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

}  // namespace bead::test
