#include "core/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/error.h"

namespace bead {
namespace {

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

std::filesystem::path beside(const std::filesystem::path& place) {
    std::filesystem::path name = place;
    name += ".part" + std::to_string(::getpid());
    return name;
}

// /dev/stdout, /dev/null and pipes are written to directly: there is nothing to rename.
bool is_special(const std::filesystem::path& place) {
    std::error_code ignored;
    const auto status = std::filesystem::status(place, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path place) : place_(std::move(place)) {
    if (std::filesystem::is_directory(place_))
        throw Error(place_.string() + ": is a folder; name a file to write", Fault::other);
    beside_ = is_special(place_) ? place_ : beside(place_);
    errno = 0;
    stream_.open(beside_, std::ios::binary | std::ios::trunc);
    if (!stream_)
        throw Error(place_.string() + ": cannot be written (" + reason() +
                        "); choose a folder that exists and that you may write to",
                    Fault::other);
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    stream_.close();
    if (!beside_.empty() && beside_ != place_) std::filesystem::remove(beside_, ignored);
}

void OutputFile::keep() {
    errno = 0;
    stream_.close();
    if (!stream_)
        throw Error(place_.string() + ": could not be written completely (" + reason() +
                        "); the file was not changed; make room or choose another place",
                    Fault::other);
    if (beside_ != place_) {
        std::error_code failure;
        std::filesystem::rename(beside_, place_, failure);
        if (failure)
            throw Error(place_.string() + ": could not be put in place (" + failure.message() + ")",
                        Fault::other);
    }
    beside_.clear();
}

}  // namespace bead
