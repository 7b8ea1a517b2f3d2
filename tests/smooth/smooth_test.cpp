#include "smooth/smooth.h"

#include <gtest/gtest.h>

using namespace bead;

TEST(Smooth, LeavesALayerWithoutAnythingAsItIs) { EXPECT_TRUE(smoothed({}).path.empty()); }
