#include "post/curve.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace soft::post {
namespace {

std::vector<std::string> names(const Curve& curve) {
    std::vector<std::string> out;
    for (const Column& column : curve.columns) out.push_back(column.name);
    return out;
}

solution::Step step_with(double pressure_Pa, std::vector<double> outputs_m, std::optional<double> volume_m3) {
    solution::Step step;
    step.pressure_Pa = pressure_Pa;
    step.outputs_m = std::move(outputs_m);
    step.volume_m3 = volume_m3;
    return step;
}

TEST(Curve, HasTheColumnsOfTheContractInItsOrder) {
    const std::vector<std::string> outputs{"elongation"};
    const std::vector<solution::Step> steps{step_with(0, {0.0}, 1e-5)};
    EXPECT_EQ(names(make_curve(outputs, steps)),
              (std::vector<std::string>{"step", "pressure_kPa", "elongation_mm", "volume_mL", "stretch_p99",
                                        "max_stretch", "min_J", "stable"}));
}

TEST(Curve, LeavesOutWhatTheCaseDoesNotMeasure) {
    const std::vector<solution::Step> steps{step_with(0, {}, std::nullopt)};
    EXPECT_EQ(names(make_curve({}, steps)),
              (std::vector<std::string>{"step", "pressure_kPa", "stretch_p99", "max_stretch", "min_J", "stable"}));
}

TEST(Curve, RoundValuesInSIStayRoundInTheUnitOfTheColumn) {
    const std::vector<std::string> outputs{"elongation"};
    const std::vector<solution::Step> steps{step_with(30000, {0.13}, 1.5e-5)};
    const Curve curve = make_curve(outputs, steps);
    EXPECT_EQ(curve.find("pressure")->values[0], 30.0);
    EXPECT_EQ(curve.find("elongation")->values[0], 130.0);
    EXPECT_EQ(curve.find("volume")->values[0], 15.0);
}

TEST(Curve, RefusesAStepWithoutItsVolume) {
    const std::vector<solution::Step> steps{step_with(0, {}, 1e-5), step_with(1, {}, std::nullopt)};
    EXPECT_THROW((void)make_curve({}, steps), Error);
}

TEST(Curve, RefusesAStepWithTooFewOutputs) {
    const std::vector<std::string> outputs{"elongation", "twist"};
    const std::vector<solution::Step> steps{step_with(0, {0.0}, std::nullopt)};
    EXPECT_THROW((void)make_curve(outputs, steps), Error);
}

}  // namespace
}  // namespace soft::post
