// What somebody may have meant by a name that does not exist, for error messages.
//
//     nearest_name("wals", names)          // "walls"
//     nearest_name("layer_hight", names)   // "layer_height_mm": a missing tail is forgiven
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace bead {

// The known name that most resembles the wrong one, "" if none does. Case, '-' and '_' are alike.
std::string nearest_name(std::string_view wrong, std::span<const std::string_view> known);

// "; did you mean walls?", or nothing.
std::string suggestion(std::string_view wrong, std::span<const std::string_view> known);

}  // namespace bead
