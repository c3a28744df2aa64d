/// Dynamic designs: the keys of `dynamics`, time functions and supply lines of loads, and rejected combinations.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;
using namespace soft::model;

const std::string rubber = "family: pipe\nmaterial: {law: neo-hookean, mu: 0.1644 MPa, density: 1080 kg/m^3}\n";
const std::string cavity = "loads: {cavity: {pressure: 30 kPa}}\n";
const std::string moving = "dynamics: {duration: 0.5 s}\n";

std::string loaded_design(const std::string& more) {
    return rubber + "loads: {cavity: {pressure: 30 kPa, " + more + "}}\n" + moving;
}

TEST(DynamicDesign, HasTheDefaultsOfTheModel) {
    const Dynamics set = read(rubber + cavity + moving).dynamics.value(), usual;
    EXPECT_EQ(set.duration_s, 0.5);
    EXPECT_EQ(set.integrator, usual.integrator);
    EXPECT_EQ(set.step_s, usual.step_s);
    EXPECT_EQ(set.accuracy, usual.accuracy);
    EXPECT_EQ(set.spectral_radius, usual.spectral_radius);
    EXPECT_EQ(set.mass_damping_1_s, usual.mass_damping_1_s);
    EXPECT_EQ(set.stiffness_damping_s, usual.stiffness_damping_s);
    EXPECT_EQ(set.rows, usual.rows);
    EXPECT_FALSE(read(rubber + cavity + "dynamics: {duration: none}\n").dynamics.has_value());
}

TEST(DynamicDesign, ReadsEveryKey) {
    const Dynamics set =
        read(rubber + cavity +
             "dynamics: {duration: 40 ms, integrator: hht, step: 50 us, accuracy: 1e-3, spectral_radius: 0.6, "
             "mass_damping: 2 1/s, stiffness_damping: 0.1 ms, rows: 12}\n")
            .dynamics.value();
    EXPECT_EQ(set.duration_s, 0.04);
    EXPECT_EQ(set.integrator, Integrator::hht);
    EXPECT_EQ(set.step_s, 5e-5);
    EXPECT_EQ(set.accuracy, 1e-3);
    EXPECT_EQ(set.spectral_radius, 0.6);
    EXPECT_EQ(set.mass_damping_1_s, 2.0);
    EXPECT_EQ(set.stiffness_damping_s, 1e-4);
    EXPECT_EQ(set.rows, 12);
}

TEST(DynamicDesign, ReadsEveryIntegrator) {
    const std::vector<std::pair<std::string, Integrator>> words{{"generalized-alpha", Integrator::generalized_alpha},
                                                                {"newmark", Integrator::newmark},
                                                                {"implicit-euler", Integrator::implicit_euler},
                                                                {"ark4", Integrator::ark4},
                                                                {"rosenbrock", Integrator::rosenbrock},
                                                                {"heun", Integrator::heun},
                                                                {"explicit-euler", Integrator::explicit_euler},
                                                                {"central-difference", Integrator::central_difference}};
    for (const auto& [word, meant] : words)
        EXPECT_EQ(read(rubber + cavity + "mesh: {formulation: displacement}\n",
                       {{"dynamics", "{duration: 1 s, integrator: " + word + "}"}, {"material.kappa", "1 MPa"}})
                      .dynamics->integrator,
                  meant)
            << word;
}

TEST(DynamicDesign, IsReproducedByItsEffectiveDesign) {
    const std::string text = loaded_design(
        "time_function: {kind: table, times: [0 s, 50 ms], shares: [0, 1]}, line: {resistance: 0.1 kPa.s/mL}");
    const std::string effective = read(text).effective_yaml;
    const Design again = read(effective);
    EXPECT_EQ(again.effective_yaml, effective);
    EXPECT_EQ(again.loads.at(0).time_function.times_s, (std::vector{0.0, 0.05}));
    EXPECT_EQ(again.loads.at(0).line->resistance_Pa_s_m3, 1e8);
    const std::string explained = explain_design(text, "p.yaml", families(), {});
    EXPECT_TRUE(contains(explained, "kind: table")) << explained;
    EXPECT_EQ(read(explained).effective_yaml, effective);
}

TEST(DynamicDesign, KeysAreInTheTemplateWhichIsStatic) {
    const std::string text = template_yaml(pipe());
    for (const char* part : {"  duration: none", "  integrator: generalized-alpha", "  mass_damping: 0 1/s",
                             "  linear: auto", "    acts_on: deformed", "  strain: finite"})
        EXPECT_TRUE(contains(text, part)) << part << text;
    EXPECT_FALSE(read(text).dynamics.has_value());
}

TEST(TimeFunctions, EachKindHasItsOwnKeys) {
    const auto time_function = [](const std::string& text) {
        return read(loaded_design(text)).loads.at(0).time_function;
    };
    EXPECT_EQ(read(rubber + cavity + moving).loads.at(0).time_function.kind, TimeFunctionKind::ramp);
    EXPECT_EQ(time_function("time_function: {kind: ramp}").time_s, 0.0);  // the duration
    EXPECT_EQ(time_function("time_function: {rise: 20 ms}").time_s, 0.02);
    EXPECT_EQ(time_function("time_function: {kind: step}").kind, TimeFunctionKind::step);
    EXPECT_EQ(time_function("time_function: {kind: sine, frequency: 5 Hz}").frequency_Hz, 5.0);
    const TimeFunction table =
        time_function("time_function: {kind: table, times: [0 s, 50 ms, 2 s], shares: [0, 1, -0.5]}");
    EXPECT_EQ(table.kind, TimeFunctionKind::table);
    EXPECT_EQ(table.times_s, (std::vector{0.0, 0.05, 2.0}));
    EXPECT_EQ(table.shares, (std::vector{0.0, 1.0, -0.5}));
}

TEST(TimeFunctions, ApplyToTractionsAndGravity) {
    const Design design =
        read("family: bar\nmaterial: {law: neo-hookean, mu: 1 MPa, density: 1000 kg/m^3}\n" + moving +
             "loads: {end: {traction: 1 kPa, along: x, time_function: {kind: step}}, "
             "gravity: {acceleration: 9.81 m/s^2, along: -z, time_function: {kind: sine, frequency: 2 Hz}}}\n");
    EXPECT_EQ(design.dead_loads.at(0).time_function.kind, TimeFunctionKind::step);
    EXPECT_EQ(design.dead_loads.at(1).time_function.frequency_Hz, 2.0);
    const Design part = read_built(design.effective_yaml, {{"loads.end.time_function", "{rise: 10 ms}"}});
    EXPECT_EQ(part.dead_loads.at(0).time_function.kind, TimeFunctionKind::ramp);
    EXPECT_EQ(part.dead_loads.at(0).time_function.time_s, 0.01);
    EXPECT_EQ(part.dead_loads.at(1).time_function.kind, TimeFunctionKind::sine);
}

void expect_refused(const std::string& text, std::string_view location, std::string_view remedy) {
    const std::string line = refusal(text);
    EXPECT_TRUE(contains(line, location)) << line;
    EXPECT_TRUE(contains(line, remedy)) << line;
}

TEST(TimeFunctions, InvalidOnesAreRejected) {
    expect_refused(loaded_design("time_function: {kind: table, times: [0 s, 1 s], shares: [1]}"),
                   "time_function.shares: 1 shares for 2 times", "as many shares as times");
    expect_refused(loaded_design("time_function: {kind: table, times: [1 s, 1 s], shares: [1, 2]}"),
                   "time_function.times: the times are not ascending", "after");
    expect_refused(loaded_design("time_function: {kind: table, times: [-1 s, 1 s], shares: [1, 2]}"),
                   "time_function.times: -1 s is out of range", "at least 0");
    expect_refused(loaded_design("time_function: {kind: table, shares: [1, 2]}"), "time_function.times: missing",
                   "add times: [0 s, 50 ms]");
    expect_refused(loaded_design("time_function: {kind: sine, frequency: 0 Hz}"),
                   "time_function.frequency: 0 Hz is out of range", "more than 0");
    expect_refused(loaded_design("time_function: {kind: sine}"), "time_function.frequency: missing",
                   "add frequency: 5 Hz");
    expect_refused(loaded_design("time_function: {kind: sine, frequency: 5 s}"),
                   "'5 s' is a time where a rate is needed", "");
    expect_refused(loaded_design("time_function: {kind: step, rise: 1 s}"),
                   "time_function.rise: a time function of kind step has no such key", "kind: ramp");
    expect_refused(loaded_design("time_function: {frequency: 5 Hz}"),
                   "time_function.frequency: a time function of kind ramp has no such key", "kind: sine");
    expect_refused(loaded_design("time_function: {kind: jump}"), "time_function.kind: 'jump' is not a valid value", "");
    expect_refused(loaded_design("time_function: step"), "loads.cavity.time_function: a group of keys is needed here",
                   "kind");
    expect_refused(loaded_design("line: {resistance: 0 Pa.s/mL}"), "line.resistance: 0 Pa.s/mL is out of range",
                   "more than 0");
    expect_refused(loaded_design("line: {resistance: 5 kPa}"),
                   "'5 kPa' is a pressure where a flow resistance is needed", "Pa.s/m^3");
    expect_refused("family: bar\nmaterial: {law: neo-hookean, mu: 1 MPa, density: 1000 kg/m^3}\n" + moving +
                       "loads: {end: {pressure: 1 kPa, line: {resistance: 1 Pa.s/mL}}}\n",
                   "loads.end.line: a face encloses no gas", "only a cavity");
}

TEST(DynamicDesign, IsRequiredByAllKeysThatDependOnTime) {
    const std::string time_function = "loads: {cavity: {pressure: 30 kPa, time_function: {kind: step}}}\n";
    expect_refused(rubber + time_function,
                   "p.yaml:3:36: loads.cavity.time_function: a static path has no time function and no supply line",
                   "dynamics: {duration: 1 s}");
    expect_refused(rubber + "loads: {cavity: {pressure: 30 kPa, line: {resistance: 1 Pa.s/mL}}}\n",
                   "loads.cavity.line: a static path", "");
    expect_refused(rubber + cavity + "dynamics: {integrator: hht}\n",
                   "p.yaml:4:24: dynamics.integrator: unused without a duration", "dynamics: {duration: 1 s}");
    expect_refused(rubber + cavity + "dynamics: {rows: 3}\n", "dynamics.rows: unused without a duration", "");
}

TEST(DynamicDesign, RequiresADensity) {
    expect_refused("family: pipe\nmaterial: {law: neo-hookean, mu: 1 MPa}\n" + cavity + moving,
                   "p.yaml:4:22: dynamics.duration: the rubber has no density", "density: 1080 kg/m^3");
}

TEST(DynamicDesign, RejectsKeysOfAStaticPath) {
    const auto with = [](const std::string& path) { return rubber + cavity + moving + "path: {" + path + "}\n"; };
    expect_refused(with("stages: {a: {loads: {cavity: {pressure: 1 kPa}}}}"), "path.stages.a",
                   "give the load a time_function");
    expect_refused(with("control: pressure"), "path.control: a dynamic path has no control",
                   "leave out dynamics.duration");
    expect_refused(with("branch: follow"), "path.branch: a dynamic path has no branches", "");
    expect_refused(with("frequencies: 2"), "path.frequencies: a dynamic path has no natural frequencies",
                   "leave out dynamics.duration");
    expect_refused(with("until: {elongation: 4 mm}"), "path.until.elongation: a dynamic path ends after its duration",
                   "");
    EXPECT_EQ(read(with("until: {steps: 4}, contact: ignore")).path.stages.at(0).until.at(0).quantity, "steps");
    for (const char* supply : {"volume: 10 mL", "volume_ratio: 2", "mass: 3 mg"})
        expect_refused(rubber + "loads: {cavity: {" + supply + "}}\n" + moving,
                       "a dynamic path takes a pressure as its supply", "write pressure");
    expect_refused("family: bar\nmaterial: {law: neo-hookean, mu: 1 MPa, density: 1000 kg/m^3}\n" + moving +
                       "loads: {end: {displacement: 1 mm, along: x}}\n",
                   "loads.end.displacement: the displacement of a face", "pressure or a traction");
}

TEST(DynamicDesign, RejectsInvalidIntegratorSettings) {
    const auto with = [](const std::string& keys) {
        return rubber + cavity + "dynamics: {duration: 1 s, " + keys + "}\n";
    };
    for (const char* word : {"heun", "explicit-euler", "central-difference"})
        expect_refused(with(std::string{"integrator: "} + word),
                       "dynamics.integrator: an explicit integrator has no equation", "formulation: displacement");
    expect_refused(with("integrator: hht, spectral_radius: 0.4"), "dynamics.spectral_radius: hht is unstable below 0.5",
                   "generalized-alpha");
    EXPECT_EQ(read(with("spectral_radius: 0")).dynamics->spectral_radius, 0.0);
    expect_refused(with("spectral_radius: 1.1"), "out of range", "at most 1");
    expect_refused(with("step: 2 s"), "dynamics.step: a step longer than the duration", "a shorter step");
    expect_refused(rubber + cavity + "dynamics: {duration: 0 s}\n", "dynamics.duration: 0 s is out of range",
                   "more than 0");
}

TEST(DynamicDesign, SolveCanMakeAStaticCaseDynamic) {
    const std::string effective = read(rubber + cavity).effective_yaml;
    const std::vector<Override> changes = {{"dynamics.duration", "0.2 s"},
                                           {"dynamics.step", "1 ms"},
                                           {"loads.cavity.time_function", "{kind: step}"},
                                           {"loads.cavity.line.resistance", "1e8 Pa.s/m^3"}};
    const Design part = read_built(effective, changes);
    EXPECT_EQ(part.dynamics.value().duration_s, 0.2);
    EXPECT_EQ(part.dynamics->step_s, 1e-3);
    EXPECT_EQ(part.loads.at(0).time_function.kind, TimeFunctionKind::step);
    EXPECT_EQ(part.loads.at(0).line.value().resistance_Pa_s_m3, 1e8);
    EXPECT_EQ(part.effective_yaml, read(effective, changes).effective_yaml);
    const Design still =
        read_built(part.effective_yaml, {{"dynamics", "{duration: none}"}, {"loads.cavity", "{pressure: 2 kPa}"}});
    EXPECT_FALSE(still.dynamics.has_value());
    try {  // the case has mixed cells, whose pressure unknowns an explicit integrator cannot handle
        static_cast<void>(read_built(effective, {{"dynamics", "{duration: 1 s, integrator: heun}"}}));
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "an explicit integrator")) << error.what();
    }
}

}  // namespace
