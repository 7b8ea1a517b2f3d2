#include "numeric/least_squares.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/expects.h"

namespace bead {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double dependent = 1e-12;  // singular value, relative to the largest

struct Problem {  // weighted and scaled
    MatrixXd rows;
    VectorXd values;
    VectorXd scale;  // of the columns
};

Problem scaled(const Rows& rows, const std::vector<double>& values, const FitOptions& options) {
    const auto n = Index(rows.size()), p = Index(rows.front().size());
    Problem problem{MatrixXd(n, p), VectorXd(n), VectorXd(p)};
    for (Index i = 0; i < n; ++i) {
        BEAD_EXPECTS(Index(rows[std::size_t(i)].size()) == p);
        const double root =
            options.weights.empty() ? 1 : std::sqrt(options.weights[std::size_t(i)]);
        for (Index j = 0; j < p; ++j)
            problem.rows(i, j) = root * rows[std::size_t(i)][std::size_t(j)];
        problem.values(i) = root * values[std::size_t(i)];
    }
    for (Index j = 0; j < p; ++j) {
        const double size = problem.rows.col(j).norm();
        problem.scale(j) = size > 0 ? size : 1;
        problem.rows.col(j) /= problem.scale(j);
    }
    return problem;
}

MatrixXd columns(const MatrixXd& rows, const std::vector<Index>& chosen) {
    MatrixXd part(rows.rows(), Index(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k) part.col(Index(k)) = rows.col(chosen[k]);
    return part;
}

VectorXd solved(const MatrixXd& rows, const VectorXd& values) {
    Eigen::JacobiSVD<MatrixXd> svd(rows, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(dependent);
    return svd.solve(values);
}

// Which columns stay above 0: one more at a time, the steepest first, back inside whenever one
// would fall below.
std::vector<Index> positive_columns(const Problem& problem) {
    const Index p = problem.rows.cols();
    std::vector<Index> free;
    VectorXd x = VectorXd::Zero(p);
    for (Index round = 0; round < 3 * p; ++round) {
        const VectorXd slope = problem.rows.transpose() * (problem.values - problem.rows * x);
        Index best = -1;
        for (Index j = 0; j < p; ++j)
            if (std::ranges::find(free, j) == free.end() && slope(j) > 1e-10 &&
                (best < 0 || slope(j) > slope(best)))
                best = j;
        if (best < 0) break;
        free.push_back(best);
        while (!free.empty()) {
            const VectorXd part = solved(columns(problem.rows, free), problem.values);
            double step = 1;
            for (std::size_t k = 0; k < free.size(); ++k)
                if (part(Index(k)) <= 0)
                    step = std::min(step, x(free[k]) / (x(free[k]) - part(Index(k))));
            for (std::size_t k = 0; k < free.size(); ++k)
                x(free[k]) += step * (part(Index(k)) - x(free[k]));
            if (step >= 1) break;
            std::erase_if(free, [&](Index j) { return x(j) <= 1e-14; });
            for (Index j = 0; j < p; ++j)
                if (std::ranges::find(free, j) == free.end()) x(j) = 0;
        }
    }
    std::ranges::sort(free);
    return free;
}

}  // namespace

double dot(const Row& row, const std::vector<double>& coefficients) {
    return std::inner_product(row.begin(), row.end(), coefficients.begin(), 0.0);
}

LinearFit fit_linear(const Rows& rows, const std::vector<double>& values,
                     const FitOptions& options) {
    BEAD_EXPECTS(!rows.empty() && rows.size() == values.size());
    BEAD_EXPECTS(options.weights.empty() || options.weights.size() == rows.size());
    BEAD_EXPECTS(!rows.front().empty() && rows.size() >= rows.front().size());
    const Problem problem = scaled(rows, values, options);
    const Index n = problem.rows.rows(), p = problem.rows.cols();
    std::vector<Index> free(std::size_t(p), 0);
    std::iota(free.begin(), free.end(), 0);
    if (options.non_negative) free = positive_columns(problem);

    LinearFit fit;
    fit.coefficients.assign(std::size_t(p), 0);
    fit.standard_errors.assign(std::size_t(p), 0);
    fit.covariance.assign(std::size_t(p), std::vector<double>(std::size_t(p), 0));
    fit.leverage.assign(std::size_t(n), 0);
    if (free.empty()) return fit;

    const MatrixXd part = columns(problem.rows, free);
    Eigen::JacobiSVD<MatrixXd> svd(part, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(dependent);
    const VectorXd x = svd.solve(problem.values);
    const VectorXd& singular = svd.singularValues();
    const double least = singular(singular.size() - 1);
    fit.condition = least > dependent * singular(0) ? singular(0) / least
                                                    : std::numeric_limits<double>::infinity();

    const VectorXd off = problem.values - part * x;
    const auto spare = double(n - Index(free.size()));
    const double variance = spare > 0 ? off.squaredNorm() / spare : 0;
    fit.residual = std::sqrt(variance);
    const double weight = problem.values.squaredNorm();
    fit.r2 = weight > 0 ? 1 - off.squaredNorm() / weight : 1;
    VectorXd ones(n);
    for (Index i = 0; i < n; ++i)
        ones(i) = options.weights.empty() ? 1 : std::sqrt(options.weights[std::size_t(i)]);
    const VectorXd about = problem.values - ones * (ones.dot(problem.values) / ones.squaredNorm());
    fit.r2_centred = about.squaredNorm() > 0 ? 1 - off.squaredNorm() / about.squaredNorm() : 1;

    MatrixXd inverse = MatrixXd::Zero(x.size(), x.size());  // of part' part
    for (Index k = 0; k < singular.size(); ++k)
        if (singular(k) > dependent * singular(0)) {
            inverse += svd.matrixV().col(k) * svd.matrixV().col(k).transpose() /
                       (singular(k) * singular(k));
            for (Index i = 0; i < n; ++i)
                fit.leverage[std::size_t(i)] += svd.matrixU()(i, k) * svd.matrixU()(i, k);
        }
    for (std::size_t a = 0; a < free.size(); ++a) {
        const auto row = std::size_t(free[a]);
        fit.coefficients[row] = x(Index(a)) / problem.scale(free[a]);
        for (std::size_t b = 0; b < free.size(); ++b)
            fit.covariance[row][std::size_t(free[b])] =
                variance * inverse(Index(a), Index(b)) /
                (problem.scale(free[a]) * problem.scale(free[b]));
        fit.standard_errors[row] = std::sqrt(fit.covariance[row][row]);
    }
    return fit;
}

}  // namespace bead
