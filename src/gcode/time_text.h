// Times as slicers write them in comments: "1d 2h 3m 4s", whole seconds, no zeros in front.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace bead {

std::string time_text(double seconds);  // cut to whole seconds, as slicers do
// In s, of any text with numbers before d, h, m or s.
std::optional<double> time_in(std::string_view text);

}  // namespace bead
