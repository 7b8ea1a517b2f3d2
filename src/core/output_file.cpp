#include "core/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
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

std::filesystem::path behind_links(std::filesystem::path place) {
    std::error_code missing;
    if (!std::filesystem::is_symlink(place, missing)) return place;
    std::filesystem::path target = std::filesystem::canonical(place, missing);
    return missing ? place : target;
}

// As far as we may: only the superuser can give a file to its owner.
void take_owner_and_permissions(const std::filesystem::path& from,
                                const std::filesystem::path& to) {
    struct stat old {};
    if (::stat(from.c_str(), &old) != 0) return;
    if (::chown(to.c_str(), old.st_uid, old.st_gid) != 0) errno = 0;
    if (::chmod(to.c_str(), old.st_mode & 07777) != 0) errno = 0;
}

// True if the disk has it. Folders of some file systems cannot be asked; that is no failure.
bool reaches_disk(const std::filesystem::path& place) {
    const int file = ::open(place.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return errno == EACCES || errno == EPERM;
    const bool done = ::fsync(file) == 0 || errno == EINVAL;
    ::close(file);
    return done;
}

// /dev/stdout, /dev/null and pipes are written to directly: there is nothing to rename.
bool is_special(const std::filesystem::path& place) {
    std::error_code ignored;
    const auto status = std::filesystem::status(place, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path place) : place_(behind_links(std::move(place))) {
    if (std::filesystem::is_directory(place_))
        throw Error(place_.string() + ": is a folder; name a file to write", Fault::other);
    beside_ = is_special(place_) ? place_ : beside(place_);
    errno = 0;
    stream_.open(beside_, std::ios::binary | std::ios::trunc);
    if (!stream_)
        throw Error(place_.string() + ": cannot be written (" + reason() +
                        "); choose a folder that exists and that you may write to",
                    Fault::other);
    if (beside_ != place_) take_owner_and_permissions(place_, beside_);
}

OutputFile::~OutputFile() {
    std::error_code ignored;
    stream_.close();
    if (!beside_.empty() && beside_ != place_) std::filesystem::remove(beside_, ignored);
}

void OutputFile::keep() {
    errno = 0;
    stream_.close();
    if (!stream_ || (beside_ != place_ && !reaches_disk(beside_)))
        throw Error(place_.string() + ": could not be written completely (" + reason() +
                        "); the file was not changed; make room or choose another place",
                    Fault::other);
    if (beside_ != place_) {
        std::error_code failure;
        std::filesystem::rename(beside_, place_, failure);
        if (failure)
            throw Error(place_.string() + ": could not be put in place (" + failure.message() + ")",
                        Fault::other);
        reaches_disk(std::filesystem::absolute(place_).parent_path());
    }
    beside_.clear();
}

}  // namespace bead
