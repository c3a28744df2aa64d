#pragma once
/// Nominal stress of an incompressible rubber in a homogeneous test, from the strain energy W of the law. Along the path of a mode,
/// F = diag(l, t(l), ...) with det F = 1, the stress P satisfies dW/dl = k P, k = 1 (uniaxial, planar) or 2 (equibiaxial: two
/// directions are stretched). W is differentiated by forward AD in one variable, which is many times faster than
/// material::homogeneous_state. fit/nominal_test compares both. Source: work conjugacy, derived here.
#include <array>

#include "material/homogeneous.hpp"
#include "material/law.hpp"
#include "math/dual.hpp"

namespace soft::fit {

/// [Pa]; NaN beyond the largest stretch of the law.
template <class L>
[[nodiscard]] double nominal_stress_Pa(const L& law, material::Mode mode, double stretch) {
    using D = Dual<1>;
    const D l = D::variable(stretch, 0);
    D second = 1.0, third = 1.0;
    double directions = 1.0;
    switch (mode) {
        case material::Mode::uniaxial: second = third = 1.0 / sqrt(l); break;
        case material::Mode::equibiaxial: second = l, third = 1.0 / (l * l), directions = 2.0; break;
        case material::Mode::planar: third = 1.0 / l; break;
        case material::Mode::simple_shear: return std::numeric_limits<double>::quiet_NaN();
    }
    D energy;
    if constexpr (material::StretchLaw<L>) {
        energy = material::energy_of_log_stretches(law, std::array<D, 3>{log(l), log(second), log(third)});
    } else {
        const D a = l * l, b = second * second, c = third * third;
        energy = law.isochoric_energy(material::Invariants<D>{a + b + c, a * b + b * c + c * a});
    }
    return energy.g[0] / directions;
}

}  // namespace soft::fit
