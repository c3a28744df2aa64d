// Homogeneous states compared with formulas that are derived from the energies here, and with values of the specification.
#include "material/homogeneous.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/error.hpp"
#include "material/catalogue.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

/// dW/dI1 and dW/dI2 of an incompressible rubber, derived from its energy.
struct InvariantSlopes {
    double W1 = 0, W2 = 0;
};
using SlopesOf = std::function<InvariantSlopes(double I1, double I2)>;

struct LawInInvariants {
    std::string name;
    SlopesOf slopes;
};

std::vector<LawInInvariants> laws_in_invariants() {  // constants as in samples.hpp
    return {{"neo-hookean",
             [](double, double) {
                 return InvariantSlopes{mu_Pa / 2, 0};
             }},
            {"neo-hookean-compressible",
             [](double, double) {
                 return InvariantSlopes{mu_Pa / 2, 0};
             }},
            {"mooney-rivlin",
             [](double I1, double I2) {
                 const double x = I1 - 3, y = I2 - 3;
                 return InvariantSlopes{6.4e4 + 2 * 3e3 * x - 2e3 * y, 1.8e4 - 2e3 * x + 2 * 1e3 * y};
             }},
            {"yeoh",
             [](double I1, double) {
                 const double x = I1 - 3;
                 return InvariantSlopes{8.2e4 - 2 * 4e3 * x + 3 * 5e2 * x * x + 6e4 * (1 - std::exp(-0.7 * x)), 0};
             }},
            {"gent",
             [](double I1, double) {
                 return InvariantSlopes{mu_Pa / 2 * 12.0 / (12.0 - (I1 - 3)), 0};
             }},
            {"arruda-boyce", [](double I1, double) {
                 // n k T (1/2 + I1/(10 lm^2) + 33 I1^2/(1050 lm^4) + 76 I1^3/(7000 lm^6) + 2595 I1^4/(673750 lm^8)) with
                 // n k T from mu = n k T (1 + 3/(5 lm^2) + 99/(175 lm^4) + 513/(875 lm^6) + 42039/(67375 lm^8)).
                 const double q = 1 / (2.1 * 2.1), i = I1 * q;
                 const double ratio = 1 + q * (3.0 / 5 + q * (99.0 / 175 + q * (513.0 / 875 + q * 42039.0 / 67375)));
                 const double sum = 0.5 + i * (0.1 + i * (33.0 / 1050 + i * (76.0 / 7000 + i * 2595.0 / 673750)));
                 return InvariantSlopes{mu_Pa / ratio * sum, 0};
             }}};
}

const std::array<double, 6> stretches{0.45, 0.8, 1.0, 1.2, 1.9, 2.6};

AnyRubber incompressible(std::string_view law) { return make_rubber(description_of(law, std::nullopt)); }

void expect_stress(const AnyRubber& rubber, Mode mode, double stretch, double expected_Pa) {
    const auto state = homogeneous_state(rubber, mode, stretch);
    ASSERT_TRUE(state) << info_of(rubber).name << stretch;
    const double sigma = cauchy_stress_Pa(*state, mode);
    EXPECT_NEAR(sigma, expected_Pa, 4e-12 * (mu_Pa + std::abs(expected_Pa))) << info_of(rubber).name << " " << stretch;
    if (mode != Mode::simple_shear) {
        EXPECT_NEAR(nominal_stress_Pa(*state, mode), sigma / stretch, 1e-12 * (std::abs(sigma) + mu_Pa) / stretch);
    }
    EXPECT_NEAR(state->cauchy_Pa[8], 0.0, 1e-12 * (mu_Pa + std::abs(sigma)));
}

TEST(Homogeneous, StressesOfIncompressibleLawsInInvariantsMatchTheClosedForms) {
    // Rivlin: uniaxial 2 (l^2 - 1/l)(W1 + W2/l); equibiaxial 2 (l^2 - l^-4)(W1 + l^2 W2); planar 2 (l^2 - l^-2)(W1 + W2);
    // simple shear 2 g (W1 + W2). Treloar (1975), eqs. 5.28 on.
    for (const auto& [name, slopes] : laws_in_invariants()) {
        const AnyRubber rubber = incompressible(name);
        for (const double l : stretches) {
            const double l2 = l * l;
            const auto u = slopes(l2 + 2 / l, 2 * l + 1 / l2);
            expect_stress(rubber, Mode::uniaxial, l, 2 * (l2 - 1 / l) * (u.W1 + u.W2 / l));
            const auto p = slopes(l2 + 1 + 1 / l2, l2 + 1 + 1 / l2);
            expect_stress(rubber, Mode::planar, l, 2 * (l2 - 1 / l2) * (p.W1 + p.W2));
            const double g = l - 1;
            const auto s = slopes(3 + g * g, 3 + g * g);
            expect_stress(rubber, Mode::simple_shear, g, 2 * g * (s.W1 + s.W2));
            const double I1 = 2 * l2 + 1 / (l2 * l2);
            if (name == "gent" && I1 - 3 >= 12.0) {
                EXPECT_FALSE(homogeneous_state(rubber, Mode::equibiaxial, l));
                continue;
            }
            const auto b = slopes(I1, l2 * l2 + 2 / l2);
            expect_stress(rubber, Mode::equibiaxial, l, 2 * (l2 - 1 / (l2 * l2)) * (b.W1 + l2 * b.W2));
        }
    }
}

TEST(Homogeneous, StressesOfAnIncompressibleOgdenRubberMatchTheClosedForms) {
    // sigma_a - sigma_b = sum mu_i (l_a^alpha_i - l_b^alpha_i), Ogden (1972).
    const AnyRubber rubber = incompressible("ogden");
    const auto terms = constants_of("ogden");
    const auto drop = [&](double la, double lb) {
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const double mu = terms.at("mu")[i], alpha = terms.at("alpha")[i];
            sum += mu * (std::pow(la, alpha) - std::pow(lb, alpha));
        }
        return sum;
    };
    for (const double l : stretches) {
        expect_stress(rubber, Mode::uniaxial, l, drop(l, 1 / std::sqrt(l)));
        expect_stress(rubber, Mode::equibiaxial, l, drop(l, 1 / (l * l)));
        expect_stress(rubber, Mode::planar, l, drop(l, 1 / l));
        // Simple shear has the principal stretches L and 1/L with g = L - 1/L, and the Cauchy shear stress (s1 - s2)/(L + 1/L).
        const double g = l - 1, L = 0.5 * (g + std::sqrt(g * g + 4));
        expect_stress(rubber, Mode::simple_shear, g, drop(L, 1 / L) / (L + 1 / L));
    }
}

TEST(Homogeneous, LinearElasticFollowsHookesLaw) {
    // Incompressible: E = 3 mu uniaxial, 6 mu equibiaxial, 4 mu planar. Finite K: E = 9 K mu/(3 K + mu), nu; equibiaxial
    // E/(1 - nu), planar E/(1 - nu^2).
    for (const double e : {-0.3, 0.02, 0.4}) {
        const AnyRubber rubber = incompressible("linear-elastic");
        EXPECT_NEAR(homogeneous_state(rubber, Mode::uniaxial, 1 + e)->cauchy_Pa[0], 3 * mu_Pa * e, 1e-9 * mu_Pa);
        EXPECT_NEAR(homogeneous_state(rubber, Mode::equibiaxial, 1 + e)->cauchy_Pa[0], 6 * mu_Pa * e, 1e-9 * mu_Pa);
        EXPECT_NEAR(homogeneous_state(rubber, Mode::planar, 1 + e)->cauchy_Pa[0], 4 * mu_Pa * e, 1e-9 * mu_Pa);
        EXPECT_NEAR(homogeneous_state(rubber, Mode::simple_shear, e)->cauchy_Pa[1], mu_Pa * e, 1e-9 * mu_Pa);
        const AnyRubber finite = make_rubber(description_of("linear-elastic"));
        const double E = 9 * kappa_Pa * mu_Pa / (3 * kappa_Pa + mu_Pa), nu = E / (2 * mu_Pa) - 1;
        const auto pulled = homogeneous_state(finite, Mode::uniaxial, 1 + e);
        EXPECT_NEAR(pulled->cauchy_Pa[0], E * e, 1e-9 * mu_Pa);
        EXPECT_NEAR(pulled->lateral_stretch, 1 - nu * e, 1e-13);
        EXPECT_NEAR(homogeneous_state(finite, Mode::equibiaxial, 1 + e)->cauchy_Pa[0], E / (1 - nu) * e, 1e-9 * mu_Pa);
        EXPECT_NEAR(homogeneous_state(finite, Mode::planar, 1 + e)->cauchy_Pa[0], E / (1 - nu * nu) * e, 1e-9 * mu_Pa);
    }
}

TEST(Homogeneous, SaintVenantKirchhoffFollowsHookesLawInTheGreenStrain) {
    // S_11 = E (l^2 - 1)/2, t^2 = 1 - nu (l^2 - 1), sigma = l S l/(l t^2). No state where t^2 would be negative.
    const AnyRubber rubber = make_rubber(description_of("saint-venant-kirchhoff"));
    const double E = 9 * kappa_Pa * mu_Pa / (3 * kappa_Pa + mu_Pa), nu = E / (2 * mu_Pa) - 1;
    for (const double l : {0.4, 0.7, 1.1, 1.5}) {
        const auto state = homogeneous_state(rubber, Mode::uniaxial, l);
        const double t2 = 1 - nu * (l * l - 1);
        ASSERT_TRUE(state);
        EXPECT_NEAR(state->lateral_stretch, std::sqrt(t2), 1e-13);
        EXPECT_NEAR(nominal_stress_Pa(*state, Mode::uniaxial), 0.5 * E * l * (l * l - 1), 1e-9 * mu_Pa);
        EXPECT_NEAR(cauchy_stress_Pa(*state, Mode::uniaxial), 0.5 * E * l * (l * l - 1) / t2, 1e-9 * mu_Pa);
    }
    EXPECT_FALSE(homogeneous_state(rubber, Mode::uniaxial, 1.8));
}

TEST(Homogeneous, SidesAreFreeOfStressForEveryCompressibleLaw) {
    for (const LawInfo& law : laws()) {
        if (law.fibers) continue;
        for (const auto volumetric : volumetric_laws) {
            const AnyRubber rubber = make_rubber(description_of(law.name, kappa_Pa, volumetric));
            for (const Mode mode : {Mode::uniaxial, Mode::equibiaxial, Mode::planar})
                for (const double l : {0.75, 0.95, 1.1, 1.35}) {
                    // These two laws do not depend on J and have no state at large strains.
                    const bool small_strain = law.name == "linear-elastic" || law.name == "saint-venant-kirchhoff";
                    if (small_strain && (l < 0.9 || l > 1.2)) continue;
                    const auto state = homogeneous_state(rubber, mode, l);
                    ASSERT_TRUE(state) << law.name << l;
                    EXPECT_NEAR(state->cauchy_Pa[8], 0.0, 1e-12 * kappa_Pa) << law.name;
                    if (mode == Mode::uniaxial) {
                        EXPECT_NEAR(state->cauchy_Pa[4], 0.0, 1e-12 * kappa_Pa) << law.name;
                    }
                    // For laws with a separate volumetric energy, the mean stress is K Theta dTheta/dJ.
                    const bool split = !small_strain && law.name != "kraken" && law.name != "neo-hookean-compressible";
                    if (!split) continue;
                    const auto Theta =
                        theta(volumetric, Dual<1>::variable(determinant(state->deformation_gradient), 0));
                    EXPECT_NEAR(trace(state->cauchy_Pa) / 3, kappa_Pa * Theta.v * Theta.g[0], 1e-12 * kappa_Pa)
                        << law.name;
                }
        }
    }
}

// Values of the specification: Cauchy stress 0.25 t MPa, mu 0.2069 MPa, kappa 20.69 MPa.
constexpr double paper_mu_Pa = 0.2069e6, paper_kappa_Pa = 20.69e6;

double strain_percent(std::string_view law, std::optional<double> bulk_Pa, double stress_Pa) {
    const AnyRubber rubber =
        make_rubber({.law = law, .constants = {{"mu", {paper_mu_Pa}}}, .bulk_modulus_Pa = bulk_Pa});
    double low = 0.9, high = 8.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (cauchy_stress_Pa(homogeneous_state(rubber, Mode::uniaxial, middle).value(), Mode::uniaxial) < stress_Pa
             ? low
             : high) = middle;
    }
    return 100 * (0.5 * (low + high) - 1);
}

TEST(Homogeneous, UniaxialRodWithFiniteBulkModulusMatchesTheSpecification) {
    const std::array<double, 4> time{5, 10, 20, 30}, strain{157.712, 263.201, 426.331, 563.390};
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(strain_percent("neo-hookean", paper_kappa_Pa, 0.25e6 * time[k]), strain[k], 5.01e-4);
}

TEST(Homogeneous, UniaxialRodOfIncompressibleRubberMatchesTheClosedForm) {
    const std::array<double, 4> time{5, 10, 20, 30}, strain{153.688, 251.674, 393.648, 503.449};
    for (std::size_t k = 0; k < 4; ++k) {
        const double percent = strain_percent("neo-hookean", std::nullopt, 0.25e6 * time[k]), l = 1 + percent / 100;
        EXPECT_NEAR(percent, strain[k], 5.01e-4);
        EXPECT_NEAR(paper_mu_Pa * (l * l - 1 / l), 0.25e6 * time[k], 1e-7);
    }
}

TEST(Homogeneous, UniaxialRodOfKrakenRubberMatchesTheClosedForm) {
    // t^2 = kappa/(kappa l + mu), sigma = mu (l^2 - 1/(l + mu/kappa)); without load l = t, -0.3322 %.
    const std::array<double, 4> time{5, 10, 20, 30}, strain{153.658, 251.663, 393.644, 503.447};
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(strain_percent("kraken", paper_kappa_Pa, 0.25e6 * time[k]), strain[k], 5.01e-4);
    EXPECT_NEAR(strain_percent("kraken", paper_kappa_Pa, 0.0), -0.3322, 5.01e-5);
    const AnyRubber rubber =
        make_rubber({.law = "kraken", .constants = {{"mu", {paper_mu_Pa}}}, .bulk_modulus_Pa = paper_kappa_Pa});
    for (const double l : {0.6, 1.0, 2.0, 6.0}) {
        const auto state = homogeneous_state(rubber, Mode::uniaxial, l);
        EXPECT_NEAR(state->lateral_stretch, std::sqrt(paper_kappa_Pa / (paper_kappa_Pa * l + paper_mu_Pa)), 1e-13);
        EXPECT_NEAR(state->cauchy_Pa[0], paper_mu_Pa * (l * l - 1 / (l + paper_mu_Pa / paper_kappa_Pa)),
                    1e-12 * paper_kappa_Pa);
    }
}

TEST(ArrudaBoyce, SeriesErrorMatchesTheHeaderOfTheLaw) {
    // dW/dI1 of the exact law is C lm/(6 s) beta, beta = L^-1(s/lm), L = coth b - 1/b, s = sqrt(I1/3).
    const auto inverse_langevin = [](double y) {
        double low = 1e-9, high = 1e3;
        for (int i = 0; i < 200; ++i) {
            const double b = 0.5 * (low + high);
            (1 / std::tanh(b) - 1 / b < y ? low : high) = b;
        }
        return 0.5 * (low + high);
    };
    const double lm = 2.1;
    const ArrudaBoyce law{mu_Pa, lm};
    for (const auto& [y, error] : {std::pair{0.5, 0.0007}, std::pair{0.7, 0.024}, std::pair{0.8, 0.10}}) {
        const double s = y * lm;
        const auto W = law.isochoric_energy(Invariants<Dual<1>>{Dual<1>::variable(3 * s * s, 0), 3.0});
        const double exact = law.chain_modulus_Pa() * lm / (6 * s) * inverse_langevin(y);
        EXPECT_NEAR(1 - W.g[0] / exact, error, y > 0.5 ? 5e-4 : 5e-5);  // to the digits of the header
    }
}

TEST(Homogeneous, RejectsFibres) {
    EXPECT_THROW(static_cast<void>(
                     homogeneous_state(make_rubber(description_of("holzapfel-gasser-ogden")), Mode::uniaxial, 1.1)),
                 Error);
}

}  // namespace
}  // namespace soft::material
