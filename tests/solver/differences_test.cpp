#include "solver/differences.hpp"

#include <gtest/gtest.h>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"

namespace soft::solver {
namespace {

double norm_of(Mat A) {
    PetscReal value = 0;
    SOFT_PETSC(MatNorm(A, NORM_FROBENIUS, &value));
    return value;
}

struct Deformed {
    Deformed(const model::Case& input, double load_factor)
        : bench(input, input.solver),
          state(bench.rest()),
          R(bench.system.make_vector()),
          K(bench.system.make_matrix()) {
        EXPECT_EQ(bench.newton.correct({ConstraintKind::load_factor}, load_factor, state).end, NewtonEnd::converged);
        levels = bench.loads.levels(1.5 * load_factor, {});  // out of equilibrium
        (void)bench.system.evaluate(state.x, levels, R, K);
    }
    Bench bench;
    State state;
    linalg::Vector R;
    linalg::Matrix K;
    fem::LoadLevels levels;
};

class Differences : public ::testing::TestWithParam<int> {
protected:
    static model::Case input() {
        auto box = box_case(2, GetParam() == 1);
        if (GetParam() == 0) box.formulation = model::Formulation::displacement;
        return GetParam() == 2 ? sphere_case(2, 4) : box;
    }
};

TEST_P(Differences, ColouredDifferencesAreTheTangent) {
    const auto sample = input();
    Deformed at(sample, 0.1);
    auto K = at.bench.system.make_matrix();
    ResidualDifferences differences(at.bench.system, K, model::TangentSource::finite_difference);
    differences.tangent(at.state.x, at.levels, K);
    SOFT_PETSC(MatAXPY(K, -1.0, at.K, SAME_NONZERO_PATTERN));
    EXPECT_LT(norm_of(K), 1e-6 * norm_of(at.K));
}

TEST_P(Differences, TheOperatorIsTheTangentTimesAVector) {
    const auto sample = input();
    Deformed at(sample, 0.1);
    ResidualDifferences differences(at.bench.system, at.K, model::TangentSource::exact);
    differences.set_base(at.state.x, at.levels, at.R);
    auto v = linalg::duplicate(at.R), exact = linalg::duplicate(at.R), product = linalg::duplicate(at.R);
    SOFT_PETSC(VecSetRandom(v, nullptr));
    SOFT_PETSC(MatMult(at.K, v, exact));
    SOFT_PETSC(MatMult(differences.jacobian(), v, product));
    linalg::add(product, -1.0, exact);
    EXPECT_LT(linalg::norm(product), 1e-6 * linalg::norm(exact));
    SOFT_PETSC(VecZeroEntries(v));
    SOFT_PETSC(MatMult(differences.jacobian(), v, product));
    EXPECT_EQ(linalg::norm(product), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Of, Differences, ::testing::Values(0, 1, 2), [](const auto& test) {
    return std::string(test.param == 0 ? "Displacements" : test.param == 1 ? "PressureUnknowns" : "AnInflatedSphere");
});

}  // namespace
}  // namespace soft::solver
