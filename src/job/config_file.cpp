#include "job/config_file.h"

#include <fmt/format.h>

#include <optional>

#include "core/error.h"
#include "job/one_line.h"
#include "job/parsed_toml.h"
#include "job/prusa_ini.h"
#include "job/whole_text.h"

namespace bead {
namespace {

// A value as `set` takes it; none for tables, arrays and dates.
std::optional<std::string> text_of(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    return std::nullopt;
}

void read_toml(Settings& settings, std::string_view text, const std::string& file) {
    for (const auto& [key, node] : parsed_toml(text, file)) {
        const std::string where = fmt::format("{}:{}", file, node.source().begin.line);
        const std::optional<std::string> value = text_of(node);
        if (!value)
            throw Error(
                fmt::format("{}: {} is not a line of the form name = value; settings are "
                            "in no table and have one value",
                            where, one_line(key.str())));
        set(settings, key.str(), *value, where);
    }
}

}  // namespace

std::vector<std::string> read_config_text(Settings& settings, std::string_view text,
                                          const std::string& file) {
    if (file.ends_with(".ini")) return read_prusa_ini(settings, text, file);
    if (!file.ends_with(".toml"))
        throw Error(file + ": a process file ends in .toml or, of PrusaSlicer, in .ini");
    read_toml(settings, text, file);
    return {};
}

std::vector<std::string> read_config(Settings& settings, const std::string& file) {
    return read_config_text(settings, whole_text(file), file);
}

}  // namespace bead
