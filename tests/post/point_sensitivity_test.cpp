#include "post/point_sensitivity.hpp"

#include <gtest/gtest.h>

#include <array>

#include "path_samples.hpp"
#include "post/request.hpp"

namespace soft::post {
namespace {

constexpr double w = 3e-3, f = 2e9, g = 5;  // wall [m]; load p = f w u, second output v = g w u^2 [m]

/// At a fixed position along the path u changes by 0.5 m per m of wall.
struct TwoOutputs {
    model::Case model = test::sample_case({"u", "v"});
    std::vector<model::Step> steps;

    TwoOutputs() {
        model.parameters = {{"geometry.wall", "mm", 1e-3, w, 0, 0}};
        for (const double u : {0.01, 0.02, 0.03, 0.04}) {
            model::Step step;
            step.pressure_Pa = f * w * u;
            step.tangent_pressure = 7 * f * w;
            step.outputs = {u, g * w * u * u};
            step.tangent_outputs = {7, 7 * 2 * g * w * u};
            step.derivatives = {f * u + f * w * 0.5, 0.5, g * u * u + 2 * g * w * u * 0.5};
            steps.push_back(step);
        }
    }
    [[nodiscard]] double at(double u_mm, std::size_t quantity, std::size_t held) const {
        Curve curve = make_curve(model, steps);
        const SensitivityColumns columns = add_sensitivity_columns(curve, model, steps);
        const Curve row = rows_at(curve, std::array{Request{"u", u_mm / 1000}});
        std::vector<double> values;
        for (const Column& column : row.columns) values.push_back(column.values.front());
        return sensitivity_at(values, columns, {.quantity = quantity, .held = held, .parameter = 0});
    }
};

constexpr std::size_t load = 0, first = 1, second = 2;

TEST(PointSensitivity, IsTheDerivativeAtAFixedLoadOrOutput) {
    const TwoOutputs path;
    for (const double u_mm : {20.0, 30.0}) {
        const double u = u_mm / 1000;
        EXPECT_NEAR(path.at(u_mm, load, first), f * u, 1e-9 * f * u);
        EXPECT_NEAR(path.at(u_mm, second, first), g * u * u, 1e-9 * g * u * u);
        EXPECT_NEAR(path.at(u_mm, first, load), -u / w, 1e-9 * u / w);
        EXPECT_NEAR(path.at(u_mm, second, load), -g * u * u, 1e-9 * g * u * u);
        EXPECT_NEAR(path.at(u_mm, load, second), f * u / 2, 1e-9 * f * u);
        EXPECT_NEAR(path.at(u_mm, first, second), -u / (2 * w), 1e-9 * u / w);
        EXPECT_EQ(path.at(u_mm, second, second), 0);
    }
}

/// A stage in which an obstacle moves while the pressure is held: the derivatives in the rows are those at the same place of the obstacle.
TEST(PointSensitivity, WhereTheLoadIsHeldIsThatAtTheSameProgressOfTheLoads) {
    TwoOutputs path;
    for (model::Step& step : path.steps) {
        step.pressure_Pa = 5e3;
        step.tangent_pressure = 0;
        step.tangent_load_factor = 1;
        step.derivatives[load] = 0;
    }
    for (const double u_mm : {20.0, 30.0, 40.0}) {
        const double u = u_mm / 1000;
        EXPECT_NEAR(path.at(u_mm, first, load), 0.5, 1e-9);
        EXPECT_NEAR(path.at(u_mm, second, load), g * u * u + 2 * g * w * u * 0.5, 1e-9 * g * u * u);
        EXPECT_NEAR(path.at(u_mm, second, first), g * u * u, 1e-9 * g * u * u);
    }
}

TEST(PointSensitivity, IsInterpolatedBetweenTheRows) {
    const TwoOutputs path;
    EXPECT_NEAR(path.at(25, first, load), -0.025 / w, 2e-3 * 0.025 / w);
    EXPECT_NEAR(path.at(25, load, first), f * 0.025, 2e-3 * f * 0.025);
}

/// Along the stage before, the load is held: its derivatives say nothing about those of the stage that begins at its last row.
TEST(PointSensitivity, InTheFirstStepOfAStageIsThatOfThisStage) {
    TwoOutputs path;
    path.model.path.stages.resize(2);
    for (std::size_t row = 0; row < path.steps.size(); ++row) {
        model::Step& step = path.steps[row];
        step.stage = row < 2 ? 0 : 1;
        if (row >= 2) continue;
        step.pressure_Pa = path.steps[1].outputs[0] * f * w;
        step.tangent_pressure = 0;
        step.tangent_load_factor = 1;
        step.derivatives[load] = 0;
    }
    EXPECT_NEAR(path.at(25, load, first), f * 0.025, 2e-2 * f * 0.025);
    EXPECT_NEAR(path.at(25, first, load), -0.025 / w, 2e-2 * 0.025 / w);
    EXPECT_NEAR(path.at(20, first, load), 0.5, 1e-9) << "the last row of the stage before";
}

TEST(PointSensitivity, AtABifurcationIsThatBetweenTheRowsBesideIt) {
    TwoOutputs path;
    path.steps[1].derivatives = std::vector(3, model::no_derivative);
    EXPECT_NEAR(path.at(20, load, first), f * 0.02, 1e-6 * f * 0.02);
}

TEST(PointSensitivity, IsMissingWithoutDerivatives) {
    TwoOutputs path;
    path.model.parameters.clear();
    Curve curve = make_curve(path.model, path.steps);
    const std::size_t columns = curve.columns.size();
    EXPECT_EQ(add_sensitivity_columns(curve, path.model, path.steps).quantities, 0u);
    EXPECT_EQ(curve.columns.size(), columns);
}

}  // namespace
}  // namespace soft::post
