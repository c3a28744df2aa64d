#pragma once
/// The inverse of a tangent by the method of Broyden, Fletcher, Goldfarb and Shanno (BFGS): that of an old tangent, K0, updated by
/// the corrections since. With s = dx and y = the change of R at fixed loads, rho = 1 / (y . s), for each pair
///   H <- (I - rho s y^T) H (I - rho y s^T) + rho s s^T,     so that H y = s,
/// applied by the two-loop recursion of Nocedal (1980) without a matrix. A pair whose y . s is not positive is skipped, so that H
/// keeps the inertia of K0 (also at a saddle point: with such pairs the box of newton_methods_test takes twice the iterations).
/// Source: Matthies and Strang, Int. J. Numer. Meth. Eng. 14 (1979) 1613. Tested by solver/quasi_newton_test.
#include <functional>
#include <vector>

#include "linalg/petsc.hpp"

namespace soft::solver {

class SecantUpdates {
public:
    void clear() { pairs_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }

    void add(linalg::Vector s, linalg::Vector y);

    /// x = H b. `solve`(q, r) gives r = K0^-1 q; if it returns false, so does this function.
    [[nodiscard]] bool apply(Vec b, Vec x, const std::function<bool(Vec, Vec)>& solve) const;

private:
    struct Pair {
        linalg::Vector s, y;
        double rho;
    };
    std::vector<Pair> pairs_;  // oldest first
};

}  // namespace soft::solver
