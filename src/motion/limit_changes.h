// M201, M203, M204 and M205 take effect: limits with what a SetLimits command names put in.
#pragma once
#include "machine/limits.h"
#include "toolpath/command.h"

namespace bead {

// Values that are not above zero are ignored, as no machine moves with them.
Limits changed(Limits limits, const SetLimits& change);

// A command that sets all that a SetLimits can say.
SetLimits as_command(const Limits& limits);

}  // namespace bead
