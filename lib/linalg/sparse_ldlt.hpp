#pragma once
/// L D L^T factorisation of a symmetric AIJ matrix, without pivoting, by CHOLMOD's simplicial code. It is meant for matrices with few
/// flops, where the overhead of a multifrontal code dominates (2D section with 8.6k unknowns: a quarter of MUMPS's time for a
/// factorisation, a tenth for a solve).
/// A saddle-point matrix [A B^T; B -C] with positive definite A and C has such a factor in any order (quasi-definite: Vanderbei,
/// SIAM J. Optim. 5 (1995) 100). Rounding errors grow by the order of |B A^-1 B^T|/|C| (Gill, Saunders and Shinnerl, SIAM J. Matrix
/// Anal. Appl. 17 (1996) 35). That growth is bounded here: a pressure diagonal with a magnitude below 1e-6 of
/// s_i = sum_j K_ij^2 / K_jj is replaced by -1e-6 s_i. The iterations of LinearSolver correct this perturbation and the error of a
/// far from definite A; their number shows whether the factor is good enough.
/// Only the upper triangle is read, as by MUMPS.
/// On several ranks each rank factorises the whole matrix. The order of the sums then does not depend on the arrival of messages,
/// which a distributed code does not guarantee, and for these matrices it is faster. Tested by linalg/sparse_ldlt_test and, on two
/// ranks, tests/faults/same_bytes.sh.
#include <memory>

#include "linalg/factors.hpp"

namespace soft::linalg {

class SparseLdlt final : public Factors {
public:
    /// Orders the unknowns by the pattern of K (AMD). All later matrices must have this pattern.
    explicit SparseLdlt(Mat K);
    ~SparseLdlt() override;

    [[nodiscard]] double flops() const;  ///< per factorisation
    [[nodiscard]] bool factorize(Mat K) override;
    [[nodiscard]] std::optional<PetscInt> negative_pivots() const override;
    [[nodiscard]] std::optional<bool> determinant_is_negative() const override { return std::nullopt; }
    void solve(Vec b, Vec x) override;

private:
    void read_values(Mat K);
    [[nodiscard]] bool has_good_pivots() const;
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::linalg
