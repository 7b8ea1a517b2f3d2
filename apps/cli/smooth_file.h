// A G-code file smoothed layer by layer: what is motion of a layer goes through smoothed()
// (smooth/smooth.h), all else stays as it was and where it was. Memory is bounded by a few layers.
#pragma once
#include <functional>
#include <map>
#include <ostream>
#include <string>

#include "core/progress.h"
#include "firmware_time.h"
#include "gcode/reader.h"
#include "gcode/text_source.h"
#include "smooth/smooth.h"
#include "vibration/time_law.h"

namespace bead::cli {

struct SmoothFileOptions {
    SmoothOptions smooth;
    ReadOptions read;
    double filament = 1.75;    // mm, diameter
    double arc_tolerance = 0;  // mm; above 0: arcs as G2 and G3
    TimeLaw law;               // by which layers are timed
    FirmwareClock firmware;    // by which no layer may take longer than before
    int threads = 0;
};

// A layer before and after, by the same account: from where the layer before it ended.
struct LayerPair {
    int index = 0;           // from 0
    double z = 0;            // mm
    std::int64_t bytes = 0;  // of the file, up to the layer's end
    bool smoothed = false;
    Toolpath before, after;
    double before_time = 0, after_time = 0;  // s, by the law
};
// Several layers, whose order is that of the file.
using LayerPairs = std::function<void(const std::vector<LayerPair>&)>;

struct SmoothedFile {
    GcodeReport file;
    int layers = 0, smoothed = 0;
    int chains = 0, links = 0, arcs = 0, blends = 0, kept = 0;
    std::map<std::string, int> left;                 // reason -> layers left as they were
    double filament_before = 0, filament_after = 0;  // mm, in beads of the layers
};

SmoothedFile smooth_file(const TextSource& source, std::ostream& out,
                         const SmoothFileOptions& options, const LayerPairs& watch);

}  // namespace bead::cli
