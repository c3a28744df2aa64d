// Tests of the references: the formulas reproduce the values of the specification and agree with each other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "beam_formula.hpp"
#include "fiber_tube_formula.hpp"
#include "inflation_formula.hpp"
#include "membrane_formula.hpp"
#include "principal_law.hpp"
#include "snapping_cap.hpp"
#include "two_phase_tube.hpp"

namespace soft::verification {
namespace {

model::Material rubber(const std::string& law, double mu_Pa, std::optional<double> kappa_Pa) {
    model::Material material;
    material.law = law;
    material.constants["mu"] = {mu_Pa};
    material.bulk_modulus_Pa = kappa_Pa;
    return material;
}

struct TableRod {
    const char* law;
    std::optional<double> kappa_Pa;
    std::array<double, 4> strain_percent;  ///< at t = 5, 10, 20, 30
};

TEST(Formula, RodOfTableOneHasTheStrainsOfTheSpecification) {
    for (const auto& rod : {TableRod{"neo-hookean", 20.69e6, {157.712, 263.201, 426.331, 563.390}},
                            TableRod{"neo-hookean", std::nullopt, {153.688, 251.674, 393.648, 503.449}},
                            TableRod{"kraken", 20.69e6, {153.658, 251.663, 393.644, 503.447}}})
        for (std::size_t i = 0; i < 4; ++i) {
            const double t = std::array{5.0, 10.0, 20.0, 30.0}[i];
            const Triple l = stretches_at(rubber(rod.law, 0.2069e6, rod.kappa_Pa), {0.25e6 * t, false}, {});
            EXPECT_NEAR(100 * (l[0] - 1), rod.strain_percent[i], 6e-4) << rod.law << ", t = " << t;
        }
}

TEST(Formula, KrakenLawMatchesItsClosedFormAndShrinksWithoutLoad) {
    const auto material = rubber("kraken", 0.2069e6, 20.69e6);
    for (const double stress : {0.0, 1.25e6, 7.5e6}) {
        const Triple l = stretches_at(material, {stress, false}, {});
        EXPECT_NEAR(l[1] * l[1], 20.69 / (20.69 * l[0] + 0.2069), 1e-12);
        EXPECT_NEAR(0.2069e6 * (l[0] * l[0] - 1 / (l[0] + 0.01)), stress, 1e-3);
    }
    EXPECT_NEAR(100 * (stretches_at(material, {0, false}, {})[0] - 1), -0.3322, 5e-5);
}

TEST(Formula, NeoHookeanModesMatchTheirClosedForms) {
    const auto material = rubber("neo-hookean", 0.1644e6, std::nullopt);
    const double u = stretches_at(material, {0.4e6, false}, {})[0];
    EXPECT_NEAR(0.1644e6 * (u * u - 1 / u), 0.4e6, 1e-3);
    const double e = stretches_at(material, {0.4e6, false}, {0.4e6, false})[0];
    EXPECT_NEAR(0.1644e6 * (e * e - std::pow(e, -4)), 0.4e6, 1e-3);
    const double p = stretches_at(material, {0.4e6, false}, {0, true})[0];
    EXPECT_NEAR(0.1644e6 * (p * p - 1 / (p * p)), 0.4e6, 1e-3);
}

ExtraStress unit_neo_hookean() { return extra_stress_of(rubber("neo-hookean", 1, std::nullopt)); }

TEST(Formula, SphereQuadratureMatchesTheClosedFormAndTheSpecification) {
    struct Point {
        double stretch, pressure;
    };
    for (const auto& [l, p] : {Point{1.25, 0.551869}, Point{1.5, 0.755433}, Point{2, 0.806927}, Point{3, 0.634507}}) {
        EXPECT_NEAR(neo_hookean_sphere_pressure_Pa(1, l, 2), p, 5e-7);
        EXPECT_NEAR(sphere_pressure_Pa(unit_neo_hookean(), l, 2), neo_hookean_sphere_pressure_Pa(1, l, 2), 1e-12);
    }
    const auto peak = [](double ratio) {
        return first_peak([&](double l) { return neo_hookean_sphere_pressure_Pa(1, l, ratio); }, 1.001, 3);
    };
    EXPECT_NEAR(peak(2).value, 0.816424, 5e-7);
    EXPECT_NEAR(peak(2).location, 1.8281, 5e-5);
    EXPECT_NEAR(peak(1.1).value, 0.118013, 5e-7);
    EXPECT_NEAR(peak(1.1).location, 1.4264, 5e-5);
}

TEST(Formula, ThinSphereConvergesToTheMembrane) {
    // A shell with t/R = 1/500 about the middle radius: its limit point differs from that of the membrane by the square of t/R.
    constexpr double t = 1.0 / 500, ratio = (1 + 0.5 * t) / (1 - 0.5 * t);
    const auto peak = first_peak([&](double l) { return neo_hookean_sphere_pressure_Pa(1, l, ratio); }, 1.001, 3);
    EXPECT_NEAR(peak.value / t, 1.239463, 5e-6);
    EXPECT_NEAR(2 * (std::pow(7.0, -1.0 / 6) - std::pow(7.0, -7.0 / 6)), 1.239463, 5e-7);
    EXPECT_NEAR(std::pow(7.0, 1.0 / 6), 1.383088, 5e-7);
}

TEST(Formula, CylindersMatchTheSpecification) {
    struct Point {
        double stretch, pressure;
    };
    for (const auto& [l, p] : {Point{1.5, 0.428228}, Point{2, 0.574054}, Point{3, 0.660417}}) {
        EXPECT_NEAR(neo_hookean_cylinder_pressure_Pa(1, l, 2), p, 5e-7);
        EXPECT_NEAR(cylinder_pressure_Pa(unit_neo_hookean(), {1, 2, 1}, l), p, 5e-7);
    }
    model::Material mooney;
    mooney.law = "mooney-rivlin";
    mooney.constants = {{"c10", {80e6}}, {"c01", {20e6}}};
    const ExtraStress extra_stress = extra_stress_of(mooney);
    const Cylinder cylinder{7, 18.625, 1};
    const double l = root_of([&](double x) { return cylinder_pressure_Pa(extra_stress, cylinder, x) - 100e6; }, 1, 2);
    const double outer = cylinder.deformed_radius_m(18.625, l);
    EXPECT_NEAR(7 * (l - 1), 3.211502, 5e-7);
    EXPECT_NEAR(outer - 18.625, 1.429062, 5e-7);
    EXPECT_NEAR(1e-6 * hoop_stress_Pa(extra_stress, l, -100e6), 231.629, 5e-4);
    EXPECT_NEAR(1e-6 * hoop_stress_Pa(extra_stress, outer / 18.625, 0), 59.357, 5e-4);
}

TEST(Formula, LongClosedTubeMatchesTheLimitPointOfTheSpecification) {
    const ExtraStress extra_stress = extra_stress_of(rubber("neo-hookean", 0.1644e6, std::nullopt));
    const auto peak =
        first_peak([&](double l) { return closed_tube(extra_stress, 7e-3, 10e-3, l).pressure_Pa; }, 1.001, 3);
    // The specification gives the location to three decimals; the pressure is stationary there, the axial stretch is not.
    EXPECT_NEAR(peak.location, 1.796, 1e-3);
    EXPECT_NEAR(1e-3 * peak.value, 43.9467, 1e-4);
    EXPECT_NEAR(1e-3 * closed_tube(extra_stress, 7e-3, 10e-3, 1.796).pressure_Pa, 43.9467, 1e-4);
    EXPECT_NEAR(closed_tube(extra_stress, 7e-3, 10e-3, 1.796).axial_stretch, 1.1778, 1e-4);
}

/// Radii 7 and 10 mm, mu 0.1644 MPa.
FiberTube fiber_tube(double angle_rad, double k1_Pa, int families) {
    return {7e-3, 10e-3, [](double) { return 0.5 * 0.1644e6; }, angle_rad, k1_Pa, 1, families};
}

TEST(Formula, FiberTubeWithoutStiffFibresEqualsTheClosedTube) {
    const ExtraStress extra_stress = extra_stress_of(rubber("neo-hookean", 0.1644e6, std::nullopt));
    for (const double hoop : {1.1, 1.4}) {
        const TubeState plain = closed_tube(extra_stress, 7e-3, 10e-3, hoop);
        const auto state = fiber_tube_state(fiber_tube(0.5, 1e-6, 1), plain.pressure_Pa);
        EXPECT_NEAR(state.hoop, hoop, 1e-9);
        EXPECT_NEAR(state.axial, plain.axial_stretch, 1e-9);
        EXPECT_NEAR(state.twist_1_m, 0, 1e-9);
    }
}

TEST(Formula, FiberTubeTwistsWithOneFamilyOnly) {
    EXPECT_NEAR(fiber_tube_state(fiber_tube(0.9, 0.5e6, 2), 30e3).twist_1_m, 0, 1e-9);
    const auto right = fiber_tube_state(fiber_tube(0.9, 0.5e6, 1), 30e3),
               left = fiber_tube_state(fiber_tube(-0.9, 0.5e6, 1), 30e3);
    EXPECT_LT(right.twist_1_m, -1);  // the helix unwinds
    EXPECT_NEAR(left.twist_1_m, -right.twist_1_m, 1e-9);
    EXPECT_NEAR(left.axial, right.axial, 1e-12);
}

/// Inextensible fibres with tan^2 = 2 carry twice as much hoop as axial load, as the pressure in a thin tube requires.
TEST(Formula, StiffFibresOfAThinTubeHaveTheMagicAngle) {
    constexpr double degree = std::numbers::pi / 180, mu_Pa = 0.1644e6, middle_m = 10e-3, t = 0.05;
    const double magic = std::atan(std::numbers::sqrt2);
    EXPECT_NEAR(magic / degree, 54.7356, 5e-5);
    double last = 1;
    for (const double ratio : {10.0, 100.0, 1000.0}) {  // k1 / mu
        FiberTube tube = fiber_tube(0, ratio * mu_Pa, 2);
        tube.inner_m = middle_m * (1 - 0.5 * t);
        tube.outer_m = middle_m * (1 + 0.5 * t);
        const double miss = (magic - neutral_angle_rad(tube, 0.2 * t * mu_Pa)) / degree;
        EXPECT_NEAR(last / miss, last == 1 ? 1 / miss : 10, 0.5) << ratio;  // proportional to the share of the rubber
        last = miss;
    }
    EXPECT_LT(std::abs(last), 2e-3);
}

constexpr GentTube balloon{1, 30, 9, 10};

TEST(Formula, MaxwellLineCutsEqualAreasFromTheCurve) {
    const auto pressure = [](double l) { return even_tube(balloon, l).pressure_Pa; };
    const auto maximum = first_peak(pressure, 1.001, 2.5);
    const auto minimum = first_peak([&](double l) { return -pressure(l); }, maximum.location + 0.1, 4);
    const auto line = coexistence(balloon, maximum.location, minimum.location);
    EXPECT_NEAR(line.thin.pressure_Pa / line.pressure_Pa, 1, 1e-9);
    EXPECT_NEAR(line.bulge.pressure_Pa / line.pressure_Pa, 1, 1e-9);
    // int p dV by Simpson's rule between equidistant stretches, with a parabola V(l) per interval
    constexpr int intervals = 200;
    double work = 0;
    EvenTube left = line.thin;
    const double h = (line.bulge.inner_stretch - line.thin.inner_stretch) / intervals;
    for (int i = 0; i < intervals; ++i) {
        const auto middle = even_tube(balloon, line.thin.inner_stretch + (i + 0.5) * h);
        const auto right = even_tube(balloon, line.thin.inner_stretch + (i + 1) * h);
        const double at_left = -3 * left.volume_m2 + 4 * middle.volume_m2 - right.volume_m2;
        const double in_middle = right.volume_m2 - left.volume_m2;
        const double at_right = left.volume_m2 - 4 * middle.volume_m2 + 3 * right.volume_m2;
        work += (left.pressure_Pa * at_left + 4 * middle.pressure_Pa * in_middle + right.pressure_Pa * at_right) / 6;
        left = right;
    }
    EXPECT_NEAR(work / (line.pressure_Pa * (line.bulge.volume_m2 - line.thin.volume_m2)), 1, 1e-7);
}

TEST(Formula, GentTubeWithALargeLockingStretchIsNeoHookean) {
    const ExtraStress extra_stress = unit_neo_hookean();
    for (const double l : {1.2, 1.8, 2.5}) {
        const auto even = even_tube({1, 1e9, 7, 10}, l);
        EXPECT_NEAR(even.pressure_Pa, closed_tube(extra_stress, 7, 10, l).pressure_Pa, 1e-7);
        EXPECT_NEAR(even.axial_stretch, closed_tube(extra_stress, 7, 10, l).axial_stretch, 1e-7);
    }
}

TEST(Formula, UnequalSpheresHaveEqualPressureAndTheGivenVolume) {
    const auto curve = [](double l) { return neo_hookean_sphere_pressure_Pa(1, l, 1.1); };
    const auto peak = first_peak(curve, 1.001, 3);
    const auto pair = sphere_pair(curve, curve, peak.location, 5);
    EXPECT_NEAR(curve(pair.small_stretch), curve(pair.large_stretch), 1e-12);
    EXPECT_NEAR(std::pow(pair.small_stretch, 3) + std::pow(pair.large_stretch, 3), 10, 1e-12);
    EXPECT_GT(pair.large_stretch, peak.location);
    EXPECT_LT(pair.small_stretch, peak.location);
}

// A cap with a small angle is a plate, which is linear for small loads: w = p a^4 / (64 D), a its radius.
TEST(Formula, NearlyFlatCapMatchesTheClampedPlate) {
    const Cap plate{1e4, 1, 2e-3, 1, 0.3};  // a = 20, rise 0.02 thicknesses
    const double stiffness = 1 / (12 * (1 - 0.09)), a = 20, sink = 1e-3;
    EXPECT_NEAR(cap_path(plate, sink, 1).back().pressure_Pa / (64 * stiffness * sink / std::pow(a, 4)), 1, 2e-3);
}

// For shallow caps p/p_classical depends on lambda only, not on the thickness or the number of steps.
TEST(Formula, SnapPressuresOfShallowCapsDependOnLambdaAlone) {
    const auto relative = [](double thickness_m, int states) {
        Cap cap{1, thickness_m, 1, 2, 1.0 / 3};
        cap.angle = 4 / cap.shallowness();
        const auto snap = snap_pressures(cap, states);
        return std::array{snap.upper.pressure_Pa / cap.classical_pressure_Pa(),
                          snap.lower.pressure_Pa / cap.classical_pressure_Pa()};
    };
    const auto thin = relative(1e-4, 100), thinner = relative(1e-5, 100), finer = relative(1e-4, 200);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(thin[i] / thinner[i], 1, 1e-3);
        EXPECT_NEAR(thin[i] / finer[i], 1, 1e-4);
    }
}

// To first order in (h/L)^2, shear and rotary inertia reduce the frequency, by Rayleigh's quotient with the mode w of the slender beam,
// M = E'I w'' and Q = E'I w''' (derived here; L = 1, r^2 = h^2 / 12):
//     dw/w = -r^2/2 (int w'^2 / int w^2 + E'/(k G) int w'''^2 / int w''^2)
TEST(Formula, TimoshenkoBeamConvergesToTheSlenderBeamAtTheFirstOrderRate) {
    constexpr double k = 1.875104068711961;
    const double c = (std::sinh(k) - std::sin(k)) / (std::cosh(k) + std::cos(k));  // constant of the clamped-free mode
    const auto square_of = [&](int slope) {
        const double sign = slope < 2 ? -1.0 : 1.0;  // cos and sin change sign after two derivatives
        const auto square = [&](double x) {
            const double z = k * x;
            const double w = slope % 2 == 0
                                 ? std::cosh(z) + sign * std::cos(z) - c * (std::sinh(z) + sign * std::sin(z))
                                 : std::sinh(z) - sign * std::sin(z) - c * (std::cosh(z) + sign * std::cos(z));
            return std::pow(k, 2 * slope) * w * w;
        };
        return integral(square, 0.0, 1.0);
    };
    const double taken = 0.5 / 12.0 * (square_of(1) / square_of(0) + 4.0 * 1.2 * square_of(3) / square_of(2));
    for (const double height : {0.02, 0.01}) {
        const Beam beam{1.0, height, 4.0, 1.0, 1.0};
        const double lost = 1.0 - beam.frequency() / beam.slender_frequency();
        EXPECT_NEAR(lost / (taken * height * height), 1.0, 20 * height * height) << height;
    }
}

// For strains of 1e-4 the differences are of first order in the strain.
TEST(Formula, MembraneWithSmallStrainsMatchesHencky) {
    EXPECT_NEAR(hencky_deflection(1.0, 0.3), 0.6536, 1e-4);  // his constant, after Fichter 0.653
    for (const double stretch : {1.00005, 1.0002}) {
        const MembraneState state = membrane_at({0.05, 1e-3, 2e5}, stretch);
        const double q = state.pressure_Pa * 0.05 / (3 * 2e5 * 1e-3);
        EXPECT_NEAR(state.deflection_m / 0.05 / hencky_deflection(q, 0.5), 1, 2 * (stretch - 1));
    }
}

}  // namespace
}  // namespace soft::verification
