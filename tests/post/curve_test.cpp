#include "post/curve.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "core/error.hpp"
#include "core/table.hpp"
#include "path_samples.hpp"

namespace soft::post {
namespace {

using test::Loaded;
using test::sample_case;

std::vector<std::string> names(const Curve& curve) {
    std::vector<std::string> out;
    for (const Column& column : curve.columns) out.push_back(column.name);
    return out;
}

model::Step step_with(double pressure_Pa, std::vector<double> outputs, std::optional<double> volume_m3) {
    model::Step step;
    step.pressure_Pa = pressure_Pa;
    step.outputs = std::move(outputs);
    step.volume_m3 = volume_m3;
    return step;
}

TEST(Curve, HasTheDocumentedColumnsInOrder) {
    const std::vector<model::Step> steps{step_with(0, {0.0}, 1e-5)};
    EXPECT_EQ(names(make_curve(sample_case({"elongation"}), steps)),
              (std::vector<std::string>{"step", "pressure_kPa", "elongation_mm", "volume_mL", "stretch_p99",
                                        "max_stretch", "min_J", "stable"}));
}

TEST(Curve, OmitsQuantitiesThatTheCaseDoesNotHave) {
    const std::vector<model::Step> steps{step_with(0, {}, std::nullopt)};
    EXPECT_EQ(names(make_curve(sample_case(), steps)),
              (std::vector<std::string>{"step", "pressure_kPa", "stretch_p99", "max_stretch", "min_J", "stable"}));
}

// Beyond a pressure maximum under volume control the state is unstable at prescribed pressure, but stable at prescribed volume.
TEST(Curve, HasTheStabilityUnderControlIfEveryRowHasIt) {
    model::Step step = step_with(0, {}, std::nullopt);
    step.stable = false;
    step.stable_under_control = true;
    std::vector steps{step, step};
    const Curve curve = make_curve(sample_case(), steps);
    EXPECT_EQ(curve.columns.back().name, "stable_under_control");
    EXPECT_EQ(curve.find("stable")->values, (std::vector<double>{0, 0}));
    EXPECT_EQ(curve.find("stable_under_control")->values, (std::vector<double>{1, 1}));
    steps[1].stable_under_control.reset();
    EXPECT_EQ(make_curve(sample_case(), steps).find("stable_under_control"), nullptr);
}

TEST(Curve, NamesTheLoadColumnByTheLeadingLoad) {
    const std::vector<model::Step> steps{step_with(500, {}, std::nullopt)};
    model::Case model = sample_case({}, Loaded::nothing);
    const Curve factor = make_curve(model, steps);
    EXPECT_EQ(factor.columns[1].name, "load_factor");
    EXPECT_EQ(factor.columns[1].values[0], 500.0);
    EXPECT_EQ(factor.coordinate_names(), "load_factor");
    model.dead_loads = {{"tip", model::DeadLoadKind::traction, {1e3, 0, 0}}};
    EXPECT_EQ(make_curve(model, steps).columns[1].name, "traction_kPa");
    EXPECT_EQ(make_curve(model, steps).columns[1].values[0], 0.5);
}

TEST(Curve, HasErrorColumnsIfTheRowsHaveErrors) {
    model::Case model = sample_case({"elongation", "bend"});
    model.outputs[1].measure = model::Measure::bend;
    model::Step step = step_with(3e4, {0.01, 1}, std::nullopt);
    step.pressure_error_Pa = 30;
    step.output_errors = {2e-5, std::numbers::pi / 1800};
    std::vector steps{step, step};
    const Curve curve = make_curve(model, steps);
    EXPECT_EQ(names(curve), (std::vector<std::string>{"step", "pressure_kPa", "elongation_mm", "bend_deg",
                                                      "pressure_error_kPa", "elongation_error_mm", "bend_error_deg",
                                                      "stretch_p99", "max_stretch", "min_J", "stable"}));
    EXPECT_EQ(curve.find("pressure_error")->values[1], 0.03);
    EXPECT_EQ(curve.find("elongation_error")->values[1], 0.02);
    EXPECT_NEAR(curve.find("bend_error")->values[1], 0.1, 1e-14);
    EXPECT_EQ(curve.coordinate_names(), "pressure, elongation, bend");
    steps[1].pressure_error_Pa.reset();
    EXPECT_THROW(static_cast<void>(make_curve(model, steps)), Error);
}

TEST(Curve, HasAColumnPerNaturalFrequency) {
    model::Step step = step_with(3e4, {}, std::nullopt);
    step.frequencies_Hz = {-2, 30};
    std::vector steps{step, step};
    steps[1].frequencies_Hz = {4, 60};
    const Curve curve = make_curve(sample_case(), steps);
    EXPECT_EQ(names(curve), (std::vector<std::string>{"step", "pressure_kPa", "frequency_1_Hz", "frequency_2_Hz",
                                                      "stretch_p99", "max_stretch", "min_J", "stable"}));
    EXPECT_EQ(curve.find("frequency_1")->values, (std::vector{-2.0, 4.0}));
    EXPECT_EQ(curve.find("frequency_2")->values, (std::vector{30.0, 60.0}));
    const core::Heading heading = core::parse_heading("frequency_2_Hz");  // the table can be read back
    EXPECT_EQ(heading.quantity, "frequency_2");
    EXPECT_EQ(core::dimension_of(heading.unit), curve.find("frequency_2")->dimension);
    steps[1].frequencies_Hz.clear();
    EXPECT_THROW(static_cast<void>(make_curve(sample_case(), steps)), Error);
}

TEST(Curve, GivesEveryMeasureInItsUnit) {
    model::Case model = sample_case({"a", "b", "c", "d"});
    model.outputs[0].measure = model::Measure::force;
    model.outputs[1].measure = model::Measure::moment;
    model.outputs[2].measure = model::Measure::curvature;
    model.outputs[3].measure = model::Measure::radial;
    const Curve curve = make_curve(model, std::vector{step_with(0, {2, 3e-3, 5, 1e-3}, std::nullopt)});
    EXPECT_EQ(curve.find("a")->name, "a_N");
    EXPECT_EQ(curve.find("a")->values[0], 2);
    EXPECT_EQ(curve.find("b")->name, "b_Nmm");
    EXPECT_DOUBLE_EQ(curve.find("b")->values[0], 3);
    EXPECT_EQ(curve.find("c")->name, "c_per_m");
    EXPECT_EQ(curve.find("c")->unit, "1/m");
    EXPECT_EQ(curve.find("d")->name, "d_mm");
    // The headings can be parsed when the table is read back.
    for (const Column& column : curve.columns) {
        const core::Heading heading = core::parse_heading(column.name);
        if (column.source != Source::output) continue;
        EXPECT_EQ(heading.quantity, column.quantity);
        EXPECT_EQ(core::dimension_of(heading.unit), column.dimension) << column.name;
    }
}

TEST(Curve, ShowsEnergiesAndPositionsOnDemand) {
    model::Step step = step_with(0, {}, std::nullopt);
    step.energies = {2e-3, 2.1e-3, {}};
    step.extremes = {{0.01, 0.02, 0.03}, 5e3};
    Curve curve = make_curve(sample_case(), std::vector{step});
    const auto shown = [&] {
        std::vector<std::string> names;
        for (const Column* column : shown_columns(curve)) names.push_back(column->name);
        return names;
    };
    EXPECT_EQ(shown(),
              (std::vector<std::string>{"step", "pressure_kPa", "stretch_p99", "max_stretch", "min_J", "stable"}));
    EXPECT_EQ(curve.find("load_work")->values[0], 2.1);
    EXPECT_EQ(curve.find("max_stretch_x")->values[0], 10);
    EXPECT_EQ(curve.find("max_energy_density")->values[0], 5);
    show_also(curve, std::vector<std::string>{"stored_energy", "max_stretch_x_mm"});
    EXPECT_EQ(shown(), (std::vector<std::string>{"step", "pressure_kPa", "stretch_p99", "max_stretch", "min_J",
                                                 "stable", "stored_energy_mJ", "max_stretch_x_mm"}));
    EXPECT_THROW(show_also(curve, std::vector<std::string>{"energy"}), Error);
    step.energies.reset();  // a file without them
    step.extremes.reset();
    curve = make_curve(sample_case(), std::vector{step});
    EXPECT_EQ(curve.find("stored_energy"), nullptr);
    show_also(curve, std::vector<std::string>{"all"});
}

// The list must contain every column that a curve can have.
TEST(Columns, AreAllListedOnceWithTheirMeaning) {
    const auto all = all_columns();
    std::set<std::string> names;
    for (const Column& column : all) {
        EXPECT_TRUE(names.insert(column.name).second) << column.name;
        EXPECT_FALSE(column.meaning.empty()) << column.name;
    }
    for (const char* name : {"step",
                             "time_s",
                             "stage",
                             "pressure_kPa",
                             "traction_kPa",
                             "load_N",
                             "load_factor",
                             "<displacement>_mm",
                             "<bend>_deg",
                             "<curvature>_per_m",
                             "<force>_N",
                             "<moment>_Nmm",
                             "volume_mL",
                             "pressure_<load>_kPa",
                             "volume_<cavity>_mL",
                             "pressure_error_kPa",
                             "<bend>_error_deg",
                             "frequency_1_Hz",
                             "kinetic_energy_mJ",
                             "stored_energy_mJ",
                             "max_stretch_r_mm",
                             "max_stretch_z_mm",
                             "stretch_p99",
                             "stable"})
        EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_NE(column_text(all).find("load_work_mJ"), std::string::npos);
}

TEST(Curve, GivesAnglesInDegrees) {
    model::Case model = sample_case({"bend", "turn", "reach"});
    model.outputs[0].measure = model::Measure::bend;
    model.outputs[1].measure = model::Measure::twist;
    const std::vector<model::Step> steps{step_with(0, {std::numbers::pi / 6, -std::numbers::pi, 0.1}, std::nullopt)};
    const Curve curve = make_curve(model, steps);
    EXPECT_EQ(curve.columns[2].name, "bend_deg");
    EXPECT_NEAR(curve.columns[2].values[0], 30, 1e-13);
    EXPECT_EQ(curve.columns[3].name, "turn_deg");
    EXPECT_NEAR(curve.columns[3].values[0], -180, 1e-12);
    EXPECT_EQ(curve.columns[4].name, "reach_mm");
}

TEST(Curve, HasAColumnPerPressureAndVolumeOfACaseWithSeveral) {
    model::Case model = sample_case({"elongation"});
    model.cavities = {{"left", "a", {}, {}}, {"right", "b", {}, {}}};
    model.loads = {{"both", {"left", "right"}, true, {}}, {"outside", {"outer"}, true, {}}};
    model.path.stages.resize(2);
    model::Step step = step_with(3e4, {0.01}, 3e-6);
    step.stage = 1;
    step.pressures_Pa = {3e4, -1e3};
    step.volumes_m3 = {1e-6, 2e-6};
    step.tangent_pressures = {1, 2};
    step.tangent_volumes = {3, 4};
    const Curve curve = make_curve(model, std::vector{step});
    EXPECT_EQ(names(curve),
              (std::vector<std::string>{"step", "stage", "pressure_kPa", "elongation_mm", "volume_mL",
                                        "pressure_both_kPa", "pressure_outside_kPa", "volume_left_mL",
                                        "volume_right_mL", "stretch_p99", "max_stretch", "min_J", "stable"}));
    EXPECT_EQ(curve.find("stage")->values[0], 2.0);
    EXPECT_EQ(curve.find("pressure_outside")->values[0], -1.0);
    EXPECT_EQ(curve.find("volume_right")->values[0], 2.0);
    EXPECT_EQ(curve.find("volume_left")->slopes[0], 3e6);
    EXPECT_EQ(curve.coordinate_names(),
              "pressure, elongation, volume, pressure_both, pressure_outside, volume_left, volume_right");
}

TEST(Curve, KeepsRoundValuesRoundInTheUnitOfTheColumn) {
    const std::vector<model::Step> steps{step_with(30000, {0.13}, 1.5e-5)};
    const Curve curve = make_curve(sample_case({"elongation"}), steps);
    EXPECT_EQ(curve.find("pressure")->values[0], 30.0);
    EXPECT_EQ(curve.find("elongation")->values[0], 130.0);
    EXPECT_EQ(curve.find("volume")->values[0], 15.0);
}

TEST(Curve, RejectsAStepWithoutItsVolume) {
    const std::vector<model::Step> steps{step_with(0, {}, 1e-5), step_with(1, {}, std::nullopt)};
    EXPECT_THROW((void)make_curve(sample_case(), steps), Error);
}

TEST(Curve, RejectsAStepWithTooFewOutputs) {
    const std::vector<model::Step> steps{step_with(0, {0.0}, std::nullopt)};
    EXPECT_THROW((void)make_curve(sample_case({"elongation", "twist"}), steps), Error);
}

TEST(Curve, RejectsAStepWithoutThePressuresOfSeveralLoads) {
    model::Case model = sample_case();
    model.loads.push_back({"outside", {"outer"}, true, {}});
    EXPECT_THROW((void)make_curve(model, std::vector{step_with(0, {}, 1e-5)}), Error);
}

TEST(ValueAt, ReturnsTheValueInTheUnitOfTheColumn) {
    const Curve curve = make_curve(sample_case({"elongation"}), std::vector{step_with(0, {0.0}, 1e-5)});
    const model::LimitPoint point{.step = 0, .pressure_Pa = 44e3, .volume_m3 = 2e-5, .outputs = {0.0135}};
    EXPECT_EQ(value_at(*curve.find("pressure"), point), 44.0);
    EXPECT_EQ(value_at(*curve.find("elongation"), point), 13.5);
    EXPECT_EQ(value_at(*curve.find("volume"), point), 20.0);
    EXPECT_FALSE(value_at(*curve.find("min_J"), point).has_value());
}

}  // namespace
}  // namespace soft::post
