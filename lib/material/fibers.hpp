#pragma once
/// Tension-only fibres in addition to any rubber with an energy. Holzapfel-Gasser-Ogden form without dispersion:
///   W = sum over families k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] where I4 = a0 . C a0 > 1, else 0,
///   a0 = cos(angle) e1 +- sin(angle) e2 in the fibre frame (e1 the axis x; e2 the hoop direction, or y).
/// Energy per undeformed volume. I4 is the full invariant (not the isochoric one), i.e. the squared fibre stretch. A single family
/// (+ only) twists a tube. Source: Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1, eqs. 63-65. Tested by material/fiber_test.
#include <cmath>

namespace soft::material {

struct Fibers {
    double angle_rad = 0;  ///< from e1, 0 to pi/2
    double k1_Pa = 0;      ///< > 0, stiffness at small strain
    double k2 = 1;         ///< > 0, exponential stiffening
    int families = 2;      ///< 2: at plus and minus the angle; 1: at plus the angle

    bool operator==(const Fibers&) const = default;
};

/// Energy of one family as a function of its squared stretch I4.
template <class T>
[[nodiscard]] T fiber_energy(const Fibers& fibers, const T& I4) {
    using std::exp;
    const T x = I4 - 1.0;
    if (!(x > 0.0)) return T(0.0);
    return 0.5 * fibers.k1_Pa / fibers.k2 * (exp(fibers.k2 * x * x) - 1.0);
}

}  // namespace soft::material
