// A layer's lanes as chains, in the phases that they are printed in: walls are one, every other
// role is one, in the order in which the layer has them.
#pragma once
#include "smooth/chain.h"
#include "smooth/smooth.h"

namespace bead {

struct LayerChains {
    std::vector<Chain> chains;
    std::vector<int> phases;  // of the chains, rising
    int links = 0, arcs = 0, kept = 0;
};

LayerChains layer_chains(const std::vector<Lane>& lanes, const SmoothOptions& options);

}  // namespace bead
