// A file that appears whole or not at all, even if the power fails: it is written beside its place
// and renamed into it. It keeps the permissions of the file that it replaces; where a symbolic link
// leads to that file, the link stays.
//
//     OutputFile file("part.gcode");
//     write(file.stream());
//     file.keep();               // without this the half-written file is removed
#pragma once
#include <filesystem>
#include <fstream>

namespace bead {

class OutputFile {
  public:
    // Throws Error when the folder does not exist or cannot be written to.
    explicit OutputFile(std::filesystem::path place);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    std::ostream& stream() { return stream_; }
    // Flushes, checks that every byte arrived (a full disk does not go unseen) and renames.
    void keep();

  private:
    std::filesystem::path place_, beside_;
    std::ofstream stream_;
};

}  // namespace bead
