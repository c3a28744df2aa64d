#include "fit/separable.hpp"

#include <gtest/gtest.h>

#include "samples.hpp"

namespace soft::fit {
namespace {

Rows many_rows() {
    const auto rubber = rubber_of(law("ogden-1"), {{"mu", {1e5}}, {"alpha", {3.0}}});
    std::vector<TestCurve> tests{synthetic_test(*rubber, Mode::uniaxial, 19.0, 800),
                                 synthetic_test(*rubber, Mode::equibiaxial, 4.0, 500)};
    tests[1].weight = 2.0;
    for (std::size_t i = 0; i < tests[0].nominal_Pa.size(); ++i) tests[0].nominal_Pa[i] += i % 3 == 0 ? 5e3 : -1e3;
    return rows_of(tests, {});
}

TEST(CondensedRows, PreserveTheInnerProductsOfPartsWithinTheSearchBounds) {
    const Rows all = many_rows(), fewer = condensed(all);
    ASSERT_LT(fewer.target.size(), all.target.size() / 5);
    for (const double a : {-12.0, -2.0, 0.05, 3.0, 12.0}) {
        const auto full = part(law("ogden-1"), all, 0, a), few = part(law("ogden-1"), fewer, 0, a);
        EXPECT_NEAR(full.norm(), few.norm(), 1e-11 * full.norm()) << a;
        EXPECT_NEAR(full.dot(all.target), few.dot(fewer.target), 1e-11 * full.norm() * all.target.norm()) << a;
        const auto other = part(law("ogden-1"), all, 0, 1.3);
        EXPECT_NEAR(full.dot(other), few.dot(part(law("ogden-1"), fewer, 0, 1.3)), 1e-11 * full.norm() * other.norm())
            << a;
    }
}

}  // namespace
}  // namespace soft::fit
