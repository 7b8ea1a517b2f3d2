// How one axis moves when it is told a sampled command: the exact answer of the closed loop to a
// command that is straight between samples, mode by mode, so a step of any length is exact and
// costs about six complex products.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "vibration/drive.h"

namespace bead {

struct DriveSample {
    double table = 0;         // mm, the nozzle's place
    double acceleration = 0;  // mm/s², of the table
    double torque = 0;        // N m, of the motor, without friction
    double turning = 0;       // rad/s
};

class DriveMotion {
  public:
    // At rest at `start` (mm), stepping by `step` s.
    DriveMotion(const DriveAxis& axis, double step, double start);
    // `command` (mm): the value at this sample, with one sample before and one after for its
    // derivatives. Called for one sample after the other.
    DriveSample move(double before, double command, double after);

  private:
    // One lane per mode: z' = λz + g·u over a step, and what it shows of the axis. Real and
    // imaginary parts lie apart and lanes side by side, for speed; 6 lanes if every mode swings.
    static constexpr std::size_t most_lanes = 2 * drive_order, quantities = 4;
    using Lanes = std::array<double, most_lanes>;
    struct Stage {  // with the nut at one place
        Lanes decay_re{}, decay_im{}, drive_re{}, drive_im{};
        std::array<Lanes, quantities> seen_re{}, seen_im{};
        std::array<double, quantities> direct{};  // what the command shows at once
        std::vector<LinearMode> modes;
        std::vector<std::complex<double>> lead;  // of a unit command, per mode
    };
    [[nodiscard]] Stage stage_at(double nut_distance) const;
    void follow(double place);
    template <std::size_t lanes>
    auto pass(double input) -> std::array<double, quantities>;

    DriveAxis axis_;
    double step_, start_;
    double kp_ = 0, kd_ = 0, inertia_ = 0, ratio_ = 0;
    std::vector<Stage> stages_;
    std::size_t now_ = 0;
    double first_nut_ = 0;  // m, the nut's distance in the first stage
    Lanes re_{}, im_{};
    double last_input_ = 0;
};

}  // namespace bead
