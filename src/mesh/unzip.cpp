#include "mesh/unzip.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "core/error.h"

namespace bead {
namespace {

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Entry = std::unique_ptr<zip_file_t, Close>;

Error broken_archive(std::string_view name) {
    return Error(fmt::format(
        "{}: not a complete zip archive (3MF is one); is the download complete?", name));
}

Archive opened(std::string_view bytes, std::string_view name) {
    zip_error_t fault;
    zip_error_init(&fault);
    zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &fault);
    if (source == nullptr) throw broken_archive(name);
    Archive archive(zip_open_from_source(source, ZIP_RDONLY, &fault));
    zip_error_fini(&fault);
    if (!archive) {
        zip_source_free(source);
        throw broken_archive(name);
    }
    return archive;
}

// Grows with what really comes out, whatever size the archive claims.
std::string content(zip_t* archive, zip_uint64_t index, std::string_view name, std::size_t most) {
    const Entry entry(zip_fopen_index(archive, index, 0));
    if (!entry) throw broken_archive(name);
    constexpr std::size_t step = std::size_t{1} << 17U;
    std::string text;
    while (true) {
        const std::size_t before = text.size();
        text.resize(before + step);
        const zip_int64_t got = zip_fread(entry.get(), text.data() + before, step);
        if (got < 0) throw broken_archive(name);
        text.resize(before + static_cast<std::size_t>(got));
        if (text.size() > most)
            throw Error(fmt::format("{}: unpacks to more than {} MB; no mesh is that large", name,
                                    most >> 20U));
        if (got == 0) return text;
    }
}

}  // namespace

std::map<std::string, std::string> unzipped(std::string_view bytes, std::string_view name,
                                            std::size_t most,
                                            const std::function<bool(std::string_view)>& wanted) {
    const Archive archive = opened(bytes, name);
    std::map<std::string, std::string> files;
    std::size_t left = most;
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* const path = zip_get_name(archive.get(), index, 0);
        if (path == nullptr || !wanted(path)) continue;
        std::string text = content(archive.get(), index, name, left);
        left -= text.size();
        files.insert_or_assign(path, std::move(text));
    }
    return files;
}

}  // namespace bead
