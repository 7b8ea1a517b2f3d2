#include "energy/feature_sums.h"

namespace bead {

Features total(const PerRole<Features>& by_role) {
    Features sum;
    for (const Features& features : by_role) sum += features;
    return sum;
}

void FeatureSums::add(const MotionEvent& event) {
    if (const Block* block = std::get_if<Block>(&event)) {
        layers_.back().by_role[static_cast<std::size_t>(block->role)] += features_of(*block);
        layers_.back().duration += duration(*block);
    } else if (const LayerStart* layer = std::get_if<LayerStart>(&event)) {
        layers_.push_back({.z = layer->z});
    }
}

PerRole<Features> FeatureSums::by_role() const {
    PerRole<Features> sum{};
    for (const LayerFeatures& layer : layers_)
        for (std::size_t role = 0; role < sum.size(); ++role) sum[role] += layer.by_role[role];
    return sum;
}

}  // namespace bead
