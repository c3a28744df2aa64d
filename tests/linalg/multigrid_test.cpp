// A bar of quadratic cells with a discontinuous linear pressure, whose equilibrium is known in closed form.
#include "linalg/multigrid.hpp"

#include <gtest/gtest.h>

#include <array>

#include "linalg/linear_solver.hpp"

namespace soft::linalg {
namespace {

constexpr double mu = 3.0, kappa = 100 * mu, length = 2.0, force = 5.0;

/// Unknowns, cell by cell: the middle and the right node, and two pressures if the bar is mixed. The left end is fixed.
struct Bar {
    int cells;
    bool mixed;
    [[nodiscard]] PetscInt stride() const { return mixed ? 4 : 2; }
    [[nodiscard]] PetscInt unknowns() const { return cells * stride(); }
    [[nodiscard]] PetscInt node(int number) const {  // of 2 cells + 1
        return number == 0 ? -1 : (number - 1) / 2 * stride() + (number - 1) % 2;
    }
    [[nodiscard]] PetscInt pressure(int cell) const { return cell * stride() + 2; }
    [[nodiscard]] double h() const { return length / cells; }
};

/// mu u' v' + p v' + q u' - p q / kappa, the pressure functions 1 and xi in [-1, 1]. Not mixed: (mu + kappa) u' v'.
Matrix stiffness(const Bar& bar) {
    Matrix K;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, bar.unknowns(), bar.unknowns(), 10, nullptr, K.out()));
    // Integrals over [-1, 1] of N' N' and of N' {1, xi} for the nodes at -1, 0, 1; d/dx = 2/h d/dxi.
    constexpr std::array<double, 9> stretch{7.0 / 6,  -4.0 / 3, 1.0 / 6,  -4.0 / 3, 8.0 / 3,
                                            -4.0 / 3, 1.0 / 6,  -4.0 / 3, 7.0 / 6};
    constexpr std::array<double, 6> divergence{-1, 0, 1, 2.0 / 3, -4.0 / 3, 2.0 / 3};
    const double modulus = bar.mixed ? mu : mu + kappa;
    std::array<double, 25> block{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) block[5 * i + j] = modulus * 2 / bar.h() * stretch[3 * i + j];
    for (int s = 0; s < 2; ++s) {
        for (int j = 0; j < 3; ++j) block[5 * (3 + s) + j] = block[5 * j + 3 + s] = divergence[3 * s + j];
        block[6 * (3 + s)] = -0.5 * bar.h() / kappa * (s == 0 ? 2.0 : 2.0 / 3);
    }
    for (int cell = 0; cell < bar.cells; ++cell) {
        const PetscInt p = bar.mixed ? bar.pressure(cell) : -1;
        const std::array<PetscInt, 5> rows{bar.node(2 * cell), bar.node(2 * cell + 1), bar.node(2 * cell + 2), p,
                                           bar.mixed ? p + 1 : -1};
        SOFT_PETSC(MatSetValues(K, 5, rows.data(), 5, rows.data(), block.data(), ADD_VALUES));
    }
    assemble(K);
    return K;
}

ElementLevels levels_of(const Bar& bar) {
    ElementLevels levels;
    std::vector<PetscInt> displacements, pressures;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, 2 * bar.cells, bar.cells, 2, nullptr, levels.interpolation.out()));
    const Mat P = levels.interpolation;
    for (int cell = 0; cell < bar.cells; ++cell) {
        displacements.push_back(bar.node(2 * cell + 1));
        displacements.push_back(bar.node(2 * cell + 2));
        if (cell > 0) SOFT_PETSC(MatSetValue(P, 2 * cell, cell - 1, 0.5, INSERT_VALUES));
        SOFT_PETSC(MatSetValue(P, 2 * cell, cell, 0.5, INSERT_VALUES));
        SOFT_PETSC(MatSetValue(P, 2 * cell + 1, cell, 1.0, INSERT_VALUES));
        if (!bar.mixed) continue;
        pressures.push_back(bar.pressure(cell));
        pressures.push_back(bar.pressure(cell) + 1);
        levels.blocks.push_back({PressureBlock::Kind::of_cell, 2, {bar.h() / mu, 0, 0, bar.h() / (3 * mu)}});
    }
    assemble(P);
    const auto set = [](const std::vector<PetscInt>& numbers, IndexSet& to) {
        SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(numbers.size()), numbers.data(),
                                   PETSC_COPY_VALUES, to.out()));
    };
    set(displacements, levels.displacements);
    set(pressures, levels.pressures);
    return levels;
}

struct Solution {
    std::vector<double> x;
    int iterations = 0;
};

/// Solves the bar under `force` at the right end.
Solution pulled(const Bar& bar) {
    const auto K = stiffness(bar);
    LinearSettings settings;
    settings.method = LinearMethod::krylov;
    settings.preconditioner = Preconditioner::multigrid;
    settings.tolerance = 1e-10;
    LinearSolver solver(K, Symmetry::symmetric, settings);
    solver.set_levels(levels_of(bar));
    EXPECT_TRUE(solver.factorize().succeeded);
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    SOFT_PETSC(VecSetValue(b, bar.node(2 * bar.cells), force, INSERT_VALUES));
    const auto solve = solver.solve(b, x);
    EXPECT_TRUE(solve.converged);
    return {gather(x), solve.iterations};
}

// u' = force / (mu + kappa) and p = kappa u' throughout.
TEST(Multigrid, BarUnderTensionHasTheExactStrainAndPressure) {
    const double strain = force / (mu + kappa);
    for (const bool mixed : {true, false}) {
        const Bar bar{40, mixed};
        const auto x = pulled(bar).x;
        for (int node = 1; node <= 2 * bar.cells; ++node)
            EXPECT_NEAR(x[bar.node(node)], strain * node * bar.h() / 2, 1e-7 * strain * length);
        for (int cell = 0; cell < bar.cells && mixed; ++cell) {
            EXPECT_NEAR(x[bar.pressure(cell)], kappa * strain, 1e-6 * kappa * strain);
            EXPECT_NEAR(x[bar.pressure(cell) + 1], 0.0, 1e-6 * kappa * strain);
        }
    }
}

TEST(Multigrid, IterationsDoNotGrowWithTheNumberOfCells) {
    for (const bool mixed : {true, false})
        EXPECT_LE(pulled({1000, mixed}).iterations, 1.2 * pulled({50, mixed}).iterations);
}

/// Number of iterations after `factorize` for a force at the right end.
int iterations(LinearSolver& solver, Mat K, const Bar& bar) {
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    SOFT_PETSC(VecSetValue(b, bar.node(2 * bar.cells), force, INSERT_VALUES));
    EXPECT_TRUE(solver.factorize().succeeded);
    const auto solve = solver.solve(b, x);
    EXPECT_TRUE(solve.converged);
    return solve.iterations;
}

TEST(Multigrid, UpdatedForANewTangentEqualsANewSolver) {
    const Bar bar{60, true};
    auto K = stiffness(bar);
    LinearSettings settings;
    settings.method = LinearMethod::krylov;
    settings.preconditioner = Preconditioner::multigrid;
    settings.iteration_limit = 200;
    LinearSolver kept(K, Symmetry::symmetric, settings);
    kept.set_levels(levels_of(bar));
    (void)iterations(kept, K, bar);
    Vector scale;  // a different modulus in every cell
    SOFT_PETSC(MatCreateVecs(K, scale.out(), nullptr));
    for (PetscInt i = 0; i < bar.unknowns(); ++i) SOFT_PETSC(VecSetValue(scale, i, 1.0 + 0.5 * (i % 7), INSERT_VALUES));
    SOFT_PETSC(MatDiagonalScale(K, scale, scale));
    LinearSolver fresh(K, Symmetry::symmetric, settings);
    fresh.set_levels(levels_of(bar));
    EXPECT_EQ(iterations(kept, K, bar), iterations(fresh, K, bar));
}

}  // namespace
}  // namespace soft::linalg
