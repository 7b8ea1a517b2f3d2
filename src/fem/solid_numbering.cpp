#include "fem/solid_numbering.h"

namespace bead {

SolidNumbering solid_numbering(const PixelModel& model) {
    SolidNumbering numbering;
    numbering.point_of.assign(model.grid.nodes(), -1);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        numbering.pixels.push_back(pixel);
        for (const std::size_t node : model.grid.corners(pixel)) numbering.point_of[node] = 0;
    }
    for (std::size_t node = 0; node < numbering.point_of.size(); ++node) {
        if (numbering.point_of[node] < 0) continue;
        numbering.point_of[node] = int(numbering.nodes.size());
        numbering.nodes.push_back(node);
    }
    return numbering;
}

}  // namespace bead
