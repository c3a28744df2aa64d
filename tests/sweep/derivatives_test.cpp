#include "sweep/derivatives.hpp"

#include <gtest/gtest.h>

#include <array>

#include "../post/path_samples.hpp"

namespace {

using namespace soft;
using namespace soft::sweep;

constexpr double w = 3e-3, f = 2e9;  // wall [m]; load p = f w u

/// A spring with the elongation u at 10, 20 and 40 mm, ended by `until`.
struct Spring {
    model::Case model = post::test::sample_case({"elongation"});
    std::vector<model::Step> steps;
    model::PathEnd end;

    Spring() {
        model.parameters = {{"geometry.wall", "mm", 1e-3, w, 0, 0}};
        for (const double u : {0.01, 0.02, 0.04}) {
            model::Step step;
            step.pressure_Pa = f * w * u;
            step.tangent_pressure = f * w;
            step.volume_m3 = u;
            step.outputs = {u};
            step.tangent_outputs = {1};
            step.derivatives = {f * u, 0};
            steps.push_back(step);
        }
        model.path.stages.front().until = {{"elongation", 0.04}};
    }
    [[nodiscard]] post::Curve curve() const { return post::make_curve(model, steps); }
    [[nodiscard]] Outputs of(const Sweep& sweep) const { return derivatives_of(sweep, curve(), {model, steps, end}); }
};

Sweep differentiating(const std::string& rest) {
    return read_sweep("design: d\nvary: {a.b: [1]}\nsensitivity: geometry.wall\n" + rest, "s.yaml");
}

std::optional<double> value(const Outputs& outputs, const std::string& column) {
    for (const Cell& cell : outputs.cells)
        if (cell.column == column) return cell.value;
    ADD_FAILURE() << "no column " << column;
    return std::nullopt;
}

TEST(DerivativesOf, AreThoseAtTheFixedQuantityOfThePoint) {
    const Outputs outputs = Spring{}.of(differentiating("at: [elongation=20mm, pressure=120kPa]\n"));
    ASSERT_EQ(outputs.cells.size(), 2u);
    // dp/dw = f u = 40 kPa/mm; du/dw = -u/w = -20/3 mm/mm at 120 kPa, where u is 20 mm
    EXPECT_NEAR(value(outputs, "pressure_by_geometry_wall_kPa_per_mm_at_elongation_20mm").value_or(0), 40, 1e-9);
    EXPECT_NEAR(value(outputs, "elongation_by_geometry_wall_mm_per_mm_at_120kPa").value_or(0), -20.0 / 3, 1e-1);
}

TEST(DerivativesOf, AtTheEndAreThoseAtTheGoalThatEndedThePath) {
    Spring spring;
    const Sweep sweep = differentiating("at: end\noutputs: [pressure_kPa, elongation_mm]\n");
    const Outputs at_elongation = spring.of(sweep);
    EXPECT_NEAR(value(at_elongation, "pressure_by_geometry_wall_kPa_per_mm_at_end").value_or(0), 80, 1e-9);
    EXPECT_EQ(value(at_elongation, "elongation_by_geometry_wall_mm_per_mm_at_end"), 0.0);
    spring.model.path.stages.front().until.clear();
    spring.steps.back().load_factor = 1;
    const Outputs at_load = spring.of(sweep);
    EXPECT_NEAR(value(at_load, "elongation_by_geometry_wall_mm_per_mm_at_end").value_or(0), -40.0 / 3, 1e-9);
    spring.end.reason = model::StopReason::diverged;
    const Outputs early = spring.of(sweep);
    EXPECT_EQ(value(early, "pressure_by_geometry_wall_kPa_per_mm_at_end"), std::nullopt);
    EXPECT_EQ(early.missing,
              std::vector<std::string>{"sensitivity at end: the path did not end at a load or an output"});
}

TEST(DerivativesOf, AtALimitPointAreThoseOfTheLoadOnly) {
    Spring spring;
    spring.end.limit_points = {{1, 0, std::nullopt, {}}};
    const Outputs outputs = spring.of(differentiating("at: limit\n"));
    ASSERT_EQ(outputs.cells.size(), 1u);
    EXPECT_NEAR(value(outputs, "pressure_by_geometry_wall_kPa_per_mm_at_limit").value_or(0), 40, 1e-9);
    EXPECT_EQ(outputs.cells.front().label, "pressure by geometry.wall at limit");
    EXPECT_EQ(outputs.cells.front().unit, "kPa/mm");
}

TEST(DerivativesOf, AreNoneForAPathWithoutThem) {
    Spring spring;
    spring.model.parameters.clear();
    EXPECT_TRUE(spring.of(differentiating("")).cells.empty());
}

std::string derivative_refusal(const std::string& rest) {
    try {
        check_derivatives(differentiating(rest), Spring{}.curve());
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(CheckDerivatives, RejectsPointsAndOutputsWithoutDerivatives) {
    EXPECT_EQ(derivative_refusal("at: [elongation=5mm, pressure=3kPa, limit, end]\n"), "");
    EXPECT_EQ(derivative_refusal("at: volume=5mL\n").substr(0, 62),
              "s.yaml:4:5: at: there are no sensitivities at a fixed volume; ");
    EXPECT_EQ(derivative_refusal("outputs: [volume_mL]\n").substr(0, 66),
              "s.yaml:3:14: sensitivity: none of the outputs has derivatives; add");
}

TEST(SensitivityKeys, AreThoseThatTheDesignHas) {
    const std::vector<model::DesignParameter> parameters{{"geometry.wall", "mm", 1e-3, w, 0, 0},
                                                         {"material.mu", "MPa", 1e6, 1e6, 0, 0}};
    const auto keys = [&](const std::string& list) {
        return sensitivity_keys(read_sweep("design: d\nvary: {a.b: [1]}\nsensitivity: " + list + "\n", "s.yaml"),
                                parameters);
    };
    EXPECT_EQ(keys("[material.mu, geometry.pitch, geometry.wall]"), "material.mu,geometry.wall");
    EXPECT_EQ(keys("all"), "all");
    EXPECT_EQ(keys("geometry.pitch"), "");
}

}  // namespace
