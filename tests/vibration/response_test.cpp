// The response as a whole: closed forms, and the effects that the method rests on.
#include <gtest/gtest.h>

#include <cmath>

#include "vibration/assess.h"
#include "vibration/command.h"
#include "vibration/piece.h"
#include "vibration/response_meter.h"
#include "vibration/timed.h"

namespace bead {
namespace {

Path circle(double radius, std::size_t chords, double speed, double turns = 1) {
    Path path{.role = Role::outer_wall, .bead = {0.4, 0.2}, .speed = speed, .points = {}};
    const auto count = std::size_t(turns * double(chords));
    for (std::size_t i = 0; i <= count; ++i) {
        const Vec2 at = radius * unit(2 * pi * double(i) / double(chords));
        path.points.push_back({at.x, at.y, 0.2});
    }
    return path;
}

const ShakenMachine machine;

TimeLaw law_named(std::string_view name) {
    for (const NamedLaw& row : named_laws)
        if (row.name == name) return row.law;
    ADD_FAILURE() << name;
    return {};
}

// Mean distance of the nozzle from the circle's radius, both axes being alike, in mid motion.
double radius_error(const TimeLaw& law, const ShakenMachine& on) {
    ResponseMeter meter(on, law, 0.0005);
    double sum = 0;
    int count = 0;
    meter.listen([&](const ResponseSample& sample) {
        if (sample.time < 2 || sample.time > 6) return;
        sum += length(sample.nozzle) - 4;
        ++count;
    });
    const Toolpath path{circle(4, 2000, 50, 16)};
    timed(pieces_of(path, 120), law, [&](const MotionSegment& s) { meter.add(s); });
    const Response response = meter.finish();
    EXPECT_GT(response.time, 6);
    return sum / count;
}

// Radius errors of a circle of r = 4 mm at 50 mm/s on the example machine.
TEST(Response, FeedForwardClosesTheCircle) {
    TimeLaw law{.profile = SpeedProfile::jerk_limited, .acceleration = 2000};
    EXPECT_NEAR(radius_error(law, machine), 0.058, 0.002);
    law.feed_forward = true;
    EXPECT_NEAR(radius_error(law, machine), 0, 0.001);
    law.shaper = ShaperKind::mzv;
    EXPECT_NEAR(radius_error(law, machine), 0, 0.001);
    law.feed_forward = false;
    EXPECT_NEAR(radius_error(law, machine), -0.037, 0.002);
}

TEST(Response, TheLeadTurnsItsSignUnderMzv) {
    const auto lead = [&](std::size_t axis, std::string_view law) {
        return CommandFilter(machine.model.axes[axis], law_named(law), 0.0005).lead();
    };
    EXPECT_NEAR(lead(0, "K1f"), 1.305e-4, 0.01e-4);
    EXPECT_NEAR(lead(1, "K1f"), 5.25e-5, 0.05e-5);
    EXPECT_NEAR(lead(0, "K1Mf"), -8.3e-5, 0.2e-5);
    EXPECT_NEAR(lead(1, "K1Mf"), -3.6e-5, 0.1e-5);
}

// A sine is led by what a bell as wide as the mode is slow lets through, and never by more than the
// law's acceleration asks for.
TEST(Response, LeadsThroughABell) {
    const double step = 0.0005;
    for (const std::size_t axis : {0U, 1U})
        for (const double hertz : {3.0, 8.0, 14.0, 30.0}) {
            const DriveAxis& drive = machine.model.axes[axis];
            const CommandFilter filter(drive, law_named("K1f"), step);
            const double omega = 2 * pi * hertz;
            const double width = 0.5 * omega / (2 * pi * first_mode(drive).frequency);
            const double led = filter.lead() * omega * omega;
            for (const double size : {0.001, 100.0}) {
                std::vector<double> samples, command;
                for (int i = 0; i < 4000; ++i) samples.push_back(size * std::cos(omega * i * step));
                filter.filter(samples, command);
                double most = 0;
                for (std::size_t i = 0; i < command.size(); ++i)
                    most = std::max(most, std::abs(command[i] - samples[i + filter.margin()]));
                const double expected = led * std::exp(-width * width / 2) * size;
                EXPECT_NEAR(most / std::min(expected, filter.lead() * 1000), 1, 0.02);
            }
        }
}

// Chords force the machine at v/ℓ: worst near a mode, quiet once they are shorter than v/2f.
TEST(Response, ChordsResonate) {
    const double speed = 50, radius = 17;
    double worst = 0, worst_frequency = 0;
    for (const std::size_t chords : {24U, 32U, 40U, 48U, 56U, 64U, 75U, 90U, 120U, 160U, 240U}) {
        TimeLaw law;
        law.square_corner_velocity = 50;  // chords are not braked for
        const Response r = assess({circle(radius, chords, speed, 4)}, machine, law);
        const double frequency = speed / (2 * pi * radius / double(chords));
        if (r.rms_acceleration > worst) {
            worst = r.rms_acceleration;
            worst_frequency = frequency;
        }
        if (frequency > 2 * 22) {
            EXPECT_LT(r.rms_acceleration, 0.4 * worst) << chords;
        }
    }
    EXPECT_GT(worst_frequency, 11);
    EXPECT_LT(worst_frequency, 25);
}

TEST(Response, HardlyDependsOnTheStep) {
    const Toolpath path{circle(17, 75, 50, 4), circle(4, 24, 50, 4)};
    for (const NamedLaw& row : named_laws) {
        const Response fine = assess(path, machine, row.law, {.step = 0.00025});
        for (const double step : {0.0005, 0.001}) {
            const Response r = assess(path, machine, row.law, {.step = step});
            EXPECT_NEAR(r.rms_acceleration, fine.rms_acceleration, 0.02 * fine.rms_acceleration);
            EXPECT_NEAR(r.rms_5_40hz, fine.rms_5_40hz, 0.02 * fine.rms_5_40hz);
            EXPECT_NEAR(r.contour.mean, fine.contour.mean, 0.02 * fine.contour.mean + 1e-4)
                << row.name << step;
        }
    }
}

TEST(Response, OneKilowattHourWeighsWhatTheGridSays) {
    ShakenMachine still;
    still.model.energy_co2 = 0.5;
    still.model.material_co2 = 0;
    still.model.base_power = 3.6e6;
    const Response r = assess({circle(10, 100, 50)}, still, {});
    EXPECT_NEAR(r.co2, 500 * total(r.energy) / 3.6e6, 1e-9);
    still.model.energy_co2 = 0;
    still.model.material_co2 = 3;
    const Response m = assess({circle(10, 100, 50)}, still, {});
    EXPECT_NEAR(m.co2, 3 * m.material, 1e-12);
    EXPECT_NEAR(m.volume, 2 * 100 * 10 * std::sin(pi / 100) * section(Bead{0.4, 0.2}), 1e-9);
}

}  // namespace
}  // namespace bead
