// The text of a process file, whatever its form; `read_config` in settings.h reads it from disk.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "job/settings.h"

namespace bead {

// `file` names the text in messages, and its ending says what the text is: .toml or .ini.
// Returns what was ignored, as read_config does.
std::vector<std::string> read_config_text(Settings& settings, std::string_view text,
                                          const std::string& file);

}  // namespace bead
