/// Derivatives of rows against exact ones of the discretised body: a curve scales with the size of the body and with its moduli.
#include "solver/sensitivities.hpp"

#include <gtest/gtest.h>

#include "bench.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

/// One-sided and central differences.
struct Change {
    double size, tolerance;
};
constexpr Change one_sided{1e-6, 1e-4}, central{1e-5, 5e-7};

void scale_size(model::Case& input, double factor) {
    for (auto& point : input.mesh.points)
        for (double& x : point) x *= factor;
    for (model::Cavity& cavity : input.cavities)
        for (auto& opening : cavity.openings) opening.area_m2 *= factor * factor;
}

void scale_moduli(model::Case& input, double factor) {
    for (model::Material& material : input.materials) {
        for (auto& [name, values] : material.constants)
            for (double& value : values) value *= factor;
        if (material.bulk_modulus_Pa) *material.bulk_modulus_Pa *= factor;
    }
}

/// Few parameters need derivatives of the state, many the adjoints of the values.
constexpr std::size_t few = 1, many = 3;

/// The path with its derivatives by a factor on something, as that many parameters.
std::vector<model::Step> path_by_factor(model::Case input, void (*scale)(model::Case&, double), double change,
                                        std::size_t parameters) {
    std::vector<std::array<model::Case, 2>> variations(parameters, {input, input});
    for (auto& variation : variations) {
        scale(variation[0], 1 - change);
        scale(variation[1], 1 + change);
        input.parameters.push_back({"factor", "", 1, 1, 1 - change, 1 + change});
    }
    fem::System system(input, PETSC_COMM_WORLD);
    Sensitivities sensitivities(system, variations);
    std::vector<model::Step> steps;
    const auto end = follow_path(system, {.step = [&](const model::Step& step, Vec) { steps.push_back(step); }},
                                 nullptr, &sensitivities);
    EXPECT_EQ(end.reason, model::StopReason::done);
    return steps;
}

double stiffness(const model::Step& step) { return step.tangent_pressure / step.tangent_outputs[0]; }
double load_at_output(const model::Step& step) { return step.derivatives[0] - stiffness(step) * step.derivatives[1]; }

model::Case sphere_with_output() {
    auto input = sphere_case(3, 6);
    input.outputs = {{"growth", "outer", {0, 1, 0}}};
    return input;
}

model::Case inflated_sphere(model::Control control) {
    auto input = sphere_with_output();
    input.path.stages[0].control = control;
    input.path.stages[0].until = {{"volume_ratio", 15.0}};  // well beyond the limit point
    return input;
}

class Controls : public testing::TestWithParam<model::Control> {};

/// p(u, s) = p(u / s, 1): at a fixed displacement dp/ds = -u dp/du.
TEST_P(Controls, BySizeAreThoseOfASimilarBody) {
    for (const auto& [change, tolerance] : {one_sided, central})
        for (const std::size_t parameters : {few, many}) {
            const auto steps = path_by_factor(inflated_sphere(GetParam()), scale_size, change, parameters);
            ASSERT_GT(steps.size(), 6u);
            for (const model::Step& step : steps)
                EXPECT_NEAR(load_at_output(step), -step.outputs[0] * stiffness(step), tolerance * sample_mu_Pa);
        }
}

/// p is proportional to the moduli at a fixed displacement, at the limit point too.
TEST_P(Controls, ByModuliAreTheLoadItself) {
    for (const auto& [change, tolerance] : {one_sided, central})
        for (const std::size_t parameters : {few, many})
            for (const model::Step& step :
                 path_by_factor(inflated_sphere(GetParam()), scale_moduli, change, parameters))
                EXPECT_NEAR(load_at_output(step), step.pressure_Pa, tolerance * sample_mu_Pa);
}

INSTANTIATE_TEST_SUITE_P(Sensitivities, Controls,
                         testing::Values(model::Control::volume, model::Control::arc_length,
                                         model::Control::automatic));

/// A second stage injects gas: the pressure is an unknown with its own equation, and the start of the stage depends on the parameter.
/// Reference: paths with the factor 1 +- 1e-4.
TEST(Sensitivities, OfAStageWithGasAreDifferencesOfPaths) {
    auto input = sphere_with_output();
    model::Stage press = input.path.stages[0];
    press.supplies = {{model::Prescription::pressure, 0.3 * sample_mu_Pa}};
    press.until.clear();
    model::Stage inject = press;
    inject.supplies = {{model::Prescription::mass, 5e-6}};
    input.path.stages = {press, inject};
    for (const auto scale : {scale_size, scale_moduli}) {
        const auto end_with = [&](double factor) {
            model::Case other = input;
            scale(other, factor);
            return run(other).steps.back();
        };
        const double h = 1e-4;
        const auto more = end_with(1 + h), less = end_with(1 - h);
        for (const std::size_t parameters : {few, many}) {
            const model::Step last = path_by_factor(input, scale, central.size, parameters).back();
            ASSERT_EQ(last.stage, 1);
            // At the end of the stage the load factor is 1, so the row moves along the path by what its load factor has moved.
            const double along = (more.pressure_Pa - less.pressure_Pa) / (2 * h) - last.derivatives[0];
            const double by_factor = last.derivatives[1] + along / stiffness(last);
            EXPECT_NEAR((more.outputs[0] - less.outputs[0]) / (2 * h), by_factor, 1e-6 * last.outputs[0]);
        }
    }
}

}  // namespace
}  // namespace soft::solver
