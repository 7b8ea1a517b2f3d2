#include "job/parsed_toml.h"

#include <fmt/format.h>

#include "job/one_line.h"

namespace bead {

namespace {

bool is_option(std::string_view file) { return file.starts_with("--"); }

}  // namespace

std::string place_in(std::string_view file, toml::source_index line) {
    return is_option(file) ? std::string(file) : fmt::format("{}:{}", file, line);
}

Fault fault_in(std::string_view file) { return is_option(file) ? Fault::usage : Fault::input; }

toml::table parsed_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw Error(
            fmt::format("{}: not valid TOML: {}; correct it",
                        place_in(file, error.source().begin.line), one_line(error.description())),
            fault_in(file));
    }
}

}  // namespace bead
