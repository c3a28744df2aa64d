#include "fit/shifted_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace {

using namespace soft;
using namespace soft::fit;

// L = [2 0; 3 1], C = L L'
const FittedLaw two{"yeoh", {{"c1", 100, true}, {"c2", 10, true}}, {4, 6, 6, 10}};

std::string refusal(const FittedLaw& fitted) {
    try {
        static_cast<void>(cholesky_factor(fitted));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(CholeskyFactor, TimesItsTransposeEqualsTheCovariance) {
    EXPECT_EQ(cholesky_factor(two), (std::vector<double>{2, 0, 3, 1}));
    // a constant at a bound has neither variance nor covariance
    EXPECT_EQ(cholesky_factor({"x", {{"a", 1}, {"b", 2}}, {0, 0, 0, 9}}), (std::vector<double>{0, 0, 0, 3}));
}

TEST(CholeskyFactor, RejectsMatricesThatAreNotACovariance) {
    EXPECT_NE(refusal({"x", {}, {}}), "");
    EXPECT_NE(refusal({"x", {{"a", 1}, {"b", 2}}, {1, 0, 1}}), "");
    EXPECT_NE(refusal({"x", {{"a", 1}, {"b", 2}}, {4, 1, 2, 4}}), "");  // not symmetric
    EXPECT_NE(refusal({"x", {{"a", 1}, {"b", 2}}, {1, 2, 2, 1}}), "");  // eigenvalue -1
    EXPECT_NE(refusal({"x", {{"a", 1}}, {-1}}), "");
    EXPECT_NE(refusal({"x", {{"a", 1}}, {std::nan("")}}), "");
    EXPECT_NE(refusal({"x", {{"a", 1}, {"b", 2}}, {0, 1, 1, 4}}), "");  // a covariance without a variance
}

TEST(ShiftedConstants, ContainTheFitAndItsShifts) {
    const auto sets = shifted_constants(two, 0);
    ASSERT_EQ(sets.size(), 5u);
    EXPECT_EQ(sets[0], (std::vector<double>{100, 10}));
    EXPECT_EQ(sets[1], (std::vector<double>{102, 13}));
    EXPECT_EQ(sets[2], (std::vector<double>{98, 7}));
    EXPECT_EQ(sets[3], (std::vector<double>{100, 11}));
    EXPECT_EQ(sets[4], (std::vector<double>{100, 9}));
}

TEST(ShiftedConstants, SamplesHaveTheCovarianceAndFewerAreAPrefix) {
    const int samples = 20000;
    const auto sets = shifted_constants(two, samples);
    const auto few = shifted_constants(two, 3);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), sets.begin()));
    double mean[2] = {}, product[3] = {};
    for (std::size_t s = 5; s < sets.size(); ++s) {
        const double a = sets[s][0] - 100, b = sets[s][1] - 10;
        mean[0] += a / samples, mean[1] += b / samples;
        product[0] += a * a / samples, product[1] += a * b / samples, product[2] += b * b / samples;
    }
    // tolerance of four standard errors: s / sqrt(n) of a mean, s^2 sqrt(2 / n) of a variance
    const double share = 4 * std::sqrt(2.0 / samples);
    EXPECT_NEAR(mean[0], 0, 4 * 2 / std::sqrt(samples));
    EXPECT_NEAR(mean[1], 0, 4 * std::sqrt(10.0 / samples));
    EXPECT_NEAR(product[0], 4, share * 4);
    EXPECT_NEAR(product[1], 6, share * std::sqrt(4 * 10));
    EXPECT_NEAR(product[2], 10, share * 10);
}

TEST(MaterialText, IsAValidMaterialOfADesign) {
    EXPECT_EQ(material_text(two, {102, 13}), "{law: yeoh, kappa: incompressible, c1: 102 Pa, c2: 13 Pa}");
    const FittedLaw ogden{
        "ogden", {{"mu 1", 1, true}, {"mu 2", 2, true}, {"alpha 1", 3, false}, {"alpha 2", 4, false}}, {}};
    EXPECT_EQ(material_text(ogden, {1, 2, 3, -4}),
              "{law: ogden, kappa: incompressible, mu: [1 Pa, 2 Pa], alpha: [3, -4]}");
}

}  // namespace
