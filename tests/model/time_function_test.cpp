/// Time functions of loads.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/time_function.hpp"
#include "time_functions.hpp"

namespace soft::model {
namespace {

constexpr double duration = 2.0;

TEST(TimeFunction, ARampEndsAfterItsTimeOrTheDuration) {
    const auto own = ramp_time_function(0.5), whole = ramp_time_function();
    EXPECT_DOUBLE_EQ(share_at(own, duration, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(share_at(own, duration, 1.5), 1.0);
    EXPECT_DOUBLE_EQ(share_rate(own, duration, 0.25), 2.0);
    EXPECT_DOUBLE_EQ(share_rate(own, duration, 0.5), 0.0);
    EXPECT_DOUBLE_EQ(share_at(whole, duration, 0.5), 0.25);
    EXPECT_EQ(kinks(own, duration), std::vector<double>{0.5});
    EXPECT_TRUE(kinks(whole, duration).empty());
    EXPECT_DOUBLE_EQ(shortest_change_s(own, duration), 0.5);
}

TEST(TimeFunction, AStepIsConstantFromTheStart) {
    const auto step = step_time_function();
    EXPECT_EQ(share_at(step, duration, 0.0), 1.0);
    EXPECT_EQ(share_at(step, duration, -1e-9), 0.0);
    EXPECT_EQ(share_rate(step, duration, 0.0), 0.0);
}

TEST(TimeFunction, ASineHasItsFrequency) {
    const auto sine = sine_time_function(3.0);
    EXPECT_NEAR(share_at(sine, duration, 1.0 / 12.0), 1.0, 1e-14);
    EXPECT_NEAR(share_at(sine, duration, 1.0 / 3.0), 0.0, 1e-14);
    EXPECT_NEAR(share_rate(sine, duration, 0.0), 6.0 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(shortest_change_s(sine, duration), 1.0 / 12.0, 1e-15);
}

TEST(TimeFunction, ATableIsLinearBetweenItsTimesAndConstantBeyond) {
    const TimeFunction table{.kind = TimeFunctionKind::table, .times_s = {0.5, 1.0, 3.0}, .shares = {1.0, 0.0, 4.0}};
    EXPECT_EQ(share_at(table, duration, 0.1), 1.0);
    EXPECT_DOUBLE_EQ(share_at(table, duration, 0.75), 0.5);
    EXPECT_DOUBLE_EQ(share_at(table, duration, 2.0), 2.0);
    EXPECT_EQ(share_at(table, duration, 5.0), 4.0);
    EXPECT_DOUBLE_EQ(share_rate(table, duration, 0.75), -2.0);
    EXPECT_EQ(share_rate(table, duration, 5.0), 0.0);
    EXPECT_EQ(kinks(table, duration), (std::vector<double>{0.5, 1.0}));
    EXPECT_DOUBLE_EQ(shortest_change_s(table, duration), 0.5);
}

}  // namespace
}  // namespace soft::model
