// A layer before and after, for people who would rather look than read.
#pragma once
#include <string>

#include "study/optimize.h"

namespace bead::cli {

void write_picture(const std::string& file, const Optimum& best);

}  // namespace bead::cli
