// Every limit of a machine by its name in [limits] of a PRINTER.toml: the one place where these
// names stand. Limits that a source states (statement.h) leave its name when they are put into a
// SourcedLimits.
//
//     SourcedLimits limits(printer.limits, "default printer");
//     limits.put(statement.limits);
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "job/statement.h"
#include "job/toml_reader.h"
#include "machine/firmware.h"
#include "machine/limits.h"

namespace bead {

enum class LimitForm { number, whole, flag };  // of a flag, 0 and 1

struct NamedLimit {
    std::string_view name;   // "jerk_mm_s"; the unit is part of the name
    std::string_view about;  // for people, "jerk"
    std::string_view unit;   // for people, "mm/s"
    std::size_t count;       // 4: X, Y, Z, E; else 1
    Range allowed;
    LimitForm form;
    unsigned used_by;  // bits of firmwares, see `uses`
    double (*get)(const Limits&, std::size_t axis);
    void (*put)(Limits&, std::size_t axis, double value);
};

std::span<const NamedLimit> named_limits();
const NamedLimit& named_limit(std::string_view name);  // expects that there is such a limit

// Whether the firmware's planner looks at the limit.
bool uses(Firmware firmware, const NamedLimit& limit);
bool is_allowed(const NamedLimit& limit, double value);

// Those that the file's [limits] name, each with its place there as the source. Asks for all, so
// that TomlReader::finish knows them.
std::vector<StatedLimit> stated_limits(TomlReader& file);

class SourcedLimits {
  public:
    SourcedLimits() : SourcedLimits(Limits{}, "nowhere") {}
    SourcedLimits(const Limits& limits, const std::string& source);

    void put(const StatedLimit& limit);
    void put(const std::vector<StatedLimit>& limits);
    [[nodiscard]] const Limits& limits() const { return limits_; }
    // "printer.toml:7"; where axes differ, "X, Y: printer.toml:7; Z, E: default printer".
    [[nodiscard]] std::string source(const NamedLimit& limit) const;

  private:
    Limits limits_;
    std::vector<std::array<std::string, 4>> sources_;  // as named_limits(), by axis
};

}  // namespace bead
