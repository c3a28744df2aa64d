#include "fit/rank.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <random>

#include "samples.hpp"

namespace soft::fit {
namespace {

TEST(Rank, PrefersTheGeneratingLawToItsGeneralisations) {
    const auto rubber = rubber_of(law("neo-hookean"), {{"mu", {164.4e3}}});
    TestCurve test = synthetic_test(*rubber, Mode::uniaxial, 3.0, 60);
    std::mt19937 generator{3};
    std::normal_distribution<double> noise{0.0, 1e3};
    for (double& stress : test.nominal_Pa) stress += noise(generator);
    EXPECT_EQ(rank({test}).front().fit.candidate.name, "neo-hookean");
}

TEST(Rank, StableLawsComeFirst) {
    bool unstable_seen = false;
    for (const RankedFit& one : rank({sample("dragon-skin-30.csv")}, {.stability = Stability::reported})) {
        EXPECT_FALSE(unstable_seen && one.fit.stable) << one.fit.candidate.name;
        unstable_seen = unstable_seen || !one.fit.stable;
    }
    EXPECT_TRUE(unstable_seen);
}

TEST(Rank, AiccMatchesItsDefinition) {
    const std::vector<RankedFit> ranked = rank({sample("dragon-skin-20.csv")});
    for (const RankedFit& one : ranked) {
        if (one.fit.candidate.name != "yeoh") continue;
        // residuals over the largest stress, 47 rows, 3 constants and the variance
        double largest = 0;
        for (const double stress : sample("dragon-skin-20.csv").nominal_Pa) largest = std::max(largest, stress);
        const double n = 47, k = 4, mean = std::pow(one.fit.rmse_Pa / largest, 2);
        EXPECT_NEAR(one.fit.aicc, n * std::log(mean) + 2 * k + 2 * k * (k + 1) / (n - k - 1),
                    1e-8 * std::abs(one.fit.aicc));
    }
}

TEST(Rank, PredictsOmittedModesExactlyForExactData) {
    const auto rubber = rubber_of(law("gent"), {{"mu", {164e3}}, {"jm", {60.0}}});
    const std::vector<TestCurve> tests{synthetic_test(*rubber, Mode::uniaxial, 5.0),
                                       synthetic_test(*rubber, Mode::equibiaxial, 3.0)};
    for (const RankedFit& one : rank(tests)) {
        ASSERT_EQ(one.predictions.size(), 2u);
        if (one.fit.candidate.name != "gent") continue;
        for (const CrossPrediction& prediction : one.predictions) EXPECT_LT(prediction.relative, 1e-6);
    }
}

}  // namespace
}  // namespace soft::fit
