// Thick incompressible neo-Hookean sphere: closed form, in every model the family offers.
#include <gtest/gtest.h>

#include <cmath>

#include "run_design.hpp"

namespace soft::verification {
namespace {

/// p/mu at the inner stretch l_a for B/A: from p = int 2 (sigma_theta - sigma_r) dr / r with sigma differences of the
/// neo-Hookean law, [2/l + 1/(2 l^4)] at l_b minus at l_a, l_b^3 = 1 + (l_a^3 - 1) (A/B)^3.
double closed_form(double la, double ratio) {
    const double lb = std::cbrt(1.0 + (la * la * la - 1.0) / (ratio * ratio * ratio));
    const auto f = [](double l) { return 2.0 / l + 0.5 / std::pow(l, 4); };
    return f(lb) - f(la);
}

/// Largest value and its place by golden section: the limit point of the closed form.
struct Peak {
    double stretch, pressure;
};
Peak peak(double ratio) {
    double low = 1.0, high = 3.0;
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    for (int i = 0; i < 200; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (closed_form(a, ratio) < closed_form(b, ratio) ? low : high) = closed_form(a, ratio) < closed_form(b, ratio) ? a : b;
    }
    return {low, closed_form(low, ratio)};
}

constexpr double mu_Pa = 0.1644e6;

double inner_stretch(const Run& run, const solution::Step& step) {
    return std::cbrt(*step.volume_m3 / *run.steps.front().volume_m3);
}

TEST(Sphere, ClosedFormHasTheLimitPointsOfTheSpecification) {
    EXPECT_NEAR(peak(2.0).pressure, 0.816424, 1e-6);
    EXPECT_NEAR(peak(2.0).stretch, 1.8281, 1e-4);
    EXPECT_NEAR(peak(1.1).pressure, 0.118013, 1e-6);
    EXPECT_NEAR(peak(1.1).stretch, 1.4264, 1e-4);
}

TEST(Sphere, WholeCurveIsTheClosedFormOnBothSidesOfTheLimitPoint) {
    const auto run = run_design("sphere.yaml", {});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const auto& step = run.steps[i];
        EXPECT_NEAR(step.pressure_Pa / mu_Pa / closed_form(inner_stretch(run, step), 2.0), 1.0, 1e-3);
    }
    EXPECT_NEAR(inner_stretch(run, run.steps.back()), 3.0, 1e-6);
}

TEST(Sphere, LimitPointIsFoundForAThickAndAThinShell) {
    struct Shell {
        const char* outer;
        const char* size;
        double ratio;
    };
    for (const auto& [outer, size, ratio] : {Shell{"20 mm", "2.5 mm", 2.0}, Shell{"11 mm", "1 mm", 1.1}}) {
        const auto run = run_design("sphere.yaml", {std::string("geometry.outer_radius=") + outer,
                                                    std::string("mesh.size=") + size, "path.until.volume_ratio=10"});
        ASSERT_EQ(run.end.limit_points.size(), 1u) << outer;
        const auto& limit = run.end.limit_points.front();
        const auto exact = peak(ratio);
        EXPECT_NEAR(limit.pressure_Pa / mu_Pa / exact.pressure, 1.0, 1e-3) << outer;
        // The load is flat there: its place is known to the root of its accuracy.
        EXPECT_NEAR(inner_stretch(run, run.steps[limit.step]) / exact.stretch, 1.0, 1e-3) << outer;
    }
}

TEST(Sphere, SolidEighthFollowsTheClosedForm) {
    const auto run = run_design("sphere.yaml", {"model=quarter", "mesh.size=5 mm", "mesh.sectors=3",
                                                "path.until.volume_ratio=8"});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    for (std::size_t i = 1; i < run.steps.size(); ++i)
        EXPECT_NEAR(run.steps[i].pressure_Pa / mu_Pa / closed_form(inner_stretch(run, run.steps[i]), 2.0), 1.0, 5e-3);
}

TEST(Sphere, FinerMeshesConvergeToTheClosedForm) {
    const auto error = [](const char* size) {
        const auto run = run_design("sphere.yaml", {std::string("mesh.size=") + size, "path.until.volume_ratio=3.375"});
        return std::abs(run.steps.back().pressure_Pa / mu_Pa / closed_form(1.5, 2.0) - 1.0);
    };
    EXPECT_LT(error("2.5 mm"), 0.2 * error("5 mm"));   // third order or better
}

}  // namespace
}  // namespace soft::verification
