#include "vibration/drive.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace bead {
namespace {

using Coordinates = std::array<double, drive_order>;

Coordinates operator*(const DriveMatrix& matrix, const Coordinates& x) {
    Coordinates y{};
    for (std::size_t i = 0; i < drive_order; ++i)
        for (std::size_t j = 0; j < drive_order; ++j) y[i] += matrix[i][j] * x[j];
    return y;
}

double dot(const Coordinates& a, const Coordinates& b) {
    double sum = 0;
    for (std::size_t i = 0; i < drive_order; ++i) sum += a[i] * b[i];
    return sum;
}

std::vector<double> as_rows(const DriveMatrix& matrix) {
    std::vector<double> rows;
    for (const auto& row : matrix) rows.insert(rows.end(), row.begin(), row.end());
    return rows;
}

const VibrationModel model;

TEST(Drive, MovesFreelyInOneWayOnly) {
    for (const DriveAxis& axis : model.axes) {
        const Drive d = drive(axis);
        const Coordinates rigid{0, 0, d.ratio, d.ratio, 1, 1};
        for (const double force : d.stiffness* rigid) EXPECT_NEAR(force, 0, 1e-9);
        int still = 0;
        for (const LinearMode& mode : linear_modes(as_rows(d.stiffness), drive_order)) {
            EXPECT_GT(mode.eigenvalue.real(), -1e-6);
            EXPECT_EQ(mode.eigenvalue.imag(), 0);
            still += std::abs(mode.eigenvalue) < 1e-6;
        }
        EXPECT_EQ(still, 1);
        for (std::size_t i = 0; i < drive_order; ++i)
            for (std::size_t j = 0; j < drive_order; ++j)
                EXPECT_EQ(d.stiffness[i][j], d.stiffness[j][i]);
    }
}

// The free motion of undamped masses, as the sum of its modes, keeps its energy.
TEST(Drive, WithoutDampingKeepsItsEnergy) {
    Drive d = drive(model.axes[0]);
    d.damping = {};
    d.kd = d.kp = 0;
    // The free drift has a double eigenvalue of 0: hold the motor by a weak spring.
    d.stiffness[4][4] += 1;
    const ClosedLoop loop = closed_loop(d);
    const auto modes = linear_modes(loop.matrix, 2 * drive_order);
    std::vector<double> x(2 * drive_order);
    for (std::size_t i = 0; i < drive_order; ++i) x[i] = 1e-4 * double(i + 1);
    const auto energy = [&](const std::vector<double>& state) {
        Coordinates q{}, v{};
        for (std::size_t i = 0; i < drive_order; ++i) {
            q[i] = state[i];
            v[i] = state[drive_order + i];
        }
        double sum = dot(q, d.stiffness * q) / 2;
        for (std::size_t i = 0; i < drive_order; ++i) sum += d.mass[i] * v[i] * v[i] / 2;
        return sum;
    };
    const double before = energy(x);
    for (const double t : {0.001, 0.01, 0.1234, 1.0, 10.0}) {
        std::vector<double> later(x.size());
        for (const LinearMode& mode : modes) {
            std::complex<double> z;
            for (std::size_t i = 0; i < x.size(); ++i) z += mode.weights[i] * x[i];
            z *= std::exp(mode.eigenvalue * t);
            for (std::size_t i = 0; i < x.size(); ++i) later[i] += (mode.shape[i] * z).real();
        }
        EXPECT_NEAR(energy(later), before, 1e-9 * before * (1 + 100 * t)) << t;
    }
}

// A force on the table, the motor held, bends all springs on its way to the ground.
TEST(Drive, YieldsToAForceAsItsSpringsInSeries) {
    const DriveAxis axis = model.axes[0];
    const Drive d = drive(axis);
    ClosedLoop loop = closed_loop(d);
    loop.input.assign(2 * drive_order, 0);
    loop.input[drive_order + 3] = 1 / d.mass[3];
    const auto modes = linear_modes(loop.matrix, 2 * drive_order);
    const double yield = steady_state(modes, loop.input, 0)[3].real();

    const double pi = std::numbers::pi;
    const double screw = pi * 1e-4 * 206e9 / 0.55, axial = 1 / (1 / 1.2e8 + 1 / screw);
    const double twist_of_screw = pi * 79e9 * 1e-8 / (2 * 0.55);
    const double twist = 1 / (1 / 3000.0 + 1 / twist_of_screw);
    const double nut = 0.8 * 2e8 * std::cbrt(0.5);
    // Both screws carry half of the force each, and the nut sees the mean of their yields.
    const double exact =
        1 / axis.flexure + 1 / nut + 0.5 / axial + d.ratio * d.ratio * (1 / twist + 1 / d.kp);
    EXPECT_NEAR(yield, exact, 1e-9 * exact);
}

// Figures of the reconstruction that the machine was taken from.
TEST(Drive, HasTheModesOfTheExampleMachine) {
    const auto x = drive_modes(drive(model.axes[0])), y = drive_modes(drive(model.axes[1]));
    ASSERT_EQ(x.size(), 6U);
    ASSERT_EQ(y.size(), 6U);
    const std::array fx{13.9, 45.7, 341.0, 637.0, 696.0, 1055.0};
    const std::array fy{21.6, 45.3, 504.0, 717.0, 777.0, 1290.0};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(x[k].frequency, fx[k], 0.005 * fx[k]) << k;
        EXPECT_NEAR(y[k].frequency, fy[k], 0.005 * fy[k]) << k;
    }
    EXPECT_NEAR(x[0].damping, 0.044, 0.001);
    EXPECT_NEAR(x[1].damping, 0.88, 0.01);
    EXPECT_NEAR(y[0].damping, 0.056, 0.001);
}

TEST(Drive, AScrewHeldAtBothEndsIsSoftestInItsMiddle) {
    DriveAxis axis;
    axis.screw.support = ScrewSupport::fixed_fixed;
    const double middle = axis.screw.length / 2;
    const auto axial = [&](double nut) { return drive(axis, nut).stiffness[0][0]; };
    EXPECT_LT(axial(middle), axial(0.3 * axis.screw.length));
    EXPECT_NEAR(axial(0.3), axial(axis.screw.length - 0.3), 1);
    axis.screw.support = ScrewSupport::fixed_free;
    EXPECT_LT(axial(0.9), axial(0.3));
}

TEST(Drive, FollowsASlowCommandAndLagsBehindByItsCompliance) {
    for (const DriveAxis& axis : model.axes) {
        const Drive d = drive(axis);
        EXPECT_NEAR(std::abs(gain(d, 1e-3)), 1, 1e-9);
        const double omega = 2 * std::numbers::pi;
        const double c2 = (std::abs(gain(d, omega)) - 1) / (omega * omega);
        EXPECT_NEAR(c2, axis.table_mass / axis.flexure, 0.03 * c2);  // 1/ω² within 3 %
    }
}

RC_GTEST_PROP(Drive, TakesAMeasuredMode, ()) {
    const double frequency = *rc::gen::inRange(50, 900) / 10.0;
    const double damping = *rc::gen::inRange(20, 150) / 1000.0;
    const DriveMode mode = first_mode(with_mode({}, {frequency, damping}));
    RC_ASSERT(std::abs(mode.frequency - frequency) < 1e-6 * frequency);
    RC_ASSERT(std::abs(mode.damping - damping) < 1e-6);
}

}  // namespace
}  // namespace bead
