#pragma once
/// Factorises one rank's part of a matrix with the Schur complement on its shared unknowns, by a sequential MUMPS instance. It calls
/// dmumps_c directly because PETSc's solves cannot stop between condensation and expansion. Internal to the module.
/// Tested by linalg/substructures_test.
#include <memory>
#include <span>
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// Factor of [K_II K_IG; K_GI 0]; entries in the block of the shared unknowns G are ignored.
class InteriorFactor {
public:
    /// G are the last `shared` rows. Only the upper triangle of a symmetric matrix is read. `order` is the result of
    /// elimination_order.
    InteriorFactor(Symmetry symmetry, const MatrixRows& rows, std::size_t shared, std::span<const PetscInt> order);
    ~InteriorFactor();

    /// Returns false if K_II is singular to working precision.
    [[nodiscard]] bool factorize(const MatrixRows& rows);
    /// - K_GI K_II^-1 K_IG, both triangles, by columns.
    [[nodiscard]] std::span<const double> schur() const { return schur_; }
    [[nodiscard]] PetscInt negative_pivots() const;      ///< of K_II
    [[nodiscard]] bool determinant_is_negative() const;  ///< of K_II
    /// `values` contains b_I, and zeros for G. Returns - K_GI K_II^-1 b_I, valid until the next call.
    [[nodiscard]] std::span<const double> condense(std::span<double> values);
    /// Call after condense() with the same `values`: writes x_I for the given x_G.
    void expand(std::span<const double> x_shared, std::span<double> values);

private:
    struct Mumps;
    void read_values(const MatrixRows& rows);
    [[nodiscard]] bool is_stored(PetscInt row, PetscInt column) const {
        return symmetry_ == Symmetry::general || column >= row;
    }

    Symmetry symmetry_;
    std::vector<double> schur_, reduced_;
    std::unique_ptr<Mumps> mumps_;
};

}  // namespace soft::linalg
