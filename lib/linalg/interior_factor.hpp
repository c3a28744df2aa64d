#pragma once
/// Factors of one rank's part of a matrix up to the unknowns that it shares, by a MUMPS of its own (dmumps_c, as PETSc's solves
/// give no way between condensing and expanding). Internal to the module. Tested by linalg/substructures_test.
#include <memory>
#include <span>
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// [K_II K_IG; K_GI 0]: what stands in the block of the shared unknowns G is left out.
class InteriorFactor {
public:
    /// G are the last rows, `shared` of them; of a symmetric matrix the triangle above the diagonal is read. `order`: that of
    /// elimination_order.
    InteriorFactor(Symmetry symmetry, const MatrixRows& rows, std::size_t shared, std::span<const PetscInt> order);
    ~InteriorFactor();

    /// False where K_II is singular to working precision.
    [[nodiscard]] bool factorize(const MatrixRows& rows);
    /// - K_GI K_II^-1 K_IG, full, by columns.
    [[nodiscard]] std::span<const double> schur() const { return schur_; }
    [[nodiscard]] PetscInt negative_pivots() const;      ///< of K_II
    [[nodiscard]] bool determinant_is_negative() const;  ///< of K_II
    /// b_I in `values`, zeros for G; gives - K_GI K_II^-1 b_I, valid until the next call.
    [[nodiscard]] std::span<const double> condense(std::span<double> values);
    /// After condense: x_I into the same `values`, for x_G.
    void expand(std::span<const double> x_shared, std::span<double> values);

private:
    struct Mumps;
    void read_values(const MatrixRows& rows);
    [[nodiscard]] bool is_taken(PetscInt row, PetscInt column) const {
        return symmetry_ == Symmetry::general || column >= row;
    }

    Symmetry symmetry_;
    std::vector<double> schur_, reduced_;
    std::unique_ptr<Mumps> mumps_;
};

}  // namespace soft::linalg
