// The queue of a firmware's planner: blocks wait in it so that each is entered no faster than what
// follows can be braked for. A backward sweep over the queue lowers entries for that, a forward one
// to what the blocks before can reach; both go only as far as the newest block makes a difference.
// Speeds are kept squared: the sweeps then need no root.
//
//     LookAhead queue(rules, sink);
//     Block& block = queue.block();         // the next one, to be filled in
//     queue.push({.max_entry = v, …});      // enters the queue, older blocks leave it to the sink
//     queue.drain();                        // the machine comes to rest
#pragma once
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "motion/block.h"

namespace bead {

struct LookAheadRules {
    int depth = 16;             // ring size; one place stays free, one block runs. 0: unlimited
    bool bounded_halts = true;  // a block that starts from a halt is slowed down for what follows
    bool late_raise = false;    // the running block's exit is fixed, its successor's entry may rise
    bool at_most_stays = false;  // an entry that once was at its maximum is not looked at again
};

// How a block may be entered and left; speeds squared, (mm/s)².
struct Junction {
    double max_entry = 0;     // what the junction before it allows
    double entry = 0;         // at first: also with regard to its own length
    double last_exit = 0;     // its speed at its end while nothing follows
    bool halt = false;        // starts from a full halt …
    bool apart = false;       // … that the block before it ends with its own last_exit for
    bool at_nominal = false;  // reaches its nominal speed whatever the rest: skips the sweeps
};

class LookAhead {
  public:
    LookAhead(const LookAheadRules& rules, MotionSink sink);

    [[nodiscard]] Block& block() { return std::get<Block>(event(end_)); }
    void push(const Junction& junction);
    // An event that takes effect after the blocks so far.
    void pass(const MotionEvent& event);
    void drain();
    [[nodiscard]] bool empty() const { return begin_ == end_; }
    [[nodiscard]] std::size_t size() const { return end_ - begin_; }
    // Blocks that wait and do not run yet.
    [[nodiscard]] std::size_t waiting() const;

    // Lets the oldest block go if the ring is full, as firmware does before it plans another one.
    void make_room();

  private:
    struct Place {           // speeds squared, (mm/s)²
        double max_entry;    // what the junction allows
        double brake_entry;  // from which what follows can be braked for
        double entry;        // which the blocks before can reach too
        double last_exit;    // while nothing follows
        double room;         // by how much v² can change along it
        bool halt, apart, at_nominal;
        bool pinned;  // entry is final
    };

    Place& place(std::size_t k) { return places_[k & mask_]; }
    [[nodiscard]] const Place& place(std::size_t k) const { return places_[k & mask_]; }
    MotionEvent& event(std::size_t k) { return events_[k & mask_]; }
    void grow();
    std::size_t sweep_back();
    void sweep_forward(std::size_t unchanged);
    [[nodiscard]] double end_speed(std::size_t k) const;
    [[nodiscard]] std::size_t settled() const;
    void release_until(std::size_t end);
    void release_front();
    void run_front();

    LookAheadRules rules_;
    MotionSink sink_;
    std::vector<Place> places_;        // a ring; its size is a power of two
    std::vector<MotionEvent> events_;  // the blocks, likewise
    std::size_t mask_;
    std::size_t begin_ = 0, end_ = 0;  // counted on, taken modulo the ring's size
    std::deque<std::pair<std::size_t, MotionEvent>> between_;  // to be told before block …
    bool running_ = false;                                     // the oldest block runs …
    double running_exit_ = 0;                                  // … and will leave so, squared
    std::size_t next_look_;  // queue length at which to look for settled blocks
};

}  // namespace bead
