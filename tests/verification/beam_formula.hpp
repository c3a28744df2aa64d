#pragma once
/// Free vibration of a clamped-free beam of rectangular section by Timoshenko's equations with rotary inertia,
///     (E I phi')' + k G A (w' - phi) + rho I w^2 phi = 0,    (k G A (w' - phi))' + rho A w^2 w = 0,
/// k = 5/6 (S. P. Timoshenko, Phil. Mag. 41 (1921) 744; factor of the rectangle from the work of its parabolic shear stress).
namespace soft::verification {

/// For a plate in cylindrical bending (plane strain) the modulus is E' = E / (1 - nu^2), for incompressible rubber 4 G.
struct Beam {
    double length_m, height_m;
    double modulus_Pa, shear_modulus_Pa, density_kg_m3;

    /// Euler and Bernoulli's first frequency, 1.8751041^2 (E I / (rho A L^4))^(1/2) [rad/s].
    [[nodiscard]] double slender_frequency() const;
    /// Timoshenko's first frequency [rad/s], by shooting from the clamp and bisection below slender_frequency().
    [[nodiscard]] double frequency() const;
};

}  // namespace soft::verification
