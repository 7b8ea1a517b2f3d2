#include "fem/plate_element.h"

#include <Eigen/LU>
#include <cmath>

namespace bead {
namespace {

using Matrix = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;
using Row = Eigen::Matrix<double, 1, 12>;

// The terms x^i y^j, on the parent [-1, 1]².
constexpr int powers[12][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2},
                               {3, 0}, {2, 1}, {1, 2}, {0, 3}, {3, 1}, {1, 3}};

double derived(double x, int power, int times) {
    double factor = 1;
    for (int i = 0; i < times; ++i) factor *= power - i;
    return factor == 0 ? 0 : factor * std::pow(x, power - times);
}

// The terms' derivatives at a place, dx times by x and dy times by y.
Row terms(double x, double y, int dx, int dy) {
    Row row;
    for (int k = 0; k < 12; ++k)
        row[k] = derived(x, powers[k][0], dx) * derived(y, powers[k][1], dy);
    return row;
}

// From corner unknowns to the terms' coefficients.
const Matrix& coefficients() {
    static const Matrix inverse = [] {
        constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        Matrix values;
        for (int c = 0; c < 4; ++c) {
            values.row(3 * c) = terms(corner[c][0], corner[c][1], 0, 0);
            values.row(3 * c + 1) = terms(corner[c][0], corner[c][1], 1, 0);
            values.row(3 * c + 2) = terms(corner[c][0], corner[c][1], 0, 1);
        }
        return Matrix(values.inverse());
    }();
    return inverse;
}

template <class Integrand>
PlateMatrix integrated(const Integrand& integrand) {
    const double g = std::sqrt(0.6);
    const double place[] = {-g, 0, g}, weight[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    Matrix sum = Matrix::Zero();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += weight[i] * weight[j] * integrand(place[i], place[j]);
    const Matrix whole = coefficients().transpose() * sum * coefficients();
    PlateMatrix result{};
    Eigen::Map<Matrix>(result.data()) = (whole + whole.transpose()) / 2;
    return result;
}

}  // namespace

PlateMatrix plate_stiffness(const PlaneLaw& d, double side) {
    const double scale = 4 / (side * side);
    Eigen::Matrix3d law;
    law << d.xx, d.xy, d.xs, d.xy, d.yy, d.ys, d.xs, d.ys, d.ss;
    return integrated([&](double x, double y) -> Matrix {
        Eigen::Matrix<double, 3, 12> bend;
        bend << terms(x, y, 2, 0), terms(x, y, 0, 2), 2 * terms(x, y, 1, 1);
        return scale * bend.transpose() * law * bend;
    });
}

PlateMatrix plate_geometric_stiffness(PlaneTensor n) {
    Eigen::Matrix2d force;
    force << n.xx, n.xy, n.xy, n.yy;
    return integrated([&](double x, double y) -> Matrix {
        Eigen::Matrix<double, 2, 12> slope;
        slope << terms(x, y, 1, 0), terms(x, y, 0, 1);
        return slope.transpose() * force * slope;
    });
}

}  // namespace bead
