#pragma once
/// Least squares of few unknowns within bounds, exactly: min |A c - y| with low <= c <= high. One QR of the scaled [A y]
/// (not the normal equations: I1 - 3 spans four decades) leaves a triangle of the size of c; on it the unconstrained
/// minimum, or, where that leaves the bounds, the best of all sets of active bounds (the problem is convex, and there are
/// few). Private to the module. Tested by fit/bounded_test.
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
