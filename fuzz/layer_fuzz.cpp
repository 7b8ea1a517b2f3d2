// Any bytes taken apart into layers are the same bytes put together again (the last line ended), or
// an Error; no layer is planned past its lines, and what can be written anew is. The first byte
// says whose rules.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "core/error.h"
#include "gcode/layer_plan.h"
#include "gcode/motion_text.h"
#include "gcode/read_source.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void check(const bead::FileLayer& layer, const bead::LayerPlan& plan) {
    require(plan.head_end <= plan.tail_begin && plan.tail_begin <= layer.lines.size());
    std::uint32_t text = 0, moves = 0;
    for (const bead::FileLine& line : layer.lines) {
        require(line.text_end >= text && line.moves_end >= moves);
        text = line.text_end;
        moves = line.moves_end;
    }
    require(text == layer.text.size() && moves == layer.moves.size());
    for (const bead::Path& path : plan.body) require(path.points.size() > 1);
}

std::string put_together(const std::string& bytes, bead::Firmware firmware) {
    std::istringstream text(bytes);
    std::string result;
    bead::LayerReader reader(bead::stream_source(text), {.firmware = firmware});
    bead::LayerPlanner planner(1.75);
    while (const auto layer = reader.next()) {
        const bead::LayerPlan plan = planner.plan(*layer);
        check(*layer, plan);
        if (plan.obstacle.empty() && !plan.body.empty()) {
            bead::MotionText motion(planner.style(), {plan.head.at, plan.head.pulled_back});
            motion.follow(plan.body, plan.z);
            require(!motion.text().empty());
        }
        result += layer->text;
    }
    reader.finish();
    return result;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto firmware = bead::Firmware(data[0] % bead::firmware_names.size());
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        const std::string ended = bytes.empty() || bytes.back() == '\n' ? bytes : bytes + '\n';
        require(put_together(bytes, firmware) == ended);
    } catch (const bead::Error&) {
        return 0;
    }
    return 0;
}
