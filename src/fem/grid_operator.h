// K u on a regular grid of square or cubic elements, without a matrix. A row of elements at a time:
// the corners' values are turned into modes (fem/pixel_element.h tells how, in the plane), in which
// the integrals of the energy fall apart; a cube costs some 250 operations instead of 1152, all on
// neighbours in memory, so that the compiler can do several at once.
//
// Components are stored one after another, all x, then all y …; nodes with x running fastest.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/plane_law.h"

namespace bead {

struct ElasticGrid {
    int dimensions = 2;
    std::array<int, 3> cells{1, 1, 0};  // of a plane one the third is 0
    std::vector<float> factor;          // per cell, of the law; 0: absent
    PlaneLaw law;                       // plane: thickness and law
    double lambda = 0, mu = 0;          // in space: Lamé's constants, times the side of a cube

    [[nodiscard]] std::size_t nodes() const {
        return std::size_t(cells[0] + 1) * std::size_t(cells[1] + 1) * std::size_t(cells[2] + 1);
    }
    [[nodiscard]] std::size_t unknowns() const { return nodes() * std::size_t(dimensions); }
};

// `result` is overwritten; both have as many numbers as there are unknowns.
void multiply(const ElasticGrid& grid, const float* u, float* result);
void multiply(const ElasticGrid& grid, const double* u, double* result);

// K's diagonal.
std::vector<float> diagonal(const ElasticGrid& grid);

// Not less than the largest eigenvalue of D^-1 K, D being K's diagonal: no sum of elements has a
// larger one than an element by itself.
double largest_eigenvalue(const ElasticGrid& grid);

}  // namespace bead
