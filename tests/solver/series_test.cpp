// The path of a uniaxial pull, sigma = mu (l^2 - 1/l), by its Taylor polynomial.
#include "solver/series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "solver/stages.hpp"

namespace soft::solver {
namespace {

double stress(double l) { return l * l - 1.0 / l; }  // over mu

double stretch_at(double stress_by_mu) {
    double l = 1.0;
    for (int i = 0; i < 50; ++i) l -= (stress(l) - stress_by_mu) / (2.0 * l + 1.0 / (l * l));
    return l;
}

/// The start of a path, and the stretch over the load.
struct Start {
    explicit Start(model::Case with) : input(std::move(with)), system(input, PETSC_COMM_WORLD), corrector(system) {
        path.undeformed_volumes_m3 = undeformed_volumes_m3(system);
        set_stage(0, unloaded(input, path.undeformed_volumes_m3), corrector, path);
        system.contact().set_resting(true);
        EXPECT_FALSE(begin_stage(corrector, path, {system.make_vector(), 0.0, {}}));
    }
    [[nodiscard]] static double stretch(const PathPoint& point) { return 1.0 + point.outputs[0] / 0.01; }
    [[nodiscard]] double stress_by_mu(double load_factor) const {
        return -load_factor * path.loads->levels(1.0, {}).pressures_Pa[0] / sample_mu_Pa;
    }
    model::Case input;
    fem::System system;
    Corrector corrector;
    PathState path;
};

model::Case pull(model::Control control) {
    auto input = box_case(2, true);
    input.path.stages[0].control = control;
    input.path.stages[0].supplies = {{model::Prescription::pressure, -3.0 * sample_mu_Pa}};
    return input;
}

// With the terms of third order the distance from the path falls with the fourth power of that from the start, the error of the slope with
// the third.
TEST(Series, ThePointBehindTheStartLiesOnThePathToThirdOrder) {
    for (const auto control : {model::Control::pressure, model::Control::displacement}) {
        Start start(pull(control));
        const double first = start.path.first_step;
        std::vector<double> errors, slope_errors;
        for (const double small : {first, 0.5 * first}) {
            const auto series = series_at(start.corrector, start.path, *start.path.last, small, 10.0 * first);
            ASSERT_TRUE(series);
            const PathPoint& behind = series->behind;
            const double exact = stretch_at(start.stress_by_mu(behind.state.load_factor));
            const double slope = behind.output_slopes[0] / 0.01 / start.stress_by_mu(behind.tangent.load_factor);
            errors.push_back(std::abs(Start::stretch(behind) - exact));
            slope_errors.push_back(std::abs(slope - 1.0 / (2.0 * exact + 1.0 / (exact * exact))));
        }
        EXPECT_NEAR(errors[0] / errors[1], 16.0, 1.6);
        EXPECT_NEAR(slope_errors[0] / slope_errors[1], 8.0, 0.8);
    }
}

TEST(Series, TheFirstStepHasThePredictorErrorThatTheSettingsAskFor) {
    for (const double accuracy : {1e-4, 2e-3}) {
        auto input = pull(model::Control::pressure);
        input.solver.step_accuracy = accuracy;
        const Start start(input);
        ASSERT_TRUE(start.path.before);
        const double reach = start.path.step;
        EXPECT_GT(reach, 2.0 * input.solver.first_step);
        const PathPoint &behind = *start.path.before, &rest = *start.path.last;
        const double elongation_m = hermite(hermite_weights(behind.q, rest.q, reach), behind.outputs[0],
                                            behind.output_slopes[0], rest.outputs[0], rest.output_slopes[0]);
        const double exact = stretch_at(start.stress_by_mu(reach));
        const double error = std::abs(1.0 + elongation_m / 0.01 - exact) / (exact - 1.0);
        EXPECT_GT(error, 0.1 * accuracy);
        EXPECT_LT(error, 3.0 * accuracy);
    }
}

TEST(Series, IsNotUsedWhereThePathIsNotToBePredictedByACubic) {
    auto input = pull(model::Control::pressure);
    input.solver.steps = model::StepRule::constant;
    EXPECT_FALSE(Start(input).path.before);
    input = pull(model::Control::pressure);
    input.solver.predictor = model::Predictor::tangent;
    EXPECT_FALSE(Start(input).path.before);
}

}  // namespace
}  // namespace soft::solver
