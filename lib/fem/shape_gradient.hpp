#pragma once
/// The derivative of psi . R by the positions of the undeformed nodes at fixed unknowns, for some vectors psi; R is the internal force
/// of the cells, without loads and contact. With the adjoint of an output for psi, its product with the motion of the nodes is what a
/// dimension contributes to the derivative of the output (solver/sensitivities.hpp), for any number of dimensions.
/// The functions and the scale of the pressure unknowns stay (solid_kernel.hpp), which no displacement and no load depends on.
/// Tested by fem/matrix_test and solver/sensitivities_test.
#include <span>
#include <vector>

#include "fem/local_state.hpp"
#include "math/vector.hpp"

namespace soft::fem {

/// False for F-bar cells, inelastic materials, and fibres whose frame depends on the position.
[[nodiscard]] bool has_shape_gradient(const Discretization& fe);

class ShapeGradient {
public:
    /// Must outlive this object.
    explicit ShapeGradient(const Discretization& fe) : fe_(fe) {}

    /// By psi and node of the mesh, at an admissible state x under these levels; the same on every rank. Collective.
    [[nodiscard]] std::vector<std::vector<Vector3>> evaluate(Vec x, const LoadLevels& levels,
                                                             std::span<const Vec> psis);

private:
    const Discretization& fe_;
    std::vector<LocalState> states_;  // x, then each psi
};

}  // namespace soft::fem
