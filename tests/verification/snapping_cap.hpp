#pragma once
/// A thin clamped spherical cap under follower pressure: Reissner's equations of axisymmetric shells of revolution with finite rotations
/// and small strains, without transverse shear (E. Reissner, On axisymmetrical deformations of thin shells of revolution, Proc. Symp.
/// Appl. Math. 3 (1950) 27-52), solved by shooting from the apex.
#include <vector>

namespace soft::verification {

struct Cap {
    double radius_m, thickness_m, angle;  ///< of the middle surface; half opening angle [rad]
    double young_Pa, poisson;

    /// lambda = (12 (1 - nu^2))^(1/4) angle (R/t)^(1/2), the parameter of shallow caps.
    [[nodiscard]] double shallowness() const;
    /// Buckling pressure of the whole sphere, 2 E (t/R)^2 / (3 (1 - nu^2))^(1/2).
    [[nodiscard]] double classical_pressure_Pa() const;
    /// Height of the undeformed apex above the rim.
    [[nodiscard]] double height_m() const;
};

struct CapState {
    double sink_m;  ///< displacement of the apex towards the plane of the rim
    double pressure_Pa;
};

/// States from the undeformed cap to the apex displacement `last_m`, in `count` equal steps. The apex displacement must be monotonic along
/// the path. Throws std::runtime_error if Newton's method fails.
[[nodiscard]] std::vector<CapState> cap_path(const Cap& cap, double last_m, int count);

struct SnapPressures {
    CapState upper, lower;  ///< first maximum of the pressure and the minimum after it
};
/// Extrema of the path in `count` steps to twice the height, each from the parabola through three states. Throws std::runtime_error if
/// there are none.
[[nodiscard]] SnapPressures snap_pressures(const Cap& cap, int count);

}  // namespace soft::verification
