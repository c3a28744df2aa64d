#pragma once
/// Direct factors of a matrix that several ranks share, by substructures: each rank factorises what no other rank touches (its
/// interior I_r) by a MUMPS of its own, which also gives the Schur complement on the unknowns that the interior shares,
///   S = K_GG - sum_r K_GI_r K_I_rI_r^-1 K_I_rG,
/// and every rank factorises the dense S (LAPACK). A solve is one of each interior and one of S. The shared unknowns G are those
/// that couple with unknowns of a higher rank. LDL^T of a symmetric matrix, of which each rank's own rows are read, and of the
/// interiors and of S the triangle above the diagonal; LU of a general one. Interiors of a saddle point have factors as the whole
/// has: their pressures are held by their own cells. They are ordered by nested dissection (linalg/elimination_order).
/// Beside a MUMPS that all ranks share: no message while a rank factorises, a halved ordering, and the same sums in the same order
/// however messages come, so that two runs have the same digits. S grows with the ranks: for few of them, as many as keep
/// G below `max_shared_unknowns`. Source: Przemieniecki, AIAA J. 1 (1963) 138; Smith, Bjorstad and Gropp, Domain
/// Decomposition (1996) 4.1; inertia adds up (Haynsworth, Linear Algebra Appl. 1 (1968) 73).
/// Tested by linalg/substructures_test (on one, two and three ranks) and Pipeline.TwoRanksGiveTheCurveOfOne.
#include <memory>
#include <vector>

#include "linalg/factors.hpp"

namespace soft::linalg {

class Substructures final : public Factors {
public:
    /// S takes 8 MB for a thousand.
    static constexpr PetscInt max_shared_unknowns = 3000;

    /// nullptr on one rank, and where the ranks share no unknown or too many. `order` is that in which this rank's interior is
    /// eliminated: made where it is empty, so that LU after LDL^T has it already.
    [[nodiscard]] static std::unique_ptr<Substructures> of(Mat K, Symmetry symmetry, std::vector<PetscInt>& order);
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
