#include "optimize/data.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "core/error.hpp"
#include "optimize/search.hpp"

namespace soft::optimize {
namespace {

post::Curve curve() {
    post::Curve curve;
    for (const auto& [quantity, unit, dimension, SI_per_unit, source] :
         {std::tuple{"pressure", "kPa", core::Dimension::pressure, 1e3, post::Source::load},
          {"elongation", "mm", core::Dimension::length, 1e-3, post::Source::output}}) {
        post::Column& column = curve.columns.emplace_back();
        column.name = std::string{quantity} + "_" + unit;
        column.quantity = quantity;
        column.unit = unit;
        column.dimension = dimension;
        column.SI_per_unit = SI_per_unit;
        column.role = post::Role::coordinate;
        column.source = source;
    }
    return curve;
}

Goal goal_with(const std::string& target) {
    return read_goal("design: a.yaml\nvary: {material.mu: {from: 1 kPa, to: 9 kPa}}\ntargets: [" + target + "]\n",
                     "goal.yaml");
}

void add(Goal& goal, const std::string& table) { add_rows(goal, 0, core::read_table(table, "m.csv"), curve()); }

TEST(Data, RowsOfACurveAreConditionsAtEqualLoad) {
    Goal goal = goal_with("{curve: m.csv, within: 2 %, weight: 4}");
    add(goal, "Pressure (bar),elongation_mm\n0,0\n0.1,5\n0.2,-20\n");
    ASSERT_EQ(goal.conditions.size(), 2u);
    const Condition& last = goal.conditions[1];
    EXPECT_EQ(last.measure.quantity, "elongation");
    EXPECT_EQ(last.measure.at, "pressure");
    EXPECT_DOUBLE_EQ(last.measure.at_SI, 20e3);
    EXPECT_EQ(last.measure.text, "elongation at pressure 20 kPa");
    EXPECT_DOUBLE_EQ(last.value_SI, -0.02);
    EXPECT_EQ(last.line, 4u);
    EXPECT_TRUE(last.is_data);
    // The standard deviation is 2 % of the largest value, halved by the weight, for all rows.
    EXPECT_DOUBLE_EQ(goal.conditions[0].allowed_SI(), 0.01 * 0.02);
    EXPECT_DOUBLE_EQ(last.allowed_SI(), 0.01 * 0.02);
    EXPECT_EQ(goal.curves[0].left_out, 1u);
    EXPECT_EQ(violation_of(last, 1), 0);
}

TEST(Data, BeyondALimitPointTheLoadIsComparedAtEqualOutput) {
    Goal goal = goal_with("{curve: m.csv}");
    add(goal, "pressure_kPa,elongation_mm\n0,0\n10,5\n9,20\n");
    ASSERT_EQ(goal.conditions.size(), 2u);
    EXPECT_EQ(goal.conditions[1].measure.text, "pressure at elongation 20 mm");
}

TEST(Data, RowsOutsideTheRangeAreLeftOut) {
    Goal goal = goal_with("{curve: m.csv, at: elongation, from: 1 mm, to: 9 mm}");
    add(goal, "pressure_kPa,elongation_mm\n0,0\n10,5\n20,20\n");
    ASSERT_EQ(goal.conditions.size(), 1u);
    EXPECT_EQ(goal.conditions[0].measure.text, "pressure at elongation 5 mm");
    EXPECT_DOUBLE_EQ(goal.conditions[0].value_SI, 10e3);
    EXPECT_EQ(goal.curves[0].left_out, 2u);
}

TEST(Data, RefusesWhatItCannotCompare) {
    const auto refusal = [](const std::string& target, const std::string& table) {
        Goal goal = goal_with(target);
        try {
            add(goal, table);
        } catch (const Error& error) {
            return std::string{error.what()};
        }
        return std::string{"accepted"};
    };
    const std::string table = "pressure_kPa,elongation_mm\n10,5\n";
    EXPECT_EQ(refusal("{curve: m.csv, at: volume}", table),
              "goal.yaml:3:19: at: 'volume' is neither the load nor an output");
    EXPECT_EQ(refusal("{curve: m.csv, from: 11 kPa}", table),
              "goal.yaml:3:19: curve: m.csv has no row in the range, or no load or output to compare");
    EXPECT_NE(refusal("{curve: m.csv, from: 11 mm}", table).find("goal.yaml:3:19: "), std::string::npos);
    EXPECT_NE(refusal("{curve: m.csv}", "pressure_kPa,width_m\n10,x\n").find("m.csv"), std::string::npos);
}

}  // namespace
}  // namespace soft::optimize
