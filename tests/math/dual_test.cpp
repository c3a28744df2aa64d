#include "math/dual.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace soft {
namespace {

TEST(Dual, ProductAndQuotientRulesGiveExactSecondDerivatives) {
    const auto x = Dual<2>::variable(1.3, 0), y = Dual<2>::variable(0.7, 1);
    const auto product = x * x * y;  // gradient (2xy, x^2), Hessian (2y, 2x, 0)
    EXPECT_DOUBLE_EQ(product.g[0], 2 * 1.3 * 0.7);
    EXPECT_DOUBLE_EQ(product.g[1], 1.3 * 1.3);
    EXPECT_DOUBLE_EQ(product.hessian(0, 0), 2 * 0.7);
    EXPECT_DOUBLE_EQ(product.hessian(0, 1), 2 * 1.3);
    EXPECT_DOUBLE_EQ(product.hessian(1, 1), 0.0);
    const auto quotient = x / y;  // gradient (1/y, -x/y^2), Hessian (0, -1/y^2, 2x/y^3)
    EXPECT_NEAR(quotient.g[0], 1 / 0.7, 1e-15);
    EXPECT_NEAR(quotient.g[1], -1.3 / 0.49, 1e-14);
    EXPECT_NEAR(quotient.hessian(0, 1), -1 / 0.49, 1e-14);
    EXPECT_NEAR(quotient.hessian(1, 1), 2 * 1.3 / 0.343, 1e-13);
}

TEST(Dual, ElementaryFunctionsHaveTheirTextbookDerivatives) {
    const double v = 0.6;
    const auto x = Dual<1>::variable(v, 0);
    const auto expect = [](const Dual<1>& f, double f0, double f1, double f2) {
        EXPECT_NEAR(f.v, f0, 1e-15);
        EXPECT_NEAR(f.g[0], f1, 1e-14);
        EXPECT_NEAR(f.h[0], f2, 1e-13);
    };
    expect(log(x), std::log(v), 1 / v, -1 / (v * v));
    expect(log1p(x), std::log1p(v), 1 / (1 + v), -1 / ((1 + v) * (1 + v)));
    expect(exp(x), std::exp(v), std::exp(v), std::exp(v));
    expect(expm1(x), std::expm1(v), std::exp(v), std::exp(v));
    expect(sqrt(x), std::sqrt(v), 0.5 / std::sqrt(v), -0.25 / (v * std::sqrt(v)));
    expect(pow(x, 2.5), std::pow(v, 2.5), 2.5 * std::pow(v, 1.5), 3.75 * std::pow(v, 0.5));
}

}  // namespace
}  // namespace soft
