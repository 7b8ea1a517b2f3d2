// Independent items on several threads. The body must write only to its own item's place, so that
// the result is the same bytes for any number of threads.
//
//     std::vector<Region> regions(count);
//     parallel_for(count, threads, [&](std::size_t i) { regions[i] = region_at(heights[i]); });
#pragma once
#include <cstddef>
#include <functional>

namespace bead {

// Calls body(0) … body(count - 1), on at most `threads` threads; 0 means as many as there are
// cores. An exception in a body ends the loop and is rethrown here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace bead
