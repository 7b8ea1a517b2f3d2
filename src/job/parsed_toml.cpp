#include "job/parsed_toml.h"

#include <fmt/format.h>

#include "core/error.h"
#include "job/one_line.h"

namespace bead {

toml::table parsed_toml(std::string_view text, const std::string& file) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw Error(fmt::format("{}:{}: not valid TOML: {}; correct the line", file,
                                error.source().begin.line, one_line(error.description())));
    }
}

}  // namespace bead
