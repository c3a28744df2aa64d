#pragma once
/// Homogeneous states of an isotropic rubber: the stress at a given stretch of the tests that rubber is characterised by.
///   uniaxial      F = diag(l, t, t)    sides free: sigma_22 = sigma_33 = 0
///   equibiaxial   F = diag(l, l, t)    sigma_33 = 0
///   planar        F = diag(l, 1, t)    sigma_33 = 0 ("pure shear": the width is held)
///   simple_shear  F = I + g e1 (x) e2  whole F given; an incompressible rubber has sigma_33 = 0
/// An incompressible rubber has t from Theta = 0 and its pressure from the free side, both exact. Otherwise t is the root of
/// the lateral stress nearest to the t of no change of volume. Pa. Small strain has one stress: for linear-elastic the
/// Cauchy stress here is P, and incompressible means tr e = 0. A kraken rubber at l = 1 is not free of stress.
/// Source: Treloar, The Physics of Rubber Elasticity (1975), 4-5. Tested by material/homogeneous_test.
#include <optional>

#include "core/tensor.hpp"
#include "material/law.hpp"

namespace soft::material {

enum class Mode { uniaxial, equibiaxial, planar, simple_shear };

struct HomogeneousState {
    Tensor deformation_gradient{};
    Tensor first_piola_Pa{};     ///< P; the nominal stress of the pull is P_11 (of a shear P_12)
    Tensor cauchy_Pa{};          ///< sigma = P F^T / J; of the pull sigma_11 (of a shear sigma_12)
    double lateral_stretch = 1;  ///< t
};

/// `stretch` l > 0, or the amount of shear g. nullopt where there is no such state: no lateral equilibrium, or beyond the
/// largest stretch of the law. Throws Error (bad_input) for a rubber with fibres, whose states have less symmetry.
[[nodiscard]] std::optional<HomogeneousState> homogeneous_state(const AnyRubber& rubber, Mode mode, double stretch);

/// The stress that a test reports: sigma_11, or sigma_12 in simple shear.
[[nodiscard]] double cauchy_stress_Pa(const HomogeneousState& state, Mode mode);
[[nodiscard]] double nominal_stress_Pa(const HomogeneousState& state, Mode mode);

struct StretchRange {
    double least = 0, most = 0;
};

/// The stretch (or shear) within `range` at which the Cauchy stress is `cauchy_Pa`, by bisection to rounding; the stress
/// must grow over the range. nullopt if the range does not enclose it.
[[nodiscard]] std::optional<double> stretch_at(const AnyRubber& rubber, Mode mode, double cauchy_Pa,
                                               const StretchRange& range);

}  // namespace soft::material
