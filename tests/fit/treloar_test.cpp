/// The standard benchmark: one rubber in three modes, fitted jointly with equal weights for all 53 rows.
/// The reference values (constants, standard errors, RMSE of all rows) come from gnuplot 5.4 (`fit` with errorvariables) on the same
/// rows, with the nominal stresses of the laws written out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "samples.hpp"

namespace soft::fit {
namespace {

struct Wanted {
    double value, error;
};

void expect_fit(const char* name, const std::vector<Wanted>& wanted, double rmse_kPa, double tolerance) {
    const Fit fitted = fit(law(name), treloar());
    ASSERT_EQ(fitted.list.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(fitted.list[i].value, wanted[i].value, tolerance * std::abs(wanted[i].value)) << name << " " << i;
        EXPECT_NEAR(fitted.list[i].standard_error, wanted[i].error, 1e-2 * wanted[i].error) << name << " " << i;
    }
    EXPECT_NEAR(fitted.rmse_Pa, rmse_kPa * 1e3, 1e-5 * rmse_kPa * 1e3) << name;
    EXPECT_TRUE(fitted.stable) << name;
}

TEST(Treloar, YeohMatchesGnuplot) {
    expect_fit("yeoh", {{184.677444e3, 10.1415723e3}, {-1.46389843e3, 0.359181403e3}, {40.1942248, 3.71720546}},
               138.080487, 1e-7);
}
TEST(Treloar, GentMatchesGnuplot) { expect_fit("gent", {{274.449e3, 6.2565e3}, {84.3165, 1.42726}}, 137.682002, 1e-5); }
TEST(Treloar, ArrudaBoyceMatchesGnuplot) {
    expect_fit("arruda-boyce", {{278.710e3, 7.96773e3}, {4.62694, 0.0553508}}, 148.366155, 3e-5);
}
TEST(Treloar, ThreeTermOgdenMatchesGnuplotStartedFromOgdensConstants) {
    const Fit fitted = fit(law("ogden-3"), treloar());
    EXPECT_NEAR(fitted.rmse_Pa, 62.7303363e3, 0.1);
    // gnuplot's stopping criterion leaves errors of 1e-3 in the constants of a flat minimum
    EXPECT_NEAR(fitted.constants.at("alpha")[1], 1.89193, 2e-3);
    EXPECT_NEAR(fitted.constants.at("alpha")[2], 8.4514, 1e-2);
    EXPECT_NEAR(fitted.constants.at("mu")[1], 367.934e3, 500.0);
    EXPECT_NEAR(fitted.list[1].standard_error, 28.18e3, 0.3e3);
    EXPECT_TRUE(fitted.stable);
}
TEST(Treloar, OgdensPublishedConstantsHaveALargerError) {
    // Ogden, Proc. R. Soc. A 326 (1972) 565: 0.63, 0.0012, -0.01 MPa with 1.3, 5, -2
    Fit published = fit(law("ogden-3"), treloar());
    const auto ours = published;
    published.constants = {{"mu", {0.63e6, 0.0012e6, -0.01e6}}, {"alpha", {1.3, 5.0, -2.0}}};
    double theirs = 0, own = 0;
    for (const TestCurve& test : treloar()) {
        theirs += std::pow(prediction_rmse_Pa(published, test), 2) * static_cast<double>(test.stretch.size());
        own += std::pow(prediction_rmse_Pa(ours, test), 2) * static_cast<double>(test.stretch.size());
    }
    EXPECT_LT(own, theirs);
    EXPECT_LT(std::sqrt(theirs / 53), 0.3e6);  // they fit the data reasonably: the largest stress is 6.3 MPa
}

}  // namespace
}  // namespace soft::fit
