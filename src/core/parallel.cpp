#include "core/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace bead {

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    tbb::task_arena arena(threads > 0 ? threads : static_cast<int>(tbb::task_arena::automatic));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body); });
}

}  // namespace bead
