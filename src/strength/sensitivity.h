// Where more stiffness makes a structure stronger. The failure indices of all variants are taken as
// one number, their p-norm, which leans on the highest; the adjoint of it (one more solution of the
// same equations per variant) tells what any force, and so any bar, would change.
//
//     const std::vector<PixelVector> adjoint = sensitivity(rig, tested);
//     // A bar of k N/mm from a to b along the unit vector t lowers the norm, to first order, by
//     the
//     // sum over variants of k (t·(λb − λa)) (t·(ub − ua)), λ being the adjoint.
//
// Bendsøe and Sigmund, Topology Optimization (2003), 1.2 (adjoints); Duysinx and Sigmund 1998
// (p-norm of stress).
#pragma once
#include <span>
#include <vector>

#include "strength/test_rig.h"

namespace bead {

// `tested`: one per variant of the rig. At least the highest index.
double failure_norm(std::span<const Tested> tested);

// Per variant, of the nodes, in index per N.
std::vector<PixelVector> sensitivity(const TestRig& rig, std::span<const Tested> tested);

}  // namespace bead
