#pragma once
/// Homogeneous states of an isotropic rubber: the stress at a given stretch in standard material tests.
///   uniaxial      F = diag(l, t, t)    sides free: sigma_22 = sigma_33 = 0
///   equibiaxial   F = diag(l, l, t)    sigma_33 = 0
///   planar        F = diag(l, 1, t)    sigma_33 = 0 ("pure shear": the width is fixed)
///   simple_shear  F = I + g e1 (x) e2  whole F given; an incompressible rubber has sigma_33 = 0
/// For an incompressible rubber, t follows from Theta = 0 and the pressure from the stress-free side, both exactly. Otherwise t is
/// the root of the lateral stress that is nearest to the isochoric t. Stresses in Pa. At small strain there is only one stress: for
/// linear-elastic the Cauchy stress is P, and incompressible means tr e = 0. A kraken rubber has a stress at l = 1.
/// Source: Treloar, The Physics of Rubber Elasticity (1975), 4-5. Tested by material/homogeneous_test.
#include <optional>

#include "material/law.hpp"
#include "math/tensor.hpp"

namespace soft::material {

enum class Mode { uniaxial, equibiaxial, planar, simple_shear };

struct HomogeneousState {
    Tensor deformation_gradient{};
    Tensor first_piola_Pa{};     ///< P; the nominal stress is P_11 (P_12 in simple shear)
    Tensor cauchy_Pa{};          ///< sigma = P F^T / J; the true stress is sigma_11 (sigma_12 in simple shear)
    double lateral_stretch = 1;  ///< t
};

/// `stretch` is l > 0, or the amount of shear g. nullopt if there is no such state: no lateral equilibrium, or beyond the locking
/// stretch of the law. Throws Error (bad_input) for a rubber with fibres, which is not isotropic.
[[nodiscard]] std::optional<HomogeneousState> homogeneous_state(const AnyRubber& rubber, Mode mode, double stretch);

/// The measured stress component: sigma_11 and P_11, or sigma_12 and P_12 in simple shear.
[[nodiscard]] double cauchy_stress_Pa(const HomogeneousState& state, Mode mode);
[[nodiscard]] double nominal_stress_Pa(const HomogeneousState& state, Mode mode);

struct StretchRange {
    double min = 0, max = 0;
};

}  // namespace soft::material
