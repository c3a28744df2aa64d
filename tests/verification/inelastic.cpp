// Viscoelastic and softening rubber: a bar under prescribed stretch and stress, and a sphere with prescribed volume.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/text.hpp"
#include "inelastic_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Inelastic rubber";
constexpr const char* bar = "verification/inelastic.yaml";
constexpr const char* viscous = ", viscoelastic: {moduli: [0.4, 0.2], times: [0.3 s, 4 s]}";
constexpr const char* soft = ", softening: {r: 2, m: 10 kPa, beta: 0.1}";
constexpr const char* convolution = "convolution, 3000 steps of the midpoint rule";

/// The laws with an isochoric energy.
const std::vector<std::pair<std::string, std::string>> laws{
    {"neo-hookean", "neo-hookean, mu: 0.1644 MPa"},
    {"mooney-rivlin", "mooney-rivlin, c10: 0.07 MPa, c01: 0.0122 MPa"},
    {"yeoh", "yeoh, c1: 0.0822 MPa, c2: -0.001 MPa, c3: 0.0002 MPa"},
    {"ogden", "ogden, mu: [0.63 MPa, 0.0012 MPa, -0.01 MPa], alpha: [1.3, 5, -2]"},
    {"gent", "gent, mu: 0.1644 MPa, jm: 30"},
    {"arruda-boyce", "arruda-boyce, mu: 0.1644 MPa, locking_stretch: 3"}};

std::string material(const std::string& law, const std::string& effects) {
    return "material={law: " + law + ", kappa: incompressible" + effects + "}";
}

Problem bar_of(const std::string& name, const std::string& law) {
    return {group, "bar, " + name, [law] {
                Outcome outcome;
                const auto relaxed = run_design(bar, {material(law, viscous)});
                const InelasticLaw exact = inelastic_law_of(relaxed.model.materials.front());
                constexpr double area_m2 = 1e-4, l = 1.4;
                outcome.rows.push_back({.quantity = "tension at the stretch 1.4 after 5 s [N]",
                                        .reference = stress_after(exact, {{0.5, l}, {5, l}}) * area_m2 / l,
                                        .source = convolution,
                                        .ours = std::abs(relaxed.steps.back().outputs.at(1)),
                                        .mesh = relaxed.mesh,
                                        .seconds = relaxed.seconds});
                const auto crept =
                    run_design(bar, {material(law, viscous), "loads={end: {pressure: -200 kPa}}",
                                     "path.stages={pull: {time: 0.2 s, loads: {end: {pressure: -200 kPa}}}, "
                                     "hold: {time: 3 s}}"});
                outcome.rows.push_back({.quantity = "strain at 200 kPa after 3 s [%]",
                                        .reference = 100 * (stretch_after(exact, {{0.2, 2e5}, {3, 2e5}}) - 1),
                                        .source = convolution,
                                        .ours = 100 * crept.steps.back().outputs.at(0) / 20e-3,
                                        .mesh = crept.mesh,
                                        .seconds = crept.seconds});
                return outcome;
            }};
}

/// Loading and unloading to growing stretches, without times: the formula of Ogden and Roxburgh.
Problem softened_bar() {
    return {
        group, "softened bar", [] {
            const auto run = run_design(
                bar, {material(laws[2].second, soft),
                      "path.stages={first: {loads: {end: {displacement: 10 mm}}}, "
                      "back: {loads: {end: {displacement: 4 mm}}}, again: {loads: {end: {displacement: 8 mm}}}, "
                      "further: {loads: {end: {displacement: 16 mm}}}, last: {loads: {end: {displacement: 6 mm}}}}"});
            const InelasticLaw law = inelastic_law_of(run.model.materials.front());
            constexpr double area_m2 = 1e-4;
            Outcome outcome;
            std::vector<Ramp> ramps;
            const std::vector<double> stretches{1.5, 1.2, 1.4, 1.8, 1.3};
            for (std::size_t stage = 0; stage < stretches.size(); ++stage) {
                ramps.push_back({1, stretches[stage]});
                const auto last = std::ranges::find_if(run.steps, [&](const model::Step& step) {
                    return step.stage == static_cast<int>(stage) && step.load_factor == 1.0;
                });
                outcome.rows.push_back({.quantity = "tension at the end of stage " + std::to_string(stage + 1) + " [N]",
                                        .reference = stress_after(law, ramps) * area_m2 / stretches[stage],
                                        .source = "Ogden and Roxburgh (1999)",
                                        .ours = std::abs(last->outputs.at(1)),
                                        .mesh = run.mesh,
                                        .seconds = run.seconds,
                                        .tolerance = homogeneous_tolerance});
            }
            return outcome;
        }};
}

Problem sphere_of(const std::string& name, const std::string& effects) {
    return {group, "thick sphere, " + name, [effects] {
                const auto run = run_design(
                    "sphere.yaml",
                    {material(laws[2].second, effects), "loads={cavity: {volume_ratio: 3}}", "path.until={}",
                     "path.control=auto",
                     "path.stages={inflate: {time: 0.5 s, loads: {cavity: {volume_ratio: 3}}}, hold: {time: 2 s}, "
                     "deflate: {time: 0.5 s, loads: {cavity: {volume_ratio: 2}}}, "
                     "inflate_again: {time: 1 s, loads: {cavity: {volume_ratio: 4}}}}"});
                const auto exact = sphere_pressures_Pa(inelastic_law_of(run.model.materials.front()), 2,
                                                       {{0.5, 3}, {2, 3}, {0.5, 2}, {1, 4}});
                Outcome outcome;
                for (std::size_t stage = 0; stage < exact.size(); ++stage) {
                    const auto last = std::ranges::find_if(run.steps, [&](const model::Step& step) {
                        return step.stage == static_cast<int>(stage) && step.load_factor == 1.0;
                    });
                    outcome.rows.push_back(
                        {.quantity = "pressure at the end of stage " + std::to_string(stage + 1) + " [kPa]",
                         .reference = 1e-3 * exact[stage],
                         .source = "quadrature of the wall and of its history",
                         .ours = 1e-3 * last->pressure_Pa,
                         .mesh = run.mesh,
                         .seconds = run.seconds});
                }
                const auto& energies = run.steps.back().energies.value();
                outcome.rows.push_back({.quantity = "work of the gas [mJ]",
                                        .reference = 1e3 * (energies.stored_J + energies.dissipated_J.value()),
                                        .source = "energy stored and dissipated in the rubber",
                                        .ours = 1e3 * energies.load_work_J,
                                        .mesh = run.mesh,
                                        .seconds = run.seconds});
                return outcome;
            }};
}

/// A light bar under a small sinusoidal traction, as a motion: in the last cycle the strain has the amplitude and the phase of the complex
/// modulus E' + i E'' of a Prony series.
Problem shaken_bar(const std::string& name, const std::string& law) {
    return {group, "harmonic stress, " + name, [law] {
                constexpr double frequency_Hz = 0.5, stress_Pa = 2e3, omega = 2 * std::numbers::pi * frequency_Hz;
                const auto run = run_design(
                    bar, {material(law, std::string(viscous) + ", density: 1 kg/m^3"), "path.stages={}",
                          "loads={end: {traction: 2 kPa, along: x, time_function: {kind: sine, frequency: 0.5 Hz}}}",
                          "outputs={elongation: {face: end, along: axis}}", "dynamics.duration=40 s",
                          "dynamics.rows=2001", "dynamics.step=0.02 s", "solver.step_limit=10000"});
                double in_phase = 0, out_of_phase = 0, norm = 0;
                for (const model::Step& step : run.steps) {
                    if (step.motion->time_s < 38 + 1e-9) continue;  // the last cycle
                    const double strain = step.outputs.at(0) / 20e-3, phase = omega * step.motion->time_s;
                    in_phase += strain * std::sin(phase);
                    out_of_phase -= strain * std::cos(phase);
                    norm += std::sin(phase) * std::sin(phase);
                }
                const std::complex<double> compliance(in_phase / norm / stress_Pa, -out_of_phase / norm / stress_Pa);
                const std::complex<double> found = 1.0 / compliance;
                std::complex<double> modulus = 1;
                const InelasticLaw exact = inelastic_law_of(run.model.materials.front());
                for (std::size_t i = 0; i < exact.moduli.size(); ++i) {
                    const std::complex<double> z(0, omega * exact.times_s[i]);
                    modulus += exact.moduli[i] * z / (1.0 + z);
                }
                const auto pull_Pa = [&](double l) {  // uniaxial
                    const double across = 1 / std::sqrt(l);
                    const Triple stress = exact.extra_stress({l, across, across});
                    return stress[0] - stress[1];
                };
                constexpr double small = 1e-5;
                modulus *= (pull_Pa(1 + small) - pull_Pa(1 - small)) / (2 * small);
                const auto row = [&](const char* quantity, double reference_Pa, double ours_Pa) {
                    return Row{.quantity = quantity,
                               .reference = 1e-3 * reference_Pa,
                               .source = "closed form, small strains",
                               .ours = 1e-3 * ours_Pa,
                               .mesh = run.mesh,
                               .seconds = run.seconds};
                };
                return Outcome{{row("storage modulus at 0.5 Hz [kPa]", modulus.real(), found.real()),
                                row("loss modulus at 0.5 Hz [kPa]", modulus.imag(), found.imag())},
                               {}};
            }};
}

/// Steps of equal length: the error of the strain of a creeping bar falls with the square of the step.
Problem order_in_time() {
    return {
        group, "order in time", [] {
            const std::vector<std::string> sets{material(laws[2].second, viscous), "loads={end: {pressure: -200 kPa}}",
                                                "path.stages={pull: {time: 0.6 s, loads: {end: {pressure: -200 kPa}}}}",
                                                "solver.steps=constant", "path.time_accuracy=1"};
            Table table{"Order of steps in time",
                        "Strain of a bar of viscoelastic rubber whose stress grows in 0.6 s to 200 kPa, by steps of "
                        "equal length, against 3000 steps of the midpoint rule.",
                        {"steps", "error of the strain [%]", "order"},
                        {}};
            double before = 0, finest = 0;
            Outcome outcome;
            for (const int steps : {8, 16, 32, 64}) {
                auto all = sets;
                all.push_back("solver.first_step=" + core::number_text(1.0 / steps));
                const auto run = run_design(bar, all);
                const double exact = stretch_after(inelastic_law_of(run.model.materials.front()), {{0.6, 2e5}}) - 1;
                const double error = std::abs(run.steps.back().outputs.at(0) / 20e-3 / exact - 1);
                finest = before > 0 ? std::log2(before / error) : 0;
                table.lines.push_back({std::to_string(steps), core::rounded_text(100 * error, 3),
                                       before > 0 ? core::rounded_text(finest, 3) : ""});
                before = error;
                if (steps == 64)
                    outcome.rows.push_back({.quantity = "order of the last halving [-]",
                                            .reference = 2,
                                            .source = "linear stress in each step",
                                            .ours = finest,
                                            .mesh = run.mesh,
                                            .seconds = run.seconds,
                                            .tolerance = 0.05,
                                            .reason = "an order measured from errors of 0.01 %"});
            }
            outcome.tables.push_back(std::move(table));
            return outcome;
        }};
}

}  // namespace

std::vector<Problem> inelastic_problems() {
    std::vector<Problem> problems;
    for (const auto& [name, law] : laws) problems.push_back(bar_of(name, law));
    problems.push_back(softened_bar());
    problems.push_back(sphere_of("viscoelastic", viscous));
    problems.push_back(sphere_of("softening", soft));
    problems.push_back(sphere_of("both effects", std::string(viscous) + soft));
    for (const auto& [name, law] : laws) problems.push_back(shaken_bar(name, law));
    problems.push_back(order_in_time());
    return problems;
}

}  // namespace soft::verification
