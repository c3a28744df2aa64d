/// Curves of a motion in time: an oscillator x = sin(w t) with m = 1 kg and stiffness w^2, whose energies are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "path_samples.hpp"
#include "post/interpolate.hpp"
#include "post/plot.hpp"
#include "post/request.hpp"

namespace soft::post {
namespace {

constexpr double omega_1_s = 2 * std::numbers::pi;  // a period of 1 s
constexpr double amplitude_m = 0.01;

model::Case oscillator() {
    auto model = test::sample_case({"lift"}, test::Loaded::face);
    model.dynamics = model::Dynamics{.duration_s = 2};
    return model;
}

/// Rows every `step_s`, with a pressure that grows by 1 Pa per second.
std::vector<model::Step> oscillation(double duration_s, double step_s) {
    std::vector<model::Step> steps;
    for (int i = 0; i * step_s <= duration_s * (1 + 1e-12); ++i) {
        const double t = i * step_s, x = amplitude_m * std::sin(omega_1_s * t),
                     v = amplitude_m * omega_1_s * std::cos(omega_1_s * t);
        model::Step step;
        step.load_factor = t / duration_s;
        step.pressure_Pa = t;
        step.tangent_pressure = 1;
        step.outputs = {x};
        step.tangent_outputs = {v};
        step.motion = {.time_s = t,
                       .kinetic_energy_J = v * v / 2,
                       .stored_energy_J = omega_1_s * omega_1_s * x * x / 2,
                       .load_work_J = 2e-3 * t,
                       .damping_work_J = 1e-3 * t};
        steps.push_back(step);
    }
    return steps;
}

TEST(MotionCurve, HasTimeFirstAndTheEnergiesBeforeTheStretches) {
    const Curve curve = make_curve(oscillator(), oscillation(1, 0.125));
    std::vector<std::string> names;
    for (const Column& column : curve.columns) names.push_back(column.name);
    EXPECT_EQ(names, (std::vector<std::string>{"step", "time_s", "pressure_kPa", "lift_mm", "kinetic_energy_mJ",
                                               "stored_energy_mJ", "load_work_mJ", "damping_work_mJ", "stretch_p99",
                                               "max_stretch", "min_J"}));
    EXPECT_EQ(curve.find("time")->values.at(4), 0.5);
    EXPECT_DOUBLE_EQ(curve.find("load_work")->values.at(4), 1.0);  // 2 mW for half a second
    EXPECT_EQ(curve.coordinate_names(), "time, pressure, lift");
}

TEST(MotionCurve, RejectsARowWithoutTime) {
    auto steps = oscillation(1, 0.25);
    steps[2].motion.reset();
    EXPECT_THROW(static_cast<void>(make_curve(oscillator(), steps)), Error);
}

/// A pressure that rises until half of the time, and a force whose rates are those of a stiff contact.
TEST(MotionPath, HasKinksWhereALoadHasAndNoRatesOfContactForces) {
    auto model = oscillator();
    model.dynamics->duration_s = 1;
    model.loads.front().time_function.time_s = 0.5;
    model.outputs.push_back({"push", "", {1, 0, 0}, model::Measure::force, "", {}, "wall"});
    auto steps = oscillation(1, 0.125);
    for (model::Step& step : steps) {
        const double t = step.motion->time_s;
        step.pressure_Pa = std::min(t, 0.5);
        step.tangent_pressure = t < 0.5 ? 1 : 0;
        step.outputs.push_back(3 * t);
        step.tangent_outputs.push_back(-1e6);
    }
    const Curve curve = make_curve(model, steps);
    EXPECT_EQ(curve.kinks, (std::vector<std::size_t>{4, 8}));
    const Path path(curve);
    for (const double t : {0.05, 0.45, 0.55, 0.95}) {
        EXPECT_NEAR(path.at(t)[test::index_of(curve, "pressure")], 1e-3 * std::min(t, 0.5), 1e-15);
        EXPECT_NEAR(path.at(t)[test::index_of(curve, "push")], 3 * t, 1e-12);
    }
}

TEST(MotionPath, IsTheCubicHermiteInterpolantInTime) {
    // The error of cubic Hermite interpolation is at most h^4 / 384 times the fourth derivative, here w^4 times the amplitude.
    for (const double h : {0.125, 0.0625}) {
        const Curve curve = make_curve(oscillator(), oscillation(2, h));
        const Path path(curve);
        const double bound = std::pow(h * omega_1_s, 4) / 384 * amplitude_m * 1e3;
        double largest = 0;
        for (int i = 0; i <= 400; ++i) {
            const double t = 2 * i / 400.0;
            const std::vector<double> row = path.at(t);
            EXPECT_NEAR(row[test::index_of(curve, "time")], t, 1e-12);
            EXPECT_NEAR(row[test::index_of(curve, "pressure")], 1e-3 * t, 1e-15);
            largest = std::max(
                largest, std::abs(row[test::index_of(curve, "lift")] - 1e3 * amplitude_m * std::sin(omega_1_s * t)));
        }
        EXPECT_LE(largest, bound * (1 + 1e-9));
        EXPECT_GE(largest, bound / 2);
    }
}

TEST(MotionPath, CanBeEvaluatedAtATimeAndAtEveryCrossing) {
    const Curve curve = make_curve(oscillator(), oscillation(2, 0.05));
    const Curve at = rows_at(curve, parse_requests("time=300ms", curve));
    ASSERT_EQ(at.row_count(), 1u);
    EXPECT_NEAR(at.find("lift")->values[0], 1e3 * amplitude_m * std::sin(0.3 * omega_1_s), 1e-9);  // 0.3 s is a row
    const Curve passages =
        rows_at(curve, parse_requests("lift=5mm", curve));  // sin = 1/2 at 1/12 and 5/12 of each period
    ASSERT_EQ(passages.row_count(), 4u);
    const double expected[] = {1 / 12.0, 5 / 12.0, 13 / 12.0, 17 / 12.0};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(passages.find("time")->values[i], expected[i], 1e-5);
    EXPECT_THROW(static_cast<void>(parse_requests("time=3mm", curve)), Error);
}

TEST(MotionPlot, ShowsTheFirstOutputOverTime) {
    const std::vector<PlotSeries> series = {{"", make_curve(oscillator(), oscillation(1, 0.1)), {}}};
    const std::string script = plot_script(series, nullptr, {.title = "swing"}, PictureFormat::svg);
    for (const char* part : {"set xlabel 'time (s)'", "set ylabel 'lift (mm)'", "title 'motion'"})
        EXPECT_NE(script.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace soft::post
