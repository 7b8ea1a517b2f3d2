// The wanted files of a zip archive, by libzip.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace bead {

// Path in the archive to content. Throws Error, named for `name`, when the archive is broken or the
// wanted files unpack to more than `most` bytes.
std::map<std::string, std::string> unzipped(std::string_view bytes, std::string_view name,
                                            std::size_t most,
                                            const std::function<bool(std::string_view)>& wanted);

}  // namespace bead
