#include "gcode/text_source.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <memory>
#include <string>

#include "core/error.h"
#include "gcode/plate_source.h"

namespace bead {
namespace {

std::string system_reason() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

// zlib passes what is not gzipped through as it is.
std::shared_ptr<gzFile_s> opened(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file))
        throw Error(file.string() + ": is a folder; name a G-code file");
    errno = 0;
    gzFile const handle = gzopen(file.c_str(), "rb");
    if (handle == nullptr)
        throw Error(file.string() + ": cannot be opened (" + system_reason() +
                    "); check its name and that you may read it");
    gzbuffer(handle, 1U << 16);  // at most half a chunk: then plain text is not copied once more
    return {handle, gzclose};
}

[[noreturn]] void fail(gzFile file, const std::string& name) {
    int code = Z_OK;
    const std::string reason = gzerror(file, &code);
    if (code == Z_ERRNO) throw Error(name + ": cannot be read (" + system_reason() + ")");
    throw Error(name + ": its compressed data are damaged or cut short (" + reason +
                "); copy or export the file again");
}

}  // namespace

TextSource stream_source(std::istream& text) {
    return [&text](std::span<char> place) {
        text.read(place.data(), std::streamsize(place.size()));
        return std::size_t(text.gcount());
    };
}

OpenedText open_text(const std::filesystem::path& file) {
    const auto handle = opened(file);
    if (is_archive(file)) return open_plate(file);
    const TextSource source = [handle, name = file.string()](std::span<char> place) {
        const auto most = unsigned(std::min<std::size_t>(place.size(), INT_MAX));
        const int count = gzread(handle.get(), place.data(), most);
        int code = Z_OK;
        if (count <= 0) gzerror(handle.get(), &code);
        if (count < 0 || code != Z_OK) fail(handle.get(), name);
        return std::size_t(count);
    };
    return {source, {}};
}

TextSource file_source(const std::filesystem::path& file) { return open_text(file).source; }

}  // namespace bead
