#pragma once
/// L D L^T of a symmetric AIJ matrix, without pivoting, by CHOLMOD's simplicial code: for matrices of few flops, where
/// the bookkeeping of a multifrontal code costs most (8.6k unknowns of a section: a fourth of MUMPS's time for a factor, a tenth
/// for a solve).
/// Saddle points [A B^T; B -C] with positive definite A and C have such factors in any order (quasi-definite: Vanderbei, SIAM J.
/// Optim. 5 (1995) 100), with a growth of rounding of the order of |B A^-1 B^T|/|C| (Gill, Saunders and Shinnerl, SIAM J. Matrix
/// Anal. Appl. 17 (1996) 35). That growth is bounded here: a diagonal of a pressure that is smaller than 1e-6 of
/// s_i = sum_j K_ij^2 / K_jj is taken as -1e-6 s_i. What the factor then misses, and what a far from definite A costs, the
/// iterations of LinearSolver have to correct, which tells a factor that is not good enough.
/// Only the triangle above the diagonal is read, as by MUMPS.
/// Of a matrix on several ranks each rank factorises the whole: the same sums in the same order whenever a message comes, as a
/// code that shares the work does not promise, and for these matrices sooner done. Tested by linalg/sparse_ldlt_test and, on two
/// ranks, tests/faults/same_bytes.sh.
#include <memory>

#include "linalg/factors.hpp"

namespace soft::linalg {

class SparseLdlt final : public Factors {
public:
    /// Orders the unknowns by the pattern of K (AMD), which all later matrices have.
    explicit SparseLdlt(Mat K);
    ~SparseLdlt() override;

    [[nodiscard]] double flops() const;  ///< of one factorisation
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
