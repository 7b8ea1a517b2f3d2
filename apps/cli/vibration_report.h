// What `beadwork vibration` found, under one or several time laws: for people, programs, plots.
#pragma once
#include <string>
#include <vector>

#include "console.h"
#include "json_result.h"
#include "vibration/drive.h"
#include "vibration/response.h"
#include "vibration/rms_over_time.h"
#include "vibration/time_law.h"

namespace bead::cli {

struct LawResponse {
    std::string name;
    TimeLaw law;
    Response response;
    std::vector<RmsWindow> over_time;
};

struct VibrationResult {
    std::array<DriveMode, 2> modes;  // of X and Y
    std::vector<LawResponse> laws;   // the first is the one asked about
};

void print_vibration(const Console& console, const VibrationResult& result);
Json vibration_json(const VibrationResult& result);
// freq_hz and a column of (mm/s²)²/Hz per law.
void write_spectra(std::ostream& out, const VibrationResult& result);
// The spectra up to 60 Hz, as SVG.
std::string spectra_picture(const VibrationResult& result, const std::string& title);
// The acceleration's root mean square over the time of the print, as SVG.
std::string over_time_picture(const VibrationResult& result, const std::string& title);

}  // namespace bead::cli
