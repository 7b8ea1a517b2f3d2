// The published model's features by layer and role, for any set of coefficients.
#pragma once
#include <vector>

#include "energy/published.h"

namespace bead {

struct LayerFeatures {
    double z = 0;         // mm, top of the layer
    double duration = 0;  // s, dwells not included
    PerRole<Features> by_role{};
};

Features total(const PerRole<Features>& by_role);

class FeatureSums {
  public:
    void add(const MotionEvent& event);
    // The first is what comes before the first layer.
    [[nodiscard]] const std::vector<LayerFeatures>& layers() const { return layers_; }
    [[nodiscard]] PerRole<Features> by_role() const;

  private:
    std::vector<LayerFeatures> layers_{1};
};

}  // namespace bead
