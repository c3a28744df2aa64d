// Drucker stability limits compared with closed forms derived here.
#include "material/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "material/catalogue.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

std::optional<double> limit(const std::vector<StabilityLimit>& limits, Mode mode, Sense sense) {
    for (const StabilityLimit& found : limits)
        if (found.mode == mode && found.sense == sense) return found.stretch;
    return std::nullopt;
}

// Mooney-Rivlin: W = sum c10 l_a^2 + c01 l_a^-2, so d tau/d e = diag(h), h_a = 4 (c10 l_a^2 + c01 l_a^-2), on sum de = 0.
AnyRubber mooney_rivlin(double c10_Pa, double c01_Pa) {
    return make_rubber({.law = "mooney-rivlin", .constants = {{"c10", {c10_Pa}}, {"c01", {c01_Pa}}}});
}

TEST(Stability, UniaxialLimitOfMooneyRivlinWithNegativeC01MatchesTheClosedForm) {
    // Uniaxial tension: the increment (0, 1, -1) has the work 2 h_2, zero where c10/l = |c01| l.
    for (const double c01 : {-2e3, -1e4, -3e4}) {
        const auto limits = stability_limits(mooney_rivlin(8e4, c01));
        const double expected = std::sqrt(8e4 / -c01);
        const auto found = limit(limits, Mode::uniaxial, Sense::tension);
        ASSERT_EQ(found.has_value(), expected < default_stretch_range.max) << expected;
        if (found) {
            EXPECT_NEAR(*found, expected, 1e-9);
        }
    }
}

TEST(Stability, EquibiaxialLimitOfMooneyRivlinWithNegativeC01MatchesTheClosedForm) {
    // Equibiaxial tension: the increment (1, 1, -2) has the work 2 h_1 + 4 h_3, zero where
    // c10/|c01| = (2 l^4 + l^-2)/(l^2 + 2 l^-4). Uniaxial compression to l^-2 is the same state.
    const double l = 1.5, ratio = (2 * std::pow(l, 4) + std::pow(l, -2)) / (l * l + 2 * std::pow(l, -4));
    const auto limits = stability_limits(mooney_rivlin(8e4, -8e4 / ratio));
    ASSERT_TRUE(limit(limits, Mode::equibiaxial, Sense::tension));
    EXPECT_NEAR(*limit(limits, Mode::equibiaxial, Sense::tension), l, 1e-9);
    ASSERT_TRUE(limit(limits, Mode::uniaxial, Sense::compression));
    EXPECT_NEAR(*limit(limits, Mode::uniaxial, Sense::compression), 1 / (l * l), 1e-9);
}

TEST(Stability, UniaxialLimitOfSaintVenantKirchhoffIsOneOverTheRootOfTwo) {
    // tau = l^2 E (l^2 - 1)/2 with free sides: d tau/d e = 0 at l = 2^-1/2 for every Poisson's ratio. The force
    // P = l E (l^2 - 1)/2 has its extremum only at 3^-1/2: the work of the Kirchhoff stress is the stricter criterion.
    for (const double bulk_Pa : {0.3e6, 3e6, 16.44e6}) {
        const auto limits = stability_limits(make_rubber(description_of("saint-venant-kirchhoff", bulk_Pa)));
        ASSERT_TRUE(limit(limits, Mode::uniaxial, Sense::compression)) << bulk_Pa;
        EXPECT_NEAR(*limit(limits, Mode::uniaxial, Sense::compression), std::sqrt(0.5), 1e-9) << bulk_Pa;
        EXPECT_FALSE(limit(limits, Mode::uniaxial, Sense::tension));
    }
}

TEST(Stability, EquibiaxialLimitOfSaintVenantKirchhoffIsDueToUnequalStretching) {
    // S = E/(1 - nu)(l^2 - 1)/2; the increment (1, -1, 0) has the work 4 l^2 S + 4 mu l^4, zero at l^2 = (1 + nu)/2, before
    // (1, 1, .) at l^2 = 1/2.
    const double E = 9 * kappa_Pa * mu_Pa / (3 * kappa_Pa + mu_Pa), nu = E / (2 * mu_Pa) - 1;
    const auto limits = stability_limits(make_rubber(description_of("saint-venant-kirchhoff")));
    ASSERT_TRUE(limit(limits, Mode::equibiaxial, Sense::compression));
    EXPECT_NEAR(*limit(limits, Mode::equibiaxial, Sense::compression), std::sqrt(0.5 * (1 + nu)), 1e-9);
}

TEST(Stability, LimitOfYeohIsTheMaximumOfTheUniaxialStress) {
    // Uniaxial tension, increment (2, -1, -1): the work is proportional to the slope of tau = 2 (l^2 - 1/l) W'(x) by ln l,
    // x = l^2 + 2/l - 3: zero where 2 (2 l^2 + 1/l) W' + 4 (l^2 - 1/l)^2 W'' = 0. Found by bisection of that formula; the
    // increment (0, 1, -1) has the work 8 W'/l, positive there.
    const double c1 = 8e4, c2 = -3e3;
    const auto slope = [&](double l) {
        const double x = l * l + 2 / l - 3, force = l * l - 1 / l;
        return 2 * (2 * l * l + 1 / l) * (c1 + 2 * c2 * x) + 4 * force * force * 2 * c2;
    };
    double low = 1, high = 5;
    for (int i = 0; i < 100; ++i) (slope(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    const auto limits = stability_limits(make_rubber({.law = "yeoh", .constants = {{"c1", {c1}}, {"c2", {c2}}}}));
    ASSERT_TRUE(limit(limits, Mode::uniaxial, Sense::tension));
    EXPECT_NEAR(*limit(limits, Mode::uniaxial, Sense::tension), low, 1e-8);
}

TEST(Stability, LawsThatAreStableEverywhereHaveNoLimit) {
    for (const char* law : {"neo-hookean", "linear-elastic", "gent", "arruda-boyce", "holzapfel-gasser-ogden"}) {
        const auto limits = stability_limits(make_rubber(description_of(law)));
        EXPECT_TRUE(limits.empty()) << law << ": " << stability_text(limits);
    }
    EXPECT_TRUE(stability_limits(mooney_rivlin(6.4e4, 1.8e4)).empty());
    const Description incompressible = description_of("neo-hookean-compressible", std::nullopt);
    EXPECT_TRUE(stability_limits(make_rubber(incompressible)).empty());
    EXPECT_TRUE(stability_limits(
                    make_rubber({.law = "ogden", .constants = {{"mu", {6.3e5, 1.2e3, -1e4}}, {"alpha", {1.3, 5, -2}}}}))
                    .empty());
}

TEST(Stability, KrakenIsStableAtTheBulkModulusOfTheReferenceWork) {
    EXPECT_TRUE(stability_limits(make_rubber(description_of("kraken", 100 * mu_Pa))).empty());
    // tau_a = J (kappa (J - 1) + mu l_a^2): under equal stretches the slope is 3 kappa J (2 J - 1) + 5 mu J l^2, so where
    // a flat specimen is compressed to J near 1/2 (only possible for a small kappa) it is volumetrically unstable.
    const auto limits = stability_limits(make_rubber(description_of("kraken", 18 * mu_Pa)));
    ASSERT_EQ(limits.size(), 1u);
    EXPECT_EQ(limits.front().mode, Mode::equibiaxial);
    EXPECT_EQ(limits.front().sense, Sense::compression);
}

TEST(Stability, OgdenHasTheLimitsOfTheEquivalentMooneyRivlin) {
    const auto one = stability_limits(mooney_rivlin(8e4, -1.3e4));
    const auto two =
        stability_limits(make_rubber({.law = "ogden", .constants = {{"mu", {1.6e5, 2.6e4}}, {"alpha", {2.0, -2.0}}}}));
    ASSERT_EQ(one.size(), two.size());
    ASSERT_FALSE(one.empty());
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k].stretch, two[k].stretch, 1e-9);
}

TEST(Stability, OgdenLimitIsExactForPowersThatSpanFortyDecades) {
    // d tau/d e = diag(h), h_a = sum mu_i alpha_i l_a^alpha_i. Equibiaxial tension, increment (1, -1, 0): the work 2 h_1 is
    // zero where A l^-10 = B l^2, at l = 8; there h_3 = A l^20 is 1e27 times either part of h_1.
    const double A = 1e5, B = A / std::pow(8.0, 12);
    const AnyRubber rubber =
        make_rubber({.law = "ogden", .constants = {{"mu", {A / -10, -B / 2}}, {"alpha", {-10, 2}}}});
    const auto limits = stability_limits(rubber, {0.3, 12.0});
    ASSERT_TRUE(limit(limits, Mode::equibiaxial, Sense::tension));
    EXPECT_NEAR(*limit(limits, Mode::equibiaxial, Sense::tension), 8.0, 1e-9);
}

TEST(Stability, OgdenWithTermsOfPositiveStiffnessIsStableAtEveryStretch) {
    for (const double alpha : {-12.0, -2.0, 2.0, 12.0}) {
        const AnyRubber rubber =
            make_rubber({.law = "ogden", .constants = {{"mu", {1e5 / alpha, 1e3, -1e3}}, {"alpha", {alpha, 5, -7}}}});
        EXPECT_TRUE(stability_limits(rubber, {0.05, 19.0}).empty()) << alpha;
    }
}

TEST(Stability, TextNamesModesAndStretches) {
    const auto limits = stability_limits(make_rubber(description_of("saint-venant-kirchhoff", 0.3e6)));
    const std::string text = stability_text(limits);
    EXPECT_NE(text.find("unstable below a stretch of uniaxial 0.707"), std::string::npos) << text;
    EXPECT_TRUE(stability_text({}).empty());
}

}  // namespace
}  // namespace soft::material
