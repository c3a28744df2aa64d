#include "fit/bounded.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace soft::fit {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// Columns over four decades, and a right-hand side whose unconstrained solution has a negative second unknown.
struct Problem {
    Eigen::MatrixXd A{6, 3};
    Eigen::VectorXd y{6};
    Problem() {
        A << 1, 10, 1e4, 2, 11, 3e4, 3, 9, 1e4, 4, 12, 5e4, 5, 8, 9e4, 6, 13, 2e4;
        y << 3, -1, 4, -1, 5, -9;
    }
};

/// Optimality (Karush, Kuhn, Tucker): the gradient is 0 for free unknowns and points out of the bounds for the others.
void expect_optimal(const Problem& problem, const Eigen::VectorXd& low, const Eigen::VectorXd& high) {
    const BoundedFit fit = solve_bounded(problem.A, problem.y, low, high);
    const Eigen::VectorXd gradient = problem.A.transpose() * (problem.A * fit.c - problem.y);
    for (Eigen::Index i = 0; i < fit.c.size(); ++i) {
        const double size = problem.A.col(i).norm() * problem.y.norm();
        EXPECT_GE(fit.c[i], low[i]);
        EXPECT_LE(fit.c[i], high[i]);
        if (fit.free[static_cast<std::size_t>(i)]) {
            EXPECT_NEAR(gradient[i], 0.0, 1e-12 * size);
        } else {
            EXPECT_GE(fit.c[i] == low[i] ? gradient[i] : -gradient[i], -1e-12 * size);
        }
    }
    EXPECT_NEAR(fit.residual_squared, (problem.A * fit.c - problem.y).squaredNorm(), 1e-10 * problem.y.squaredNorm());
}

TEST(BoundedLeastSquares, SatisfiesTheOptimalityConditions) {
    const Problem problem;
    const Eigen::VectorXd free = Eigen::VectorXd::Constant(3, none);
    expect_optimal(problem, -free, free);
    expect_optimal(problem, Eigen::VectorXd::Zero(3), free);
    expect_optimal(problem, Eigen::Vector3d{-none, 0.0, 1e-5}, Eigen::Vector3d{0.1, 0.2, none});
    expect_optimal(problem, Eigen::Vector3d{-0.1, -0.1, -1e-5}, Eigen::Vector3d{0.1, 0.1, 1e-5});
}

}  // namespace
}  // namespace soft::fit
