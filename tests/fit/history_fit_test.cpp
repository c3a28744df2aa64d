// Fits to tests in time: constants of known rubbers come back, with their errors.
#include "fit/history_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "fit/given_law.hpp"

namespace soft::fit {
namespace {

/// Independent of lib/material: nominal stress of a Yeoh rubber in uniaxial tension along a history of stretches, by small steps of
/// Simo's midpoint rule.
struct Known {
    double c1 = 5e4, c2 = 3e3;
    std::vector<double> g = {0.3, 0.15}, tau = {0.6, 12};
    double r = 0, m = 1e4, beta = 0.1;  ///< r = 0: no softening

    [[nodiscard]] TestCurve test(const std::vector<std::pair<double, double>>& corners, double sample_s) const {
        TestCurve curve;
        curve.source = "known";
        std::vector<std::array<double, 2>> Q(g.size());
        std::array<double, 2> before{};
        double t = 0, l = 1, W_max = 0, next_sample = 0;
        constexpr double dt = 2e-3;
        for (const auto& [end_s, end_stretch] : corners) {
            const double start_s = t, start = l;
            while (t < end_s - 1e-9) {
                t += dt;
                l = start + (end_stretch - start) * (t - start_s) / (end_s - start_s);
                const double I1 = l * l + 2 / l, x = I1 - 3, W = c1 * x + c2 * x * x;
                W_max = std::max(W, W_max);
                const double eta = r > 0 ? 1 - std::erf((W_max - W) / (m + beta * W_max)) / r : 1;
                const double slope = 2 * eta * (c1 + 2 * c2 * x);  // S = slope (I - I1/3 C^-1)
                const std::array<double, 2> S{slope * (1 - I1 / 3 / (l * l)), slope * (1 - I1 / 3 * l)};
                std::array<double, 2> sum = S;
                for (std::size_t k = 0; k < g.size(); ++k)
                    for (std::size_t a = 0; a < 2; ++a) {
                        Q[k][a] =
                            std::exp(-dt / tau[k]) * Q[k][a] + g[k] * std::exp(-0.5 * dt / tau[k]) * (S[a] - before[a]);
                        sum[a] += Q[k][a];
                    }
                before = S;
                if (t < next_sample) continue;
                next_sample += sample_s;
                curve.time_s.push_back(t);
                curve.stretch.push_back(l);
                curve.nominal_Pa.push_back(l * sum[0] - sum[1] / (l * l));
            }
        }
        return curve;
    }
};

double value_of(const Fit& fit, const std::string& name) {
    for (const Constant& constant : fit.list)
        if (constant.name == name) return constant.value;
    for (const HistoryConstant& constant : fit.history)
        if (constant.name == name) return constant.value;
    return std::nan("");
}

double error_of(const Fit& fit, const std::string& name) {
    for (const Constant& constant : fit.list)
        if (constant.name == name) return constant.standard_error;
    for (const HistoryConstant& constant : fit.history)
        if (constant.name == name) return constant.standard_error;
    return 0;
}

TEST(HistoryFit, RelaxationAndRampsGiveTheMaxwellElements) {
    const Known known;
    const std::vector<TestCurve> tests{known.test({{0.2, 1.6}, {30, 1.6}}, 0.1), known.test({{20, 1.8}}, 0.2)};
    const Fit fit = fit_history(*find_candidate("yeoh"), tests, {2, false});
    EXPECT_NEAR(value_of(fit, "c1"), 5e4, 2e-3 * 5e4);
    EXPECT_NEAR(value_of(fit, "c2"), 3e3, 2e-2 * 3e3);
    EXPECT_NEAR(value_of(fit, "modulus 1"), 0.3, 0.01 * 0.3);
    EXPECT_NEAR(value_of(fit, "time 1"), 0.6, 0.02 * 0.6);
    EXPECT_NEAR(value_of(fit, "modulus 2"), 0.15, 0.01 * 0.15);
    EXPECT_NEAR(value_of(fit, "time 2"), 12, 0.02 * 12);
    EXPECT_GT(fit.r2, 0.99999);
    EXPECT_EQ(fit.predicted_Pa.size(), 2U);
}

TEST(HistoryFit, AGivenLawKeepsItsConstants) {
    const Known known;
    const std::vector<TestCurve> tests{known.test({{0.2, 1.6}, {30, 1.6}}, 0.1)};
    const Fit given = given_law("yeoh", {{"c1", {5e4}}, {"c2", {3e3}}, {"c3", {0}}, {"a", {0}}, {"b", {1}}});
    const Fit fit = fit_history(*find_candidate("gent"), tests, {2, false, given});
    EXPECT_EQ(fit.candidate.law, "yeoh");
    EXPECT_EQ(value_of(fit, "c1"), 5e4);
    EXPECT_EQ(value_of(fit, "c2"), 3e3);
    EXPECT_EQ(error_of(fit, "c1"), 0);
    EXPECT_NEAR(value_of(fit, "modulus 1"), 0.3, 0.01 * 0.3);
    EXPECT_NEAR(value_of(fit, "time 2"), 12, 0.02 * 12);
    EXPECT_GT(error_of(fit, "modulus 1"), 0);
    // The other constants cannot make up for a law that is not that of the test.
    const Fit stiff =
        fit_history(*find_candidate("yeoh"), tests, {2, false, given_law("neo-hookean", {{"mu", {1.1e5}}})});
    EXPECT_LT(stiff.r2, fit.r2);
    EXPECT_THROW(static_cast<void>(given_law("kraken", {})), Error);
}

TEST(HistoryFit, CyclesGiveSofteningAndRelaxationTogether) {
    Known known;
    known.r = 1.8;
    const std::vector<TestCurve> tests{known.test({{1, 1.5}, {2, 1}, {3, 1.5}, {4, 1}, {5.5, 2}, {7, 1}}, 0.05),
                                       known.test({{0.2, 1.6}, {40, 1.6}}, 0.3)};
    const Fit fit = fit_history(*find_candidate("yeoh"), tests, {2, true});
    EXPECT_GT(fit.r2, 0.9999);
    EXPECT_NEAR(value_of(fit, "r"), 1.8, 0.03 * 1.8);
    EXPECT_NEAR(value_of(fit, "m"), 1e4, 0.1 * 1e4);
    EXPECT_NEAR(value_of(fit, "c1"), 5e4, 0.02 * 5e4);
    EXPECT_NEAR(value_of(fit, "modulus 1"), 0.3, 0.05 * 0.3);
}

TEST(HistoryFit, NoiseLeavesTheConstantsWithinTheirErrors) {
    Known known;
    known.c2 = 0;
    TestCurve test = known.test({{0.2, 1.6}, {30, 1.6}}, 0.05);
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 0.01 * test.nominal_Pa.front());
    for (double& stress : test.nominal_Pa) stress += noise(random);
    const Fit fit = fit_history(*find_candidate("neo-hookean"), {test}, {2, false});
    for (const auto& [name, value] :
         {std::pair{"modulus 1", 0.3}, {"time 1", 0.6}, {"modulus 2", 0.15}, {"time 2", 12.0}}) {
        EXPECT_GT(error_of(fit, name), 0) << name;
        EXPECT_LT(std::abs(value_of(fit, name) - value), 4 * error_of(fit, name) + 0.02 * value) << name;
    }
}

TEST(HistoryFit, UnusableTestsAreRefused) {
    const Known known;
    const Candidate& yeoh = *find_candidate("yeoh");
    TestCurve ramp = known.test({{1, 1.5}}, 0.05);
    EXPECT_THROW(static_cast<void>(fit_history(yeoh, {ramp}, {0, true})), Error);  // no unloading
    TestCurve without = ramp;
    without.time_s.clear();
    EXPECT_THROW(static_cast<void>(fit_history(yeoh, {without}, {1, false})), Error);
    TestCurve stands = ramp;
    stands.time_s[3] = stands.time_s[2];
    EXPECT_THROW(static_cast<void>(fit_history(yeoh, {stands}, {1, false})), Error);
    TestCurve few = ramp;
    for (auto* list : {&few.time_s, &few.stretch, &few.nominal_Pa}) list->resize(6);
    EXPECT_THROW(static_cast<void>(fit_history(yeoh, {few}, {2, false})), Error);
}

}  // namespace
}  // namespace soft::fit
