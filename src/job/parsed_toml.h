// toml++ for this module's sources; no other header includes this one.
//
// Its parser states, as assertions, what it then checks and reports properly ("[=]" breaks one).
// They are switched off here, so that every text ends in a table or an Error in every build; an
// assumption told to the compiler would be worse. All sources must agree on that, hence include
// toml++ only through here.
#pragma once
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(condition) static_assert(true)
#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace bead {

// `file` names the text in messages. Throws Error with the line that is not TOML.
toml::table parsed_toml(std::string_view text, const std::string& file);

}  // namespace bead
