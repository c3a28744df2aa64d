#pragma once
/// Inflation of incompressible spheres, plane-strain cylinders and long closed tubes: quadrature of the equilibrium of
/// the wall, for any law in pulls l_i dW/dl_i (principal_law.hpp).
#include <functional>

#include "principal_law.hpp"

namespace soft::verification {

using Pulls = std::function<Triple(const Triple&)>;

/// Composite Gauss-Legendre quadrature, 64 intervals of 8 points.
[[nodiscard]] double integral(const std::function<double(double)>& f, double from, double to);

/// p [Pa] at the inner stretch l_a of a sphere of radii ratio B/A: p = int 2 (sigma_t - sigma_r) dr / r, in the stretch l
/// of a shell int 2 (sigma_t - sigma_r) dl / (l (l^3 - 1)) from l_b to l_a, l_b^3 = 1 + (l_a^3 - 1) (A/B)^3.
[[nodiscard]] double sphere_pressure_Pa(const Pulls& pulls, double inner_stretch, double ratio);

/// The same for neo-Hookean rubber in closed form: mu [2/l + 1/(2 l^4)] at l_b minus at l_a.
[[nodiscard]] double neo_hookean_sphere_pressure_Pa(double mu_Pa, double inner_stretch, double ratio);

/// Cylinder at the axial stretch lz: r^2 = a^2 + (R^2 - A^2) / lz, p = int (sigma_t - sigma_r) dr / r.
struct Cylinder {
    double inner_m, outer_m, axial_stretch;
    [[nodiscard]] double deformed_radius_m(double R_m, double inner_stretch) const;
};
[[nodiscard]] double cylinder_pressure_Pa(const Pulls& pulls, const Cylinder& cylinder, double inner_stretch);

/// A cylinder of two bonded rubbers, the first from the bore to `interface_m`: the same integral, layer by layer.
[[nodiscard]] double layered_cylinder_pressure_Pa(const Pulls& inside, const Pulls& outside, const Cylinder& cylinder,
                                                  double interface_m, double inner_stretch);

/// Neo-Hookean, plane strain, closed form: mu [ln(l_a/l_b) + (1/l_b^2 - 1/l_a^2)/2].
[[nodiscard]] double neo_hookean_cylinder_pressure_Pa(double mu_Pa, double inner_stretch, double ratio);

/// Hoop stress [Pa] at a radius R of the wall in plane strain, where the radial stress is given.
[[nodiscard]] double hoop_stress_Pa(const Pulls& pulls, double hoop_stretch, double radial_stress_Pa);

/// A long tube with closed ends: the axial stretch at which the wall carries p pi a^2, and the pressure. A law that locks
/// says how far the axial stretch may be sought.
struct TubeState {
    double pressure_Pa, axial_stretch;
};
[[nodiscard]] TubeState closed_tube(const Pulls& pulls, double inner_m, double outer_m, double inner_stretch,
                                    double max_axial_stretch = 3.0);

/// The state of two spheres of one gas: one has hardly grown, the other is beyond its limit.
struct PairState {
    double small_stretch, large_stretch;  ///< of the inner walls
    double pressure_Pa;
};
/// `small`, `large`: pressure [Pa] by inner stretch; `small_limit`: stretch of the first one's maximum; `volume_ratio`: of
/// both volumes together, equal when undeformed. One root of small(a) = large((2 ratio - a^3)^(1/3)) in (1, small_limit).
[[nodiscard]] PairState sphere_pair(const std::function<double(double)>& small,
                                    const std::function<double(double)>& large, double small_limit,
                                    double volume_ratio);

/// The first maximum of a function on (low, high), sampled and then by golden section.
struct Peak {
    double place, value;
};
[[nodiscard]] Peak first_peak(const std::function<double(double)>& f, double low, double high);

/// Root of an increasing function by bisection.
[[nodiscard]] double root_of(const std::function<double(double)>& f, double low, double high);

}  // namespace soft::verification
