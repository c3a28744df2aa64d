#include "sweep/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../post/path_samples.hpp"

namespace {

using namespace soft;
using namespace soft::sweep;

/// Inner stretches 1 to 2.5 of the thick sphere, beyond its limit point.
post::Curve long_sphere() {
    return post::make_curve(post::test::sample_case({"growth"}), post::test::sphere_path(31, 2.5));
}

const TraceColumn& column(const Trace& trace, const std::string& label) {
    return *std::ranges::find(trace, label, &TraceColumn::label);
}

TEST(MakeTrace, HasTheQuantitiesOfTheTableWithoutCountersAndFlags) {
    std::vector<std::string> names;
    for (const TraceColumn& each : make_trace(long_sphere(), 20)) names.push_back(each.name);
    EXPECT_EQ(names, (std::vector<std::string>{"pressure_kPa", "growth_mm", "volume_mL", "stretch_p99", "max_stretch",
                                               "min_J"}));
}

TEST(MakeTrace, KeepsTheEndsTheLimitPointAndTheShape) {
    const Trace trace = make_trace(long_sphere(), 20);
    const std::vector<double>&growth = column(trace, "growth").values, &pressure = column(trace, "pressure").values;
    ASSERT_EQ(growth.size(), 20u);
    EXPECT_EQ(growth.front(), 0);
    EXPECT_NEAR(growth.back(), 1500, 1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(growth));
    EXPECT_NEAR(*std::ranges::max_element(pressure), 0.816424e-3, 0.002e-3);
    for (std::size_t i = 0; i + 1 < growth.size(); ++i) {  // the middle of each line against the closed form
        const double middle = (growth[i] + growth[i + 1]) / 2, line = (pressure[i] + pressure[i + 1]) / 2;
        EXPECT_NEAR(line * 1000, post::test::sphere_pressure_Pa(1 + middle / 1000), 0.01) << middle;
    }
}

TEST(MakeTrace, KeepsAllPointsOfAShortCurve) {
    const Trace trace = make_trace(post::make_curve(post::test::growth, post::test::sphere_path(3, 1.2)), 100);
    EXPECT_EQ(trace.front().values.size(), 13u);
}

TEST(MakeTrace, OfASingleRowHasOnePointAndOfNoRowNone) {
    const auto path = post::test::sphere_path(3, 1.2);
    EXPECT_EQ(make_trace(post::make_curve(post::test::growth, {path.data(), 1}), 10).front().values.size(), 1u);
    EXPECT_TRUE(make_trace(post::make_curve(post::test::growth, {}), 10).empty());
}

}  // namespace
