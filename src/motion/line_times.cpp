#include "motion/line_times.h"

#include "core/expects.h"

namespace bead {

LineTimes::LineTimes(std::vector<std::int64_t> lines) : lines_(std::move(lines)) {
    times_.reserve(lines_.size());
}

void LineTimes::add(const Command& command) {
    if (std::holds_alternative<Dwell>(command.what)) dwells_.push_back(command.line);
}

void LineTimes::add(const MotionEvent& event) {
    if (const Block* const block = std::get_if<Block>(&event)) {
        pass(block->line, duration(*block));
    } else if (const Dwell* const dwell = std::get_if<Dwell>(&event)) {
        BEAD_EXPECTS(!dwells_.empty());
        pass(dwells_.front(), dwell->duration);
        dwells_.pop_front();
    }
}

std::vector<double> LineTimes::finish() {
    times_.resize(lines_.size(), elapsed_);
    return times_;
}

void LineTimes::pass(std::int64_t line, double duration) {
    while (times_.size() < lines_.size() && lines_[times_.size()] <= line)
        times_.push_back(elapsed_);
    elapsed_ += duration;
}

}  // namespace bead
