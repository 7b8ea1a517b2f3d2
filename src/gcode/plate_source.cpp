#include "gcode/plate_source.h"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>

#include "core/error.h"

namespace bead {
namespace {

// Of "Metadata/plate_2.gcode": 2.
std::optional<int> plate_number(std::string_view path) {
    constexpr std::string_view start = "Metadata/plate_", end = ".gcode";
    if (!path.starts_with(start) || !path.ends_with(end)) return {};
    if (path.size() <= start.size() + end.size()) return {};
    const std::string_view digits =
        path.substr(start.size(), path.size() - start.size() - end.size());
    int number = 0;
    const auto [stop, fault] = std::from_chars(digits.begin(), digits.end(), number);
    return fault == std::errc() && stop == digits.end() ? std::optional(number) : std::nullopt;
}

std::shared_ptr<zip_t> opened_archive(const std::filesystem::path& file) {
    int fault = 0;
    zip_t* const archive = zip_open(file.c_str(), ZIP_RDONLY, &fault);
    if (archive == nullptr)
        throw Error(file.string() + ": not a complete zip archive; copy or export the file again");
    return {archive, zip_discard};
}

struct Plate {
    zip_uint64_t index;
    int number;
    std::string path;
};

std::optional<Plate> first_plate(zip_t* archive) {
    std::optional<Plate> first;
    const zip_int64_t count = zip_get_num_entries(archive, 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* const path = zip_get_name(archive, zip_uint64_t(i), 0);
        const auto number = path != nullptr ? plate_number(path) : std::nullopt;
        if (number && (!first || *number < first->number))
            first = Plate{zip_uint64_t(i), *number, path};
    }
    return first;
}

}  // namespace

bool is_archive(const std::filesystem::path& file) {
    std::string start(4, '\0');
    std::ifstream(file, std::ios::binary).read(start.data(), std::streamsize(start.size()));
    return start == "PK\3\4";
}

OpenedText open_plate(const std::filesystem::path& file) {
    const std::shared_ptr<zip_t> archive = opened_archive(file);
    const std::optional<Plate> plate = first_plate(archive.get());
    if (!plate)
        throw Error(file.string() +
                    ": no plate in it is sliced (there is no Metadata/plate_1.gcode); export the "
                    "sliced file, or slice the model");
    const std::string name = file.string() + " (" + plate->path + ")";
    const std::shared_ptr<zip_file_t> entry(zip_fopen_index(archive.get(), plate->index, 0),
                                            [](zip_file_t* open) {
                                                if (open != nullptr) zip_fclose(open);
                                            });
    if (!entry) throw Error(name + ": cannot be unpacked (" + zip_strerror(archive.get()) + ")");
    const TextSource source = [archive, entry, name](std::span<char> place) {
        const zip_int64_t count = zip_fread(entry.get(), place.data(), place.size());
        if (count < 0)
            throw Error(name + ": its compressed data are damaged; export the file again");
        return std::size_t(count);
    };
    return {source, plate->path};
}

}  // namespace bead
