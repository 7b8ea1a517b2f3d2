// The problems that docs/fem.md gives times for, solved by our multigrid and, the same elements put
// into a matrix, by PETSc's conjugate gradients with algebraic multigrid (GAMG, near-null space of
// rigid motions), to the same residual. Built only where PETSc is (apt install petsc-dev):
//
//     cmake --build build/release --target against_petsc && build/release/against_petsc 3 68 68 68
#include <petscksp.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "fem/grid_multigrid.h"

namespace {

using namespace bead;

double cpu() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Problem {
    ElasticGrid grid;
    std::vector<std::uint8_t> held;
    std::vector<double> load;
};

// Held at x = 0, pulled down evenly at the other end.
Problem problem(int dimensions, std::array<int, 3> cells) {
    const double nu = 0.35, mu = 1 / (2 * (1 + nu));
    Problem p{{dimensions, cells, {}, isotropic(1, nu), 2 * mu * nu / (1 - 2 * nu), mu}, {}, {}};
    p.grid.factor.assign(
        std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(std::max(1, cells[2])), 1.0F);
    p.held.assign(p.grid.unknowns(), 0);
    p.load.assign(p.grid.unknowns(), 0.0);
    const std::size_t nx = std::size_t(cells[0]) + 1, d = std::size_t(dimensions);
    for (std::size_t node = 0; node < p.grid.nodes(); ++node) {
        if (node % nx == 0) std::fill_n(p.held.begin() + std::ptrdiff_t(d * node), d, 1);
        if (node % nx + 1 == nx) p.load[d * node + 1] = -double(nx) / double(p.grid.nodes());
    }
    return p;
}

// Of one element, by node then component.
std::vector<double> element_matrix(const ElasticGrid& grid) {
    const ElasticGrid one{
        grid.dimensions, {1, 1, grid.cells[2] > 0 ? 1 : 0}, {1.0F}, grid.law, grid.lambda, grid.mu};
    const std::size_t size = one.unknowns(), n = one.nodes(), d = std::size_t(grid.dimensions);
    std::vector<double> matrix(size * size), value(size), column(size);
    for (std::size_t j = 0; j < size; ++j) {
        std::fill(value.begin(), value.end(), 0.0);
        value[j % d * n + j / d] = 1;
        multiply(one, value.data(), column.data());
        for (std::size_t i = 0; i < size; ++i) matrix[j * size + i] = column[i % d * n + i / d];
    }
    return matrix;
}

Mat assembled(const Problem& p) {
    const ElasticGrid& grid = p.grid;
    const PetscInt d = grid.dimensions, corners = 1 << d;
    const int nx = grid.cells[0] + 1, ny = grid.cells[1] + 1;
    const std::vector<double> values = element_matrix(grid);
    Mat a = nullptr;
    MatCreateSeqAIJ(PETSC_COMM_SELF, PetscInt(grid.unknowns()), PetscInt(grid.unknowns()),
                    d == 2 ? 18 : 81, nullptr, &a);
    MatSetBlockSize(a, d);
    for (int z = 0; z < std::max(1, grid.cells[2]); ++z)
        for (int y = 0; y + 1 < ny; ++y)
            for (int x = 0; x + 1 < nx; ++x) {
                PetscInt nodes[8];
                for (int k = 0; k < corners; ++k)
                    nodes[k] = ((z + k / 4) * ny + y + k / 2 % 2) * nx + x + k % 2;
                MatSetValuesBlocked(a, corners, nodes, corners, nodes, values.data(), ADD_VALUES);
            }
    MatAssemblyBegin(a, MAT_FINAL_ASSEMBLY);
    MatAssemblyEnd(a, MAT_FINAL_ASSEMBLY);
    return a;
}

void add_rigid_motions(Mat a, const ElasticGrid& grid) {
    Vec places = nullptr;
    VecCreateSeq(PETSC_COMM_SELF, PetscInt(grid.unknowns()), &places);
    VecSetBlockSize(places, grid.dimensions);
    PetscScalar* at = nullptr;
    VecGetArray(places, &at);
    const std::size_t nx = std::size_t(grid.cells[0]) + 1, ny = std::size_t(grid.cells[1]) + 1;
    const std::size_t d = std::size_t(grid.dimensions);
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        at[d * node] = double(node % nx);
        at[d * node + 1] = double(node / nx % ny);
        if (d == 3) at[d * node + 2] = double(node / (nx * ny));
    }
    VecRestoreArray(places, &at);
    MatNullSpace near = nullptr;
    MatNullSpaceCreateRigidBody(places, &near);
    MatSetNearNullSpace(a, near);
    MatNullSpaceDestroy(&near);
    VecDestroy(&places);
}

void by_petsc(const Problem& p) {
    const double start = cpu();
    Mat a = assembled(p);
    add_rigid_motions(a, p.grid);
    std::vector<PetscInt> rows;
    for (std::size_t i = 0; i < p.held.size(); ++i)
        if (p.held[i] != 0) rows.push_back(PetscInt(i));
    MatZeroRowsColumns(a, PetscInt(rows.size()), rows.data(), 1, nullptr, nullptr);
    MatSetOption(a, MAT_SPD, PETSC_TRUE);
    Vec b = nullptr, x = nullptr;
    VecCreateSeqWithArray(PETSC_COMM_SELF, p.grid.dimensions, PetscInt(p.load.size()),
                          p.load.data(), &b);
    VecDuplicate(b, &x);
    const double matrix = cpu();
    KSP solver = nullptr;
    KSPCreate(PETSC_COMM_SELF, &solver);
    KSPSetOperators(solver, a, a);
    KSPSetType(solver, KSPCG);
    KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED);
    KSPSetTolerances(solver, 1e-8, PETSC_DEFAULT, PETSC_DEFAULT, 1000);
    PC multigrid = nullptr;
    KSPGetPC(solver, &multigrid);
    PCSetType(multigrid, PCGAMG);
    KSPSetFromOptions(solver);
    KSPSolve(solver, b, x);
    PetscInt iterations = 0;
    PetscScalar work = 0;
    KSPGetIterationNumber(solver, &iterations);
    VecDot(b, x, &work);
    std::printf("PETSc  %6.2f s CPU (%.2f s of it for the matrix), %d iterations, work %.9g\n",
                cpu() - start, matrix - start, int(iterations), work);
}

void by_ours(const Problem& p) {
    const double start = cpu();
    const Displacement u = multigrid_solution(p.grid, p.held, p.load, {});
    double work = 0;
    for (std::size_t i = 0; i < p.load.size(); ++i) work += p.load[i] * u.values[i];
    std::printf("ours   %6.2f s CPU, %d iterations, work %.9g\n", cpu() - start, u.iterations,
                work);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: against_petsc 2|3 COLUMNS ROWS [LAYERS]\n");
        return 2;
    }
    const int d = std::atoi(argv[1]);
    const Problem p =
        problem(d, {std::atoi(argv[2]), std::atoi(argv[3]), d == 3 ? std::atoi(argv[4]) : 0});
    std::printf("%zu unknowns\n", p.grid.unknowns());
    by_ours(p);
    PetscInitialize(nullptr, nullptr, nullptr, nullptr);
    by_petsc(p);
    PetscFinalize();
    return 0;
}
