// The content of a gzip file (RFC 1952), by zlib.
#pragma once
#include <string>
#include <string_view>

namespace bead {

[[nodiscard]] bool is_gzip(std::string_view bytes);

// Throws Error, named for `name`, when the data is broken, truncated or longer than `most` bytes.
std::string gunzipped(std::string_view bytes, std::string_view name, std::size_t most);

}  // namespace bead
