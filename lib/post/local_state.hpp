#pragma once
/// Stress and strain at a point, and derived quantities. SI units.
///   sigma = P F^T / J   (small strain has one stress: sigma = P)
///   F = sum_a stretch_a n_a (x) N_a,   stretch_a^2 the eigenvalues of b = F F^T, n_a its eigenvectors
///   von Mises = sqrt(3/2 dev sigma : dev sigma),   pressure = - tr sigma / 3 (positive in compression)
/// Components refer to the coordinates of the mesh: solid and plane strain (x, y, z), section of revolution (x, r, hoop).
/// Source: Holzapfel, Nonlinear Solid Mechanics (2000), 2.6, 3.2. Tested by post/local_state_test.
#include <array>

#include "math/tensor.hpp"

namespace soft::post {

struct LocalState {
    Tensor deformation_gradient{};  ///< F of the displacement
    Tensor first_piola_Pa{};        ///< P, reference area
    Tensor cauchy_Pa{};             ///< sigma, current area
    double jacobian = 1;            ///< J = det F
    double energy_J_m3 = 0;         ///< per undeformed volume; 0 if has_energy(case) is false
};

/// Principal stretches in descending order, with their directions in the CURRENT configuration (unit vectors; the sign
/// makes the largest component positive). Equal stretches: any orthonormal vectors of their plane.
struct PrincipalStretches {
    Vector3 stretch{};
    std::array<Vector3, 3> direction{};
};
[[nodiscard]] PrincipalStretches principal_stretches(const Tensor& deformation_gradient);

[[nodiscard]] double von_mises_Pa(const Tensor& cauchy_Pa);
[[nodiscard]] double pressure_Pa(const Tensor& cauchy_Pa);

}  // namespace soft::post
