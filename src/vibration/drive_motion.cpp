#include "vibration/drive_motion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bead {
namespace {

constexpr double mm = 1e-3;           // m
constexpr double nut_grid = 0.02;     // m between two stages of a screw whose stiffness changes
constexpr double nearest_nut = 0.05;  // of the screw's length, to either end
constexpr std::size_t motor_place = 4, table = 3;

using Complex = std::complex<double>;

// The rows of what is seen: place and acceleration of the table, angle and speed of the motor.
std::array<std::vector<double>, 4> seen_rows(const ClosedLoop& loop) {
    constexpr std::size_t n = 2 * drive_order;
    std::array<std::vector<double>, 4> rows;
    for (auto& row : rows) row.assign(n, 0);
    rows[0][table] = 1;
    const auto acceleration = loop.matrix.begin() + std::ptrdiff_t((drive_order + table) * n);
    std::copy_n(acceleration, n, rows[1].begin());
    rows[2][motor_place] = 1;
    rows[3][drive_order + motor_place] = 1;
    return rows;
}

}  // namespace

DriveMotion::DriveMotion(const DriveAxis& axis, double step, double start)
    : axis_(axis), step_(step), start_(start) {
    const Screw& screw = axis.screw;
    const Drive d = drive(axis);
    kp_ = d.kp;
    kd_ = d.kd;
    inertia_ = d.inertia;
    ratio_ = d.ratio;
    if (screw.coupling_at) {
        first_nut_ = nearest_nut * screw.length;
        const double last = (1 - nearest_nut) * screw.length;
        for (double nut = first_nut_; nut <= last; nut += nut_grid)
            stages_.push_back(stage_at(nut));
    } else {
        stages_.push_back(stage_at(screw.nut_distance));
    }
    if (screw.coupling_at) follow(start);
}

// A command straight between samples: over a step z(t + h) = E z + (F - G) u(t) + G u(t + h) with
// E = e^{λh}, F = (E - 1)/λ, G = (F - h)/(λh). With w = z - G u the next input is not needed ahead:
// w(t + h) = E w + (F - G + E G) u(t), and G u(t) is shown at once.
DriveMotion::Stage DriveMotion::stage_at(double nut_distance) const {
    const ClosedLoop loop = closed_loop(drive(axis_, nut_distance));
    const auto rows = seen_rows(loop);
    Stage stage;
    stage.modes = linear_modes(loop.matrix, 2 * drive_order);
    for (std::size_t m = 0; m < stage.modes.size(); ++m) {
        const LinearMode& mode = stage.modes[m];
        const Complex in = std::inner_product(loop.input.begin(), loop.input.end(),
                                              mode.weights.begin(), Complex{});
        const Complex l = mode.eigenvalue, e = std::exp(l * step_), f = (e - 1.0) / l;
        const Complex g = (f - step_) / (l * step_);
        const Complex drive_by = in * (f - g + e * g);
        stage.decay_re[m] = e.real();
        stage.decay_im[m] = e.imag();
        stage.drive_re[m] = drive_by.real();
        stage.drive_im[m] = drive_by.imag();
        stage.lead.push_back(in * g);
        for (std::size_t k = 0; k < quantities; ++k) {
            const Complex seen =
                std::inner_product(rows[k].begin(), rows[k].end(), mode.shape.begin(), Complex{});
            stage.seen_re[k][m] = seen.real();
            stage.seen_im[k][m] = -seen.imag();
            stage.direct[k] += (seen * in * g).real();
        }
    }
    return stage;
}

// Takes the stage that is nearest to the place (mm); the state of the axis stays what it is.
void DriveMotion::follow(double place) {
    const double nut = std::abs(place * mm - *axis_.screw.coupling_at);
    const double index = std::clamp((nut - first_nut_) / nut_grid, 0.0, double(stages_.size() - 1));
    if (std::abs(index - double(now_)) < 0.6) return;
    const Stage& from = stages_[now_];
    std::array<double, 2 * drive_order> state{};
    for (std::size_t k = 0; k < from.modes.size(); ++k) {
        const Complex z = Complex(re_[k], im_[k]) + last_input_ * from.lead[k];
        for (std::size_t i = 0; i < state.size(); ++i)
            state[i] += (from.modes[k].shape[i] * z).real();
    }
    now_ = std::size_t(std::lround(index));
    const Stage& to = stages_[now_];
    re_ = im_ = {};
    for (std::size_t k = 0; k < to.modes.size(); ++k) {
        const Complex z =
            std::inner_product(state.begin(), state.end(), to.modes[k].weights.begin(), Complex{}) -
            last_input_ * to.lead[k];
        re_[k] = z.real();
        im_[k] = z.imag();
    }
}

template <std::size_t lanes>
auto DriveMotion::pass(double input) -> std::array<double, quantities> {
    const Stage& stage = stages_[now_];
    std::array<std::array<double, lanes>, quantities> shown;
    for (std::size_t k = 0; k < quantities; ++k)
        for (std::size_t m = 0; m < lanes; ++m)
            shown[k][m] = stage.seen_re[k][m] * re_[m] + stage.seen_im[k][m] * im_[m];
    for (std::size_t m = 0; m < lanes; ++m) {
        const double re = re_[m], im = im_[m];
        re_[m] = stage.decay_re[m] * re - stage.decay_im[m] * im + stage.drive_re[m] * input;
        im_[m] = stage.decay_im[m] * re + stage.decay_re[m] * im + stage.drive_im[m] * input;
    }
    std::array<double, quantities> seen{};
    for (std::size_t k = 0; k < quantities; ++k) {
        seen[k] = stage.direct[k] * input;
        for (std::size_t m = 0; m < lanes; ++m) seen[k] += shown[k][m];
    }
    return seen;
}

DriveSample DriveMotion::move(double before, double command, double after) {
    const double angle = (command - start_) * mm / ratio_;
    const double speed = (after - before) * mm / (2 * step_ * ratio_);
    const double change = (after - 2 * command + before) * mm / (step_ * step_ * ratio_);
    const double input = kp_ * angle + kd_ * speed + inertia_ * change;
    const bool all_swing = stages_[now_].modes.size() <= drive_order;
    const auto seen = all_swing ? pass<drive_order>(input) : pass<most_lanes>(input);
    last_input_ = input;
    if (axis_.screw.coupling_at) follow(command);
    return {start_ + seen[0] / mm, seen[1] / mm, input - kp_ * seen[2] - kd_ * seen[3], seen[3]};
}

}  // namespace bead
