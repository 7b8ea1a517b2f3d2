#include "numeric/conjugate_gradients.h"

#include <cmath>

#include "numeric/product.h"

namespace bead {
namespace {

void add(std::vector<double>& to, double factor, std::span<const double> what) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * what[i];
}

}  // namespace

GradientSolution conjugate_gradients(const LinearMap& a, std::span<const double> b,
                                     const LinearMap& preconditioner,
                                     const GradientOptions& options) {
    GradientSolution s;
    std::vector<double> r(b.begin(), b.end());
    s.x = options.start;
    if (s.x.empty())
        s.x.assign(b.size(), 0.0);
    else
        add(r, -1, a(s.x));
    const double size = std::sqrt(product(b, b));
    const auto is_small = [&] {
        s.residual = size > 0 ? std::sqrt(product(r, r)) / size : 0;
        return s.residual <= options.tolerance;
    };
    s.converged = is_small();
    std::vector<double> p;
    double rz = 0;
    while (!s.converged && s.iterations < options.most) {
        const std::vector<double> z = preconditioner(r);
        const double next = product(r, z);
        if (!(next > 0)) return s;
        if (p.empty())
            p = z;
        else
            for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + next / rz * p[i];
        rz = next;
        const std::vector<double> ap = a(p);
        const double step = rz / product(p, ap);
        add(s.x, step, p);
        add(r, -step, ap);
        ++s.iterations;
        s.converged = is_small();
    }
    return s;
}

}  // namespace bead
