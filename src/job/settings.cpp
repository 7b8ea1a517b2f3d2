#include "job/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/expects.h"
#include "job/nearest_name.h"
#include "job/one_line.h"

namespace bead {
namespace {

const Setting* find(std::string_view name) {
    const std::span<const Setting> all = all_settings();
    const auto row = std::ranges::find(all, name, &Setting::name);
    return row == all.end() ? nullptr : &*row;
}

Fault fault_at(std::string_view where) {
    return where.starts_with("--") ? Fault::usage : Fault::input;
}

Error unknown(std::string_view name, std::string_view where) {
    std::vector<std::string_view> names;
    for (const Setting& setting : all_settings()) names.push_back(setting.name);
    return Error(
        fmt::format("{}: there is no setting {}{}", where, one_line(name), suggestion(name, names)),
        fault_at(where));
}

void check_width(const Settings& settings, std::string_view width, double mm,
                 std::string_view height, double at_least) {
    if (mm >= at_least) return;
    throw Error(fmt::format("settings: {} = {} is less than {} = {}; a bead must be at least as "
                            "wide as it is high",
                            width, get(settings, width), height, get(settings, height)),
                Fault::usage);
}

}  // namespace

void set(Settings& settings, std::string_view name, std::string_view value,
         std::string_view where) {
    const Setting* const setting = find(name);
    if (!setting) throw unknown(name, where);
    const std::string_view text = trimmed(value);
    if (setting->set(settings, text)) return;
    throw Error(fmt::format("{}: {} = {} is not {}", where, name, one_line(text), setting->allowed),
                fault_at(where));
}

std::string get(const Settings& settings, std::string_view name) {
    const Setting* const setting = find(name);
    BEAD_EXPECTS(setting != nullptr);
    return setting->get(settings);
}

void check(const Settings& settings) {
    const SliceOptions& slice = settings.slice;
    const PlanOptions& plan = settings.plan;
    check_width(settings, "bead_width_mm", plan.bead_width, "layer_height_mm", slice.layer_height);
    check_width(settings, "first_layer_width_mm", plan.first_layer_width, "first_layer_height_mm",
                slice.first_layer_height);
}

}  // namespace bead
