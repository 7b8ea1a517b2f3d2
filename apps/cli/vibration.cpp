// beadwork vibration: how a print shakes the machine, and how far the nozzle strays, by time law.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "gcode_file.h"
#include "job/resonance_file.h"
#include "vibration/print_motion.h"
#include "vibration/response_meter.h"
#include "vibration_report.h"

namespace bead::cli {
namespace {

constexpr double time_step = 0.001;  // s, of the simulation

struct VibrationCall {
    std::string file;
    std::vector<std::string> laws, resonances;
    std::string shaper = "none";
    double tuning = 1, jerk = TimeLaw{}.jerk;
    bool feed_forward = false;
    std::string csv, picture, over_time, samples;
    MachineOptions machine;
    OutputOptions output;
};

std::vector<std::string> law_names() {
    std::vector<std::string> names{"trapezoid", "jerk-limited"};
    for (const NamedLaw& row : named_laws) names.emplace_back(row.name);
    return names;
}

// What the printer's limits say, under the law's profile; "K1Mf" brings shaper and feed-forward.
TimeLaw law_of(const std::string& name, const VibrationCall& options, const Limits& limits) {
    TimeLaw law;
    const auto named = std::ranges::find(named_laws, name, &NamedLaw::name);
    if (named != named_laws.end()) law = named->law;
    if (name == "jerk-limited") law.profile = SpeedProfile::jerk_limited;
    if (options.shaper != "none")
        law.shaper =
            ShaperKind(std::ranges::find(shaper_names, options.shaper) - shaper_names.begin());
    law.feed_forward = law.feed_forward || options.feed_forward;
    law.tuning = options.tuning;
    law.jerk = options.jerk;
    law.acceleration = std::max(limits.acceleration, limits.travel_acceleration);
    law.square_corner_velocity = limits.square_corner_velocity;
    return law;
}

std::string label(const std::string& name, const TimeLaw& law, const VibrationCall& options) {
    std::string text = name;
    if (options.shaper != "none") text += "+" + std::string(shaper_names[std::size_t(*law.shaper)]);
    if (options.feed_forward) text += "+f";
    return text;
}

// One law's answer to the print that goes by.
class Listening {
  public:
    Listening(const ShakenMachine& machine, double filament, const TimeLaw& law,
              const std::string& samples, bool over_time)
        : meter_(machine, law, time_step),
          motion_(filament, planned_by(law),
                  [this](const MotionSegment& segment) { meter_.add(segment); }) {
        if (!samples.empty()) begin_samples(samples);
        if (over_time || file_)
            meter_.listen([this](const ResponseSample& sample) { hear(sample); });
    }
    void add(const MotionEvent& event) { motion_.add(event); }
    [[nodiscard]] std::vector<RmsWindow> over_time() const { return over_time_.windows(); }
    Response finish() {
        motion_.finish();
        Response response = meter_.finish();
        if (file_) file_->keep();
        return response;
    }

  private:
    static std::optional<TimeLaw> planned_by(const TimeLaw& law) {
        return law.profile == SpeedProfile::trapezoid ? std::nullopt : std::optional(law);
    }
    void begin_samples(const std::string& place) {
        file_.emplace(place);
        file_->stream() << "time_s,x_mm,y_mm,nozzle_x_mm,nozzle_y_mm,ax_mm_s2,ay_mm_s2,prints\n";
    }
    void hear(const ResponseSample& s) {
        over_time_.add(s.acceleration);
        if (!file_) return;
        file_->stream() << fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.1f},{:.1f},{}\n",
                                       s.time, s.asked.x, s.asked.y, s.nozzle.x, s.nozzle.y,
                                       s.acceleration.x, s.acceleration.y, int(s.prints));
    }

    RmsOverTime over_time_{time_step, 400};
    std::optional<OutputFile> file_;
    ResponseMeter meter_;
    PrintMotion motion_;
};

VibrationModel model_of(const VibrationCall& options, const Printer& printer) {
    VibrationModel model = printer.vibration;
    for (std::size_t k = 0; k < 2 && !options.resonances.empty(); ++k) {
        const std::string& file = options.resonances[std::min(k, options.resonances.size() - 1)];
        model.axes[k] = with_mode(model.axes[k], resonance_of(file, k));
    }
    return model;
}

void check_extruded(const Response& response, const std::string& file) {
    if (response.volume > 0) return;
    throw Error(file +
                ": no move in it lays down filament, so there is no print to look at; is it "
                "the sliced file?");
}

VibrationResult heard(const VibrationCall& options, const Console& console) {
    const Machine machine = machine_choice(options.machine, slicer_notes(options.file)).machine;
    const Printer& printer = machine.printer;
    const ShakenMachine shaken{model_of(options, printer), machine.material};
    const double filament = pi / 4 * printer.filament * printer.filament;
    VibrationResult result{{first_mode(shaken.model.axes[0]), first_mode(shaken.model.axes[1])},
                           {}};
    std::vector<std::unique_ptr<Listening>> all;
    for (const std::string& name : options.laws) {
        const TimeLaw law = law_of(name, options, printer.limits);
        result.laws.push_back({label(name, law, options), law, {}, {}});
        all.push_back(std::make_unique<Listening>(
            shaken, filament, law, all.empty() ? options.samples : "", !options.over_time.empty()));
    }
    judge_file(options.file, options.machine, console, Judging::motion,
               [&](const MotionEvent& event) {
                   for (const auto& listening : all) listening->add(event);
               });
    for (std::size_t i = 0; i < all.size(); ++i) {
        result.laws[i].response = all[i]->finish();
        result.laws[i].over_time = all[i]->over_time();
        check_extruded(result.laws[i].response, options.file);
    }
    return result;
}

void write(const std::string& place, const std::string& text) {
    OutputFile file(place);
    file.stream() << text;
    file.keep();
}

void vibration(const VibrationCall& options) {
    const Console console = console_of(options.output);
    const VibrationResult result = heard(options, console);
    print_vibration(console, result);
    if (!options.csv.empty()) {
        OutputFile file(options.csv);
        write_spectra(file.stream(), result);
        file.keep();
    }
    const std::string title = std::filesystem::path(options.file).filename().string();
    if (!options.picture.empty()) write(options.picture, spectra_picture(result, title));
    if (!options.over_time.empty()) write(options.over_time, over_time_picture(result, title));
    if (options.output.json.empty()) return;
    Json json = result_head("vibration", {options.file});
    json.update(vibration_json(result));
    write_result(options.output.json, json);
}

void declare_vibration(CLI::App& command, VibrationCall& options) {
    command.add_option("FILE", options.file, "G-code of any slicer, also gzipped")->required();
    command
        .add_option("--law", options.laws,
                    "trapezoid: as the firmware moves (default); jerk-limited; or K0, K1, K1f, K2, "
                    "K2f, K1M, K1Mf; several are set side by side")
        ->delimiter(',')
        ->check(CLI::IsMember(law_names()));
    std::vector<std::string> shapers{"none"};
    shapers.insert(shapers.end(), shaper_names.begin(), shaper_names.end());
    command.add_option("--shaper", options.shaper, "none, zv, mzv, zvd, ei, 2hump_ei, 3hump_ei")
        ->check(CLI::IsMember(shapers));
    command.add_flag("--feed-forward", options.feed_forward, "lead by what the machine lags");
    command
        .add_option("--tuning", options.tuning,
                    "frequencies that shaper and feed-forward believe in / the machine's")
        ->check(CLI::Range(0.2, 5.0));
    command.add_option("--jerk", options.jerk, "mm/s³ along the path, of jerk-limited laws")
        ->check(CLI::Range(100.0, 1e8));
    command
        .add_option("--resonances", options.resonances,
                    "Klipper's .csv of TEST_RESONANCES: one, or X's and Y's")
        ->expected(1, 2)
        ->type_name("FILE.csv");
    command.add_option("--csv", options.csv, "write the spectra")->type_name("OUT.csv");
    command.add_option("--picture", options.picture, "draw the spectra")->type_name("OUT.svg");
    command.add_option("--over-time", options.over_time, "draw how much it shakes along the print")
        ->type_name("OUT.svg");
    command.add_option("--samples", options.samples, "write the first law's motion, a row per ms")
        ->type_name("OUT.csv");
}

}  // namespace

void add_vibration(CLI::App& app) {
    const auto options = std::make_shared<VibrationCall>();
    CLI::App& command =
        *app.add_subcommand("vibration", "how a print shakes the machine, by time law");
    command.footer(
        "Example: what would input shaping and a jerk limit do for this print on a large machine?\n"
        "  beadwork vibration part.gcode --printer ldam-1000 --law K0,K2,K1Mf --picture psd.svg\n"
        "  beadwork vibration part.gcode --set vibration.frequency_hz=[47.5,38.2] --shaper mzv");
    declare_vibration(command, *options);
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] {
        if (options->laws.empty()) options->laws = {"trapezoid"};
        vibration(*options);
    });
}

}  // namespace bead::cli
