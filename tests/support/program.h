// Runs the built program as a user would and keeps what it says.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace bead::test {

struct Outcome {
    int status = 0;
    std::string out, err;
};

inline std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

// A folder of its own for each test, gone at its end.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "beadwork-XXXXXX").string();
        place_ = ::mkdtemp(name.data());
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(place_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return (place_ / name).string(); }
    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(place_ / name, std::ios::binary) << text;
        return *this / name;
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(place_), {}));
    }

  private:
    std::filesystem::path place_;
};

// `arguments` as typed in a shell.
inline Outcome beadwork(const std::string& arguments) {
    const Folder folder;
    const std::string line = std::string(BEAD_PROGRAM) + " " + arguments + " >" + (folder / "out") +
                             " 2>" + (folder / "err") + " </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, content(folder / "out"),
            content(folder / "err")};
}

}  // namespace bead::test
