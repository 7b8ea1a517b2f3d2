// A print before and after smoothing, row by row under one time law: for people, for programs, as a
// picture of a layer, as setpoints. Lengths, points and time are of all layers; what is dear to
// find (shaking, coverage) is of a sample of layers spread evenly over the file unless all are
// asked for, and the result says which.
#pragma once
#include <memory>
#include <string>

#include "console.h"
#include "json_result.h"
#include "smooth_file.h"
#include "vibration/assess.h"

namespace bead::cli {

struct SmoothReportOptions {
    ShakenMachine machine;
    TimeLaw law;
    std::string law_name;
    std::array<double, 2> modes{};  // Hz
    std::int64_t bytes = 0;         // of the file, for an even sample
    int threads = 0;
    bool all_layers = false;
    std::string picture;            // file; empty: none
    std::optional<int> pictured{};  // layer, from 1; else one in the middle
    std::string setpoints;          // file; empty: none
};

class SmoothReport {
  public:
    explicit SmoothReport(const SmoothReportOptions& options);
    ~SmoothReport();
    SmoothReport(const SmoothReport&) = delete;
    SmoothReport& operator=(const SmoothReport&) = delete;

    void add(const std::vector<LayerPair>& layers);
    // Writes picture and setpoints.
    void finish(const SmoothedFile& file);
    void print(const Console& console, const std::string& name) const;
    [[nodiscard]] Json json() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bead::cli
