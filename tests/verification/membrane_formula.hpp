#pragma once
/// Inflation of a circular membrane of incompressible neo-Hookean rubber, clamped at its rim: no bending stiffness, any deflection.
/// In the undeformed radius R, with principal stretches l1 (meridian, slope phi below the horizontal) and l2 = r/R:
///     dr/dR = l1 cos phi,  dz/dR = -l1 sin phi,  T1' = (T2 - T1) l1 cos phi / r,  sin phi = p r / (2 T1),
/// the last from the axial equilibrium of the part within r; tensions T1 = mu h (l1/l2 - 1/(l1 l2)^3), T2 likewise.
/// Source: J. E. Adkins and R. S. Rivlin, Phil. Trans. R. Soc. A 244 (1952) 505; W. H. Yang and W. W. Feng, J. Appl. Mech. 37
/// (1970) 1002. Runge-Kutta from the apex, the pressure by bisection. Tested by verification/formula_test against Hencky's
/// series for small strains.
namespace soft::verification {

struct Membrane {
    double radius_m, thickness_m, mu_Pa;
};

struct MembraneState {
    double pressure_Pa, deflection_m,
        mean_deflection_m;  ///< deflection of the apex; mean deflection over the undeformed area
};

/// The state with a given stretch of the apex. Valid while the slope at the rim is below a right angle.
[[nodiscard]] MembraneState membrane_at(const Membrane& membrane, double apex_stretch);

/// The state with a given mean deflection.
[[nodiscard]] MembraneState membrane_deflected(const Membrane& membrane, double mean_deflection_m);

/// Hencky's membrane, small strains and moderate slopes: deflection of the apex over the radius, q = p a/(E h). His series to
/// the eighth term; H. Hencky, Z. Math. Phys. 63 (1915) 311, coefficients as in W. B. Fichter, NASA TP 3658 (1997).
[[nodiscard]] double hencky_deflection(double q, double poisson);

}  // namespace soft::verification
