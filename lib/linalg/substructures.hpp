#pragma once
/// Direct factorisation of a distributed matrix by substructuring. Each rank factorises its interior I_r, which does not couple with
/// other ranks, by a sequential MUMPS instance, which also computes the Schur complement on the shared unknowns G:
///   S = K_GG - sum_r K_GI_r K_I_rI_r^-1 K_I_rG.
/// Every rank factorises the dense S (LAPACK). A solve takes one solve with each interior and one with S. The shared unknowns G are
/// those that couple with unknowns of a higher rank. A symmetric matrix is factorised as LDL^T: each rank's own rows are read, and
/// the upper triangle of the interiors and of S. A general matrix is factorised as LU. The interiors of a saddle-point matrix are
/// regular because each pressure is constrained by the displacements of its own cell. They are ordered by nested dissection
/// (linalg/elimination_order).
/// Advantages over one distributed MUMPS: no messages during a factorisation, half the ordering time, and sums whose order does not
/// depend on the arrival of messages, so that two runs agree bitwise. S grows with the number of ranks, so this is used only
/// while G has at most `max_shared_unknowns`. Source: Przemieniecki, AIAA J. 1 (1963) 138; Smith, Bjorstad and Gropp, Domain
/// Decomposition (1996) 4.1; additivity of the inertia, Haynsworth, Linear Algebra Appl. 1 (1968) 73.
/// Tested by linalg/substructures_test (on one, two and three ranks) and Pipeline.TwoRanksGiveTheSameCurveAsOne.
#include <memory>
#include <vector>

#include "linalg/factors.hpp"

namespace soft::linalg {

class Substructures final : public Factors {
public:
    /// S takes 8 MB for 1000 shared unknowns.
    static constexpr PetscInt max_shared_unknowns = 3000;

    /// Returns nullptr on one rank, and if the ranks share no unknowns or too many. `order` is the elimination order of this rank's
    /// interior; it is computed if empty, and reused otherwise (LU after LDL^T).
    [[nodiscard]] static std::unique_ptr<Substructures> create(Mat K, Symmetry symmetry, std::vector<PetscInt>& order);
    ~Substructures() override;

    [[nodiscard]] bool factorize(Mat K) override;
    [[nodiscard]] std::optional<PetscInt> negative_pivots() const override;
    [[nodiscard]] std::optional<bool> determinant_is_negative() const override;
    void solve(Vec b, Vec x) override;

private:
    struct Parts;
    explicit Substructures(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::linalg
