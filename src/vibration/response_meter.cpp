#include "vibration/response_meter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/expects.h"
#include "vibration/command.h"
#include "vibration/contour.h"
#include "vibration/drive_motion.h"
#include "vibration/drive_power.h"
#include "vibration/shaking.h"

namespace bead {
namespace {

constexpr double ring_out = 0.3;        // s
constexpr double contour_rate = 500;    // Hz, at which the contour error is taken
constexpr double nominal_slack = 0.05;  // of the speed asked for
constexpr std::size_t chunk = 8192;     // samples that are answered at once

}  // namespace

struct ResponseMeter::State {
    // Of the path, at one instant.
    struct PathSample {
        double way = 0;
        bool prints = false;
    };

    ShakenMachine machine;
    double step;
    std::array<CommandFilter, 2> filters;
    std::size_t margin;
    std::size_t contour_every;
    std::function<void(const ResponseSample&)> listener{};

    // Samples that are not answered yet, and `margin` before them.
    std::array<std::vector<double>, 2> places{};
    std::vector<PathSample> path{};
    std::array<std::vector<double>, 2> commands{};
    std::optional<std::array<DriveMotion, 2>> drives{};

    double time = 0;  // s, of all segments
    double way = 0;   // mm
    double next = 0;  // s, of the next sample
    std::size_t answered = 0;
    Vec2 last{};
    double printing = 0, off = 0, volume = 0;

    Contour contour{};
    Extremes deviation{}, error{};
    Percentiles errors{};
    Shaking shaking;
    DriveEnergy energy{};

    State(const ShakenMachine& of, const TimeLaw& law, double every)
        : machine(of),
          step(every),
          filters{CommandFilter(of.model.axes[0], law, every),
                  CommandFilter(of.model.axes[1], law, every)},
          margin(1 + std::max(filters[0].margin(), filters[1].margin())),
          contour_every(
              std::max<std::size_t>(1, std::size_t(std::lround(1 / (contour_rate * every))))),
          shaking(every) {}

    void add(const MotionSegment& segment) {
        if (!drives) begin(segment.from);
        if (segment.length > 0) {
            contour.add(segment.from + segment.length * segment.direction);
            volume += segment.flow * segment.length;
        }
        last = end(segment);
        sample(segment);
        time += segment.duration;
        way += segment.length;
        if (path.size() >= chunk + 2 * margin) answer();
    }

    void begin(Vec2 from) {
        const auto motion = [&](std::size_t axis, double place) {
            return DriveMotion(machine.model.axes[axis], step, place);
        };
        drives.emplace(std::array{motion(0, from.x), motion(1, from.y)});
        contour.add(from);
        for (std::size_t i = 0; i < margin; ++i) put(from, {0, false});
    }

    void put(Vec2 place, const PathSample& sample) {
        places[0].push_back(place.x);
        places[1].push_back(place.y);
        path.push_back(sample);
    }

    void sample(const MotionSegment& segment) {
        const double until = time + segment.duration;
        for (; next < until; next = step * double(path.size() - margin + answered)) {
            const double t = next - time;
            const double gone = std::clamp(bead::way(segment, t), 0.0, segment.length);
            const bool prints = segment.flow > 0;
            put(segment.from + gone * segment.direction, {way + gone, prints});
            if (!prints) continue;
            printing += step;
            const double speed = bead::speed(segment, t);
            if (std::abs(speed - segment.nominal) > nominal_slack * segment.nominal) off += step;
        }
    }

    // All samples that have their margin on either side.
    void answer() {
        for (std::size_t k = 0; k < 2; ++k) {
            const std::size_t more = margin - filters[k].margin() - 1;  // the other axis needs more
            const std::span<const double> all(places[k]);
            filters[k].filter(all.subspan(more, all.size() - 2 * more), commands[k]);
        }
        const std::size_t count = path.size() - 2 * margin;
        for (std::size_t i = 0; i < count; ++i) hear(i);
        answered += count;
        forget(count);
    }

    void hear(std::size_t i) {
        std::array<DriveSample, 2> moved;
        for (std::size_t k = 0; k < 2; ++k) {
            const double* const c = commands[k].data() + i;
            moved[k] = (*drives)[k].move(c[0], c[1], c[2]);
            add_work(energy, machine.model.axes[k], moved[k], step);
        }
        shaking.add({moved[0].acceleration, moved[1].acceleration});
        const std::size_t here = i + margin;
        const Vec2 asked{places[0][here], places[1][here]};
        const Vec2 nozzle{moved[0].table, moved[1].table};
        if (path[here].prints) judge(asked, nozzle, path[here].way, answered + i);
        if (listener)
            listener({step * double(answered + i),
                      asked,
                      nozzle,
                      {moved[0].acceleration, moved[1].acceleration},
                      path[here].prints});
    }

    void judge(Vec2 asked, Vec2 nozzle, double at, std::size_t index) {
        deviation.add(distance(asked, nozzle));
        if (index % contour_every != 0) return;
        const double off_path = contour.error(nozzle, at);
        error.add(off_path);
        errors.add(off_path);
    }

    void forget(std::size_t count) {
        const auto gone = [&](auto& list) {
            list.erase(list.begin(), list.begin() + std::ptrdiff_t(count));
        };
        gone(places[0]);
        gone(places[1]);
        gone(path);
    }
};

ResponseMeter::ResponseMeter(const ShakenMachine& machine, const TimeLaw& law, double step)
    : state_(std::make_unique<State>(machine, law, step)) {}
ResponseMeter::ResponseMeter(ResponseMeter&&) noexcept = default;
ResponseMeter::~ResponseMeter() = default;

void ResponseMeter::add(const MotionSegment& segment) { state_->add(segment); }

void ResponseMeter::listen(std::function<void(const ResponseSample&)> listener) {
    state_->listener = std::move(listener);
}

Response ResponseMeter::finish() {
    State& s = *state_;
    Response response;
    if (!s.drives) return response;
    response.time = s.time;
    const std::size_t rest = s.margin + std::size_t(std::lround(ring_out / s.step));
    for (std::size_t i = 0; i < rest; ++i) s.put(s.last, {s.way, false});
    s.answer();

    s.shaking.report(response);
    response.deviation = {s.deviation.least(), s.deviation.mean(), s.deviation.most()};
    response.contour = {s.error.mean(), std::min(s.error.most(), s.errors.at(0.99)),
                        s.error.most()};
    response.volume = s.volume;
    response.printing = s.printing;
    response.off_nominal = s.printing > 0 ? s.off / s.printing : 0;
    response.energy = s.energy;
    add_other_energy(response, s.machine);
    return response;
}

}  // namespace bead
