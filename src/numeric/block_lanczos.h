// The largest eigenvalues of a map A that is symmetric in the inner product of a positive definite
// B, as lowest_modes.h, but by blocks (Golub and Underwood 1977): several vectors go through A
// together, which costs a direct solver little more than one, the basis is made orthogonal block by
// block, and a good guess of all the modes (those of a structure that is much the same) can be the
// start. For problems whose B A x comes free with A x: A = -K^-1 G, B = K.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "numeric/lowest_modes.h"

namespace bead {

struct BlockImages {
    std::vector<double> a, ba;  // A x and B A x, column by column
};
// `columns` vectors, one after the other.
using BlockMap = std::function<BlockImages(std::span<const double> x, int columns)>;

struct BlockOptions {
    int count = 2;
    double tolerance = 1e-3;  // relative error of the eigenvalues, estimated
    double others = 1e-3;     // the same for all but the largest
    int most = 120;           // vectors
    int block = 4;
};

// `start`: one block of vectors, or more; A is applied to them first.
Modes block_modes(const BlockMap& map, std::span<const double> start, std::size_t size,
                  const BlockOptions& options);

}  // namespace bead
