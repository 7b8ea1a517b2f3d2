#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "core/error.h"

namespace bead {
namespace {

TEST(ParallelFor, visits_every_item_once) {
    for (const int threads : {0, 1, 2, 7}) {
        std::vector<int> visits(1000, 0);
        parallel_for(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
        EXPECT_EQ(visits, std::vector<int>(1000, 1));
    }
}

TEST(ParallelFor, of_nothing_does_nothing) {
    parallel_for(0, 0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, rethrows_what_a_body_throws) {
    for (const int threads : {1, 4})
        EXPECT_THROW(parallel_for(100, threads,
                                  [](std::size_t i) {
                                      if (i == 57) throw Error("layer 57: broken");
                                  }),
                     Error);
}

TEST(ParallelFor, uses_no_more_threads_than_it_may) {
    for (const int threads : {1, 2}) {
        std::mutex guard;
        std::set<std::thread::id> seen;
        parallel_for(500, threads, [&](std::size_t) {
            const std::scoped_lock lock(guard);
            seen.insert(std::this_thread::get_id());
        });
        EXPECT_LE(seen.size(), static_cast<std::size_t>(threads));
    }
}

}  // namespace
}  // namespace bead
