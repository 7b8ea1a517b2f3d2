#include "mesh/gunzip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/error.h"

namespace bead {
namespace {

struct End {
    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

constexpr std::size_t step = std::size_t{1} << 17U;
constexpr int gzip_window = 16 + MAX_WBITS;  // 16: with a gzip header

Error broken(std::string_view name) {
    return Error(
        fmt::format("{}: the gzip data is broken or cut short; is the download complete?", name));
}

// Decompresses up to `step` more bytes to the end of `content`; returns zlib's status.
int inflate_step(z_stream& stream, std::string& content) {
    const std::size_t before = content.size();
    content.resize(before + step);
    stream.next_out = reinterpret_cast<Bytef*>(content.data() + before);
    stream.avail_out = static_cast<uInt>(step);
    const int status = inflate(&stream, Z_NO_FLUSH);
    content.resize(content.size() - stream.avail_out);
    return status;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzipped(std::string_view bytes, std::string_view name, std::size_t most) {
    if (bytes.size() > std::numeric_limits<uInt>::max()) throw broken(name);
    z_stream stream{};
    if (inflateInit2(&stream, gzip_window) != Z_OK) throw broken(name);
    const std::unique_ptr<z_stream, End> guard(&stream);
    // zlib never writes to its input.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());

    std::string content;
    while (true) {
        const int status = inflate_step(stream, content);
        if (content.size() > most)
            throw Error(fmt::format("{}: unpacks to more than {} MB; no mesh is that large", name,
                                    most >> 20U));
        if (status == Z_STREAM_END) {
            const std::string_view rest = bytes.substr(bytes.size() - stream.avail_in);
            if (!is_gzip(rest)) return content;  // else the next member of the file
            inflateReset(&stream);
        } else if (status != Z_OK) {
            throw broken(name);
        }
    }
}

}  // namespace bead
