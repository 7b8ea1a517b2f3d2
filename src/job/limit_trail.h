// How a file changes its limits while it runs: which limit, by which command, on which line first,
// how often, and to what in the end. Only what the machine really takes over counts, so the limits
// before and after the command are what is compared.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "job/limit_table.h"
#include "toolpath/command.h"

namespace bead {

struct LimitChange {
    std::int64_t times = 0;
    std::int64_t first_line = 0;
    std::string command;  // the first one's, "M204"
};

class LimitTrail {
  public:
    LimitTrail();
    void note(const SetLimits& told, std::int64_t line, const Limits& before, const Limits& after);
    // Nothing for a limit that never changed.
    [[nodiscard]] std::optional<LimitChange> change(const NamedLimit& limit) const;

  private:
    std::vector<LimitChange> changes_;  // as named_limits()
};

// The command that sets what `told` names, "M203" or "SET_VELOCITY_LIMIT". Klipper has two that set
// the head's acceleration alone.
std::string_view command_of(const SetLimits& told);

}  // namespace bead
