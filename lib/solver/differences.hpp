#pragma once
/// Derivatives of the residual R(x, levels) by finite differences, for users who do not want the exact tangent:
///   tangent:   K = dR/dx by one residual per colour of the unknowns. Two unknowns of one colour share no equation (Curtis, Powell
///              and Reid 1974), so that each entry is one quotient
///   jacobian:  v -> (R(x + h v) - R(x)) / h as a shell matrix
/// Every unknown has its own scale s: for a displacement the mean distance of two nodes, for a pressure the shear modulus. A
/// quotient moves no unknown by more than about 1e-7 s: rounding of R leaves an error of 1e-9 of K, the curvature of R 1e-7 of K
/// (derived here).
/// Tested by solver/differences_test.
#include <exception>

#include "fem/system.hpp"

namespace soft::solver {

class ResidualDifferences {
public:
    /// `K`: a matrix of the system; its sparsity pattern is used where `source` is finite_difference. Neither is owned. Without
    /// finite_difference tangent() must not be called.
    ResidualDifferences(fem::System& system, Mat K, model::TangentSource source);
    ResidualDifferences(const ResidualDifferences&) = delete;
    ResidualDifferences& operator=(const ResidualDifferences&) = delete;
    ~ResidualDifferences() = default;

    /// Overwrites K, the constructor's matrix, with dR/dx at x for these levels.
    void tangent(Vec x, const fem::LoadLevels& levels, Mat K);

    /// Sets the state at which jacobian() is taken; `R` is the residual there. Both are copied.
    void set_base(Vec x, const fem::LoadLevels& levels, Vec R);
    [[nodiscard]] Mat jacobian() const noexcept { return jacobian_; }

private:
    void make_scale();
    void make_colors(Mat K);
    static PetscErrorCode scaled_residual(void* unused, Vec y, Vec R, void* self);
    static PetscErrorCode multiply(Mat jacobian, Vec v, Vec product);
    void difference(Vec v, Vec product);

    fem::System& system_;
    linalg::Vector scale_, inverse_scale_;
    linalg::Vector x_, y_, base_x_, base_R_;
    fem::LoadLevels levels_, base_levels_;
    linalg::Owned<MatFDColoring, MatFDColoringDestroy> colors_;
    linalg::Matrix jacobian_;
    std::exception_ptr thrown_;  // by a residual inside a PETSc callback
};

}  // namespace soft::solver
