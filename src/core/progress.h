// How long work tells how far it is: a fraction from 0 to 1 and what is being done.
// Functions take it as an option; an empty one is fine.
#pragma once
#include <functional>
#include <string_view>

namespace bead {

using Progress = std::function<void(double fraction, std::string_view stage)>;

inline void tell(const Progress& progress, double fraction, std::string_view stage) {
    if (progress) progress(fraction, stage);
}

}  // namespace bead
