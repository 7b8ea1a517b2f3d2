#include "motion/look_ahead.h"

#include <algorithm>

#include "motion/trapezoid.h"

namespace bead {
namespace {

constexpr std::size_t look_every = 256;  // blocks between two searches for settled ones

void shape(Block& block, double entry2, double exit2) {
    const Trapezoid t =
        trapezoid_of_squares(block.length, block.v_nominal, entry2, exit2, block.acceleration);
    block.v_entry = t.v_entry;
    block.v_peak = t.v_peak;
    block.v_exit = t.v_exit;
    block.t_accel = t.t_accel;
    block.t_cruise = t.t_cruise;
    block.t_decel = t.t_decel;
}

}  // namespace

LookAhead::LookAhead(const LookAheadRules& rules, MotionSink sink)
    : rules_(rules),
      sink_(std::move(sink)),
      places_(32),
      events_(32, Block{}),
      mask_(places_.size() - 1),
      next_look_(look_every) {}

std::size_t LookAhead::waiting() const { return end_ - begin_ - (running_ ? 1 : 0); }

void LookAhead::pass(const MotionEvent& event) {
    if (empty())
        sink_(event);
    else
        between_.emplace_back(end_, event);
}

void LookAhead::make_room() {
    if (rules_.depth == 0 || end_ - begin_ + 1 < std::size_t(rules_.depth)) return;
    release_front();
    run_front();
}

void LookAhead::push(const Junction& junction) {
    const Block& added = block();
    place(end_) = {.max_entry = junction.max_entry,
                   .brake_entry = junction.entry,
                   .entry = junction.entry,
                   .last_exit = junction.last_exit,
                   .room = 2 * added.acceleration * added.length,
                   .halt = junction.halt,
                   .apart = junction.apart,
                   .at_nominal = junction.at_nominal,
                   .pinned = false};
    if (++end_ - begin_ > mask_) grow();
    sweep_forward(sweep_back());
    if (rules_.depth == 0 && end_ - begin_ >= next_look_) {
        release_until(settled());
        next_look_ = end_ - begin_ + look_every;
    }
}

// Keeps one place free for the block to come.
void LookAhead::grow() {
    std::vector<Place> places(2 * places_.size());
    std::vector<MotionEvent> events(2 * events_.size(), Block{});
    const std::size_t mask = places.size() - 1;
    for (std::size_t k = begin_; k < end_; ++k) {
        places[k & mask] = place(k);
        events[k & mask] = event(k);
    }
    places_.swap(places);
    events_.swap(events);
    mask_ = mask;
}

// The speed, squared, that block k has to have come down to at its end.
double LookAhead::end_speed(std::size_t k) const {
    if (k + 1 == end_ || place(k + 1).apart) return place(k).last_exit;
    return place(k + 1).entry;
}

// From the newest block back: entries as high as braking allows, as far as the newest block makes a
// difference. Returns the last block that stays as it was.
std::size_t LookAhead::sweep_back() {
    std::size_t k = end_ - 1;
    double end = place(k).brake_entry;
    bool apart = place(k).apart;
    while (k-- > begin_) {
        Place& p = place(k);
        if (p.pinned || (p.halt && !rules_.bounded_halts)) return k;
        if (apart) end = p.last_exit;
        const bool at_most = p.at_nominal || (rules_.at_most_stays && p.entry == p.max_entry);
        end = at_most ? p.max_entry : std::min(p.max_entry, end + p.room);
        if (end == p.brake_entry) return k;
        p.brake_entry = p.entry = end;
        apart = p.apart;
    }
    return begin_;
}

// From there on: entries no higher than the block before can reach.
void LookAhead::sweep_forward(std::size_t unchanged) {
    for (std::size_t k = unchanged + 1; k < end_; ++k) {
        const Place& before = place(k - 1);
        Place& p = place(k);
        if (p.pinned) continue;
        p.entry = p.brake_entry;
        if (!p.apart && !before.at_nominal && before.entry < p.entry)
            p.entry = std::min(p.entry, before.entry + before.room);
    }
}

// The first block that later ones may still change: the last one that is entered at its maximum
// even if the machine had to stop right after what is known.
std::size_t LookAhead::settled() const {
    double v = 0;
    for (std::size_t k = end_ - 1; k > begin_; --k) {
        const Place& p = place(k);
        const bool stays = rules_.at_most_stays && p.brake_entry == p.max_entry;
        v += p.room;
        if (p.halt || stays || p.at_nominal || v >= p.max_entry) return k;
    }
    return begin_;
}

void LookAhead::release_until(std::size_t end) {
    while (begin_ < end) release_front();
    if (!empty()) place(begin_).pinned = !place(begin_).apart;
}

// The oldest block is done.
void LookAhead::release_front() {
    shape(std::get<Block>(event(begin_)), place(begin_).entry,
          running_ ? running_exit_ : end_speed(begin_));
    while (!between_.empty() && between_.front().first <= begin_) {
        sink_(between_.front().second);
        between_.pop_front();
    }
    sink_(event(begin_));
    ++begin_;
    running_ = false;
}

// The oldest block begins to run: how it is entered and left is final.
void LookAhead::run_front() {
    if (empty()) return;
    running_exit_ = end_speed(begin_);
    running_ = true;
    place(begin_).pinned = true;
    if (!rules_.late_raise && begin_ + 1 < end_ && !place(begin_ + 1).apart)
        place(begin_ + 1).pinned = true;
}

void LookAhead::drain() {
    while (begin_ < end_) release_front();
    for (const auto& [block, event] : between_) sink_(event);
    between_.clear();
    next_look_ = look_every;
}

}  // namespace bead
