#include "job/data_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "job/embedded_files.h"
#include "job/nearest_name.h"

namespace bead {

namespace {

constexpr std::string_view extension = ".toml";

// The name of a built-in file of this kind; empty if it is of another.
std::string_view name_in(std::string_view kind, std::string_view path) {
    const std::string folder = fmt::format("{}s/", kind);
    if (!path.starts_with(folder)) return {};
    path.remove_prefix(folder.size());
    return path.substr(0, path.size() - extension.size());
}

[[noreturn]] void refuse(std::string_view kind, std::string_view name) {
    const std::vector<std::string> names = data_names(kind);
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw Error(fmt::format("unknown {} {}{}; built in are {}; one of your own must end in {}",
                            kind, name, suggestion(name, views), fmt::join(names, ", "), extension),
                Fault::usage);
}

}  // namespace

DataFile file_on_disk(std::string_view kind, const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file.is_open() || std::filesystem::is_directory(path))
        throw Error(
            fmt::format("{}: cannot be read; is the path of the {} file right?", path, kind));
    return {path, {std::istreambuf_iterator<char>(file), {}}};
}

DataFile data_file(std::string_view kind, const std::string& name_or_file) {
    if (name_or_file.ends_with(extension)) return file_on_disk(kind, name_or_file);
    for (const EmbeddedFile& file : embedded_files())
        if (!name_or_file.empty() && name_in(kind, file.path) == name_or_file)
            return {fmt::format("built-in {} {}", kind, name_or_file), file.text};
    refuse(kind, name_or_file);
}

std::vector<std::string> data_names(std::string_view kind) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_files())
        if (const std::string_view name = name_in(kind, file.path); !name.empty())
            names.emplace_back(name);
    std::ranges::sort(names);
    return names;
}

}  // namespace bead
