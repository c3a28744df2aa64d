#pragma once
/// Inflation of incompressible spheres, plane-strain cylinders and long closed tubes by quadrature of the equilibrium of the wall, for any
/// law given by its extra stress l_i dW/dl_i (principal_law.hpp).
#include <functional>

#include "principal_law.hpp"

namespace soft::verification {

using ExtraStress = std::function<Triple(const Triple&)>;

/// Composite Gauss-Legendre quadrature, 64 intervals of 8 points.
[[nodiscard]] double integral(const std::function<double(double)>& f, double from, double to);

/// p [Pa] at the inner stretch l_a of a sphere of radii ratio B/A: p = int 2 (sigma_t - sigma_r) dr / r, in the stretch l
/// of a shell int 2 (sigma_t - sigma_r) dl / (l (l^3 - 1)) from l_b to l_a, l_b^3 = 1 + (l_a^3 - 1) (A/B)^3.
[[nodiscard]] double sphere_pressure_Pa(const ExtraStress& extra_stress, double inner_stretch, double ratio);

/// The same for neo-Hookean rubber in closed form: mu [2/l + 1/(2 l^4)] at l_b minus at l_a.
[[nodiscard]] double neo_hookean_sphere_pressure_Pa(double mu_Pa, double inner_stretch, double ratio);

/// Cylinder at the axial stretch lz: r^2 = a^2 + (R^2 - A^2) / lz, p = int (sigma_t - sigma_r) dr / r.
struct Cylinder {
    double inner_m, outer_m, axial_stretch;
    [[nodiscard]] double deformed_radius_m(double R_m, double inner_stretch) const;
};
[[nodiscard]] double cylinder_pressure_Pa(const ExtraStress& extra_stress, const Cylinder& cylinder,
                                          double inner_stretch);

/// A cylinder of two bonded rubbers, the first from the bore to `interface_m`: the same integral, layer by layer.
[[nodiscard]] double layered_cylinder_pressure_Pa(const ExtraStress& inside, const ExtraStress& outside,
                                                  const Cylinder& cylinder, double interface_m, double inner_stretch);

/// Neo-Hookean, plane strain, closed form: mu [ln(l_a/l_b) + (1/l_b^2 - 1/l_a^2)/2].
[[nodiscard]] double neo_hookean_cylinder_pressure_Pa(double mu_Pa, double inner_stretch, double ratio);

/// Hoop stress [Pa] at a radius of the wall with known radial stress, plane strain.
[[nodiscard]] double hoop_stress_Pa(const ExtraStress& extra_stress, double hoop_stretch, double radial_stress_Pa);

/// A long tube with closed ends: the axial stretch at which the wall carries p pi a^2, and the pressure. `max_axial_stretch` limits the
/// search for laws with a locking stretch.
struct TubeState {
    double pressure_Pa, axial_stretch;
};
[[nodiscard]] TubeState closed_tube(const ExtraStress& extra_stress, double inner_m, double outer_m,
                                    double inner_stretch, double max_axial_stretch = 3.0);

/// State of two spheres sharing one gas: one below its limit point, the other beyond it.
struct PairState {
    double small_stretch, large_stretch;  ///< of the inner walls
    double pressure_Pa;
};
/// `small`, `large`: pressure [Pa] as a function of the inner stretch; `small_limit`: stretch at the maximum of `small`; `volume_ratio`:
/// ratio of the total volume to the undeformed one (both spheres have equal undeformed volumes). Solves
/// small(a) = large((2 ratio - a^3)^(1/3)) in (1, small_limit).
[[nodiscard]] PairState sphere_pair(const std::function<double(double)>& small,
                                    const std::function<double(double)>& large, double small_limit,
                                    double volume_ratio);

/// The first maximum of a function on (low, high), bracketed by sampling and located by golden-section search.
struct Peak {
    double location, value;
};
[[nodiscard]] Peak first_peak(const std::function<double(double)>& f, double low, double high);

/// Root of an increasing function by bisection.
[[nodiscard]] double root_of(const std::function<double(double)>& f, double low, double high);

}  // namespace soft::verification
