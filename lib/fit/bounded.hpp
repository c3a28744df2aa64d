#pragma once
/// Exact solution of a bounded least-squares problem with few unknowns: min |A c - y| with low <= c <= high. One QR of the scaled
/// [A y] (not the normal equations, because I1 - 3 spans four decades) reduces the problem to a triangle of the size of c. The
/// result is the unconstrained minimum or, if that violates the bounds, the best over all sets of active bounds (the problem is
/// convex, and the sets are few). Private to the module. Tested by fit/bounded_test.
#include <Eigen/Dense>
#include <vector>

namespace soft::fit {

struct BoundedFit {
    Eigen::VectorXd c;
    std::vector<bool> free;  ///< not at a bound
    double residual_squared = 0;
};

[[nodiscard]] BoundedFit solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& y, const Eigen::VectorXd& low,
                                       const Eigen::VectorXd& high);

}  // namespace soft::fit
