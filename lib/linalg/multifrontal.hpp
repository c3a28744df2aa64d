#pragma once
/// L D L^T factorisation of a symmetric AIJ matrix, without pivoting, by the multifrontal method (Duff and Reid, ACM Trans. Math. Softw. 9
/// (1983) 302; Liu, SIAM Review 34 (1992) 82). The symbolic factorisation is CHOLMOD's; the fronts are factorised here, by threads:
/// independent subtrees and the tiles of large fronts are tasks. Each sum is computed in the same order for any number of threads, so
/// that the factor has the same bytes. Measured against MUMPS's LDL^T with pivoting: twice as fast on one core, four times on two.
/// A saddle-point matrix [A B^T; B -C] with positive definite A and C has such a factor in any order (quasi-definite: Vanderbei,
/// SIAM J. Optim. 5 (1995) 100). Rounding errors grow by the order of |B A^-1 B^T|/|C| (Gill, Saunders and Shinnerl, SIAM J. Matrix
/// Anal. Appl. 17 (1996) 35). That growth is bounded here: a pressure diagonal with a magnitude below 1e-6 of
/// s_i = sum_j K_ij^2 / K_jj is replaced by -1e-6 s_i. The iterations of LinearSolver correct this perturbation and the error of a
/// far from definite A; their number shows whether the factor is good enough.
/// Of the two entries (i, j) and (j, i) only that in the row eliminated first is read, unless both unknowns are `last`. These are
/// eliminated last: L D L^T of their front with the mean of both entries gives the inertia, and LU of it with both entries solves, where
/// the difference is small.
/// On several ranks each rank factorises the whole matrix. The order of the sums then does not depend on the arrival of messages,
/// which a distributed code does not guarantee, and for small matrices it is faster. Tested by linalg/multifrontal_test and, on two
/// ranks, tests/faults/same_bytes.sh.
#include <memory>
#include <vector>

#include "linalg/factors.hpp"

namespace soft::linalg {

class Multifrontal final : public Factors {
public:
    /// Orders the unknowns by the pattern of K. All later matrices must have this pattern. `threads`: math/threads.hpp, for large K.
    explicit Multifrontal(Mat K, int threads = 1, std::vector<PetscInt> last = {});
    ~Multifrontal() override;

    /// Multiplications and additions of a factorisation; infinite if the factor by groups (elimination_order.hpp) has more entries than
    /// an int can count. No other function may be called then.
    [[nodiscard]] double flops() const;
    [[nodiscard]] bool factorize(Mat K) override;
    [[nodiscard]] std::optional<PetscInt> negative_pivots() const override;
    [[nodiscard]] std::optional<bool> determinant_is_negative() const override { return std::nullopt; }
    void solve(Vec b, Vec x) override;
    void set_transposed(bool transposed) override;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::linalg
