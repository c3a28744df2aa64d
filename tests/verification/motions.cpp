// Dynamics: period and damping of a beam, a sphere in its breathing mode, natural frequencies of both, and the quasi-static limit of the
// bellows.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "../solver/breathing_sphere.hpp"
#include "beam_formula.hpp"
#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Dynamics";

struct Extremum {
    double time_s, value;
};

/// Extrema of the output: sign changes of the velocity of the cubic through values and velocities of two rows.
std::vector<Extremum> extrema(const Run& run) {
    std::vector<Extremum> found;
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const auto& from = run.steps[i - 1];
        const auto& to = run.steps[i];
        const double va = from.tangent_outputs[0], vb = to.tangent_outputs[0];
        if (i == 1 || va * vb > 0.0) continue;
        const double h = to.motion->time_s - from.motion->time_s, a = from.outputs[0], b = to.outputs[0];
        const double mean = (b - a) / h;
        const auto velocity = [&](double s) {
            return va * (1 - s) * (1 - 3 * s) + vb * s * (3 * s - 2) + 6 * mean * s * (1 - s);
        };
        double low = 0, high = 1;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (low + high);
            (velocity(middle) * va > 0.0 ? low : high) = middle;
        }
        const double s = low, t = 1 - s;
        found.push_back({from.motion->time_s + s * h,
                         a * t * t * (1 + 2 * s) + b * s * s * (3 - 2 * s) + h * s * t * (va * t - vb * s)});
    }
    return found;
}

/// The differences between successive extrema decay by exp(-z w T / 2) each and do not depend on the rest position of the beam. The
/// second mode (6.3 times the frequency, 1.4 % of the first mode under a uniform load) has decayed after the first two periods.
Outcome solve_cantilever() {
    const auto run = run_design("verification/cantilever.yaml", {});
    const auto& material = run.model.materials.front();
    const double G = material.constants.at("mu").front();
    const Beam beam{80e-3, 0.5e-3, 4.0 * G, G, *material.density_kg_m3};
    const auto found = extrema(run);
    constexpr std::size_t first = 5;
    const std::size_t last = found.size() - 1;
    const auto amplitude = [&](std::size_t k) { return std::abs(found[k].value - found[k - 1].value); };
    const double halves = static_cast<double>(last - first);
    const double damped = std::numbers::pi * halves / (found[last].time_s - found[first].time_s);
    const double decrement = 2.0 / halves * std::log(amplitude(first) / amplitude(last));
    const double zeta = decrement / std::hypot(2.0 * std::numbers::pi, decrement);
    const double frequency = damped / std::sqrt(1.0 - zeta * zeta), theory = beam.frequency();
    const auto& dynamics = *run.model.dynamics;
    const double rayleigh = dynamics.mass_damping_1_s / (2.0 * theory) + 0.5 * dynamics.stiffness_damping_s * theory;
    Outcome outcome;
    const auto add = [&](const char* quantity, double reference, const char* source, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = source,
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    add("first period, undamped [s]", 2.0 * std::numbers::pi / theory,
        "Timoshenko's beam, E' = 4 mu of incompressible plane strain", 2.0 * std::numbers::pi / frequency);
    add("damping ratio by the logarithmic decrement [-]", rayleigh, "Rayleigh, a / 2w + b w / 2 at Timoshenko's w",
        zeta);
    const auto still =
        run_design("verification/cantilever.yaml",
                   {"dynamics={}", "path={frequencies: 1}", "loads.gravity={acceleration: 15e-6 m/s^2, along: y}"});
    const double natural = still.steps.back().frequencies_Hz[0];
    add("first natural frequency [Hz]", theory / (2.0 * std::numbers::pi),
        "Timoshenko's beam, E' = 4 mu of incompressible plane strain", natural);
    add("first natural frequency, against the vibration [Hz]", frequency / (2.0 * std::numbers::pi),
        "the free vibration of the same mesh, undamped", natural);
    return outcome;
}

/// At constant pressure, linearised equation of motion of an incompressible sphere (../solver/breathing_sphere.hpp):
///   (2 pi f)^2 = p'(l) / (rho A a (1 - a / b)),     a = l A, b^3 = B^3 + a^3 - A^3, p the static pressure at the inner stretch l.
/// Beyond the pressure maximum p' < 0, and f stands for -|f|.
double breathing_frequency_Hz(const solver::BreathingSphere& sphere, double mu_Pa, double stretch) {
    constexpr double step = 1e-4;
    const auto pressure = [&](double l) {
        return neo_hookean_sphere_pressure_Pa(mu_Pa, l, sphere.outer_m / sphere.inner_m);
    };
    const double slope = (pressure(stretch + step) - pressure(stretch - step)) / (2.0 * step);
    const double A = sphere.inner_m, B = sphere.outer_m, a = stretch * A;
    const double b = std::cbrt(B * B * B + a * a * a - A * A * A);
    const double square = slope / (sphere.density_kg_m3 * A * a * (1.0 - a / b));
    return std::copysign(std::sqrt(std::abs(square)), square) / (2.0 * std::numbers::pi);
}

/// The other frequencies belong to modes that change the shape of the sphere.
Outcome solve_breathing_frequency() {
    const auto run =
        run_design("verification/sphere-neo-hookean.yaml", {"material.density=1080 kg/m^3", "path.frequencies=6"});
    const double mu = run.model.materials.front().constants.at("mu").front();
    const solver::BreathingSphere sphere{10e-3, 20e-3, *run.model.materials.front().density_kg_m3};
    Outcome outcome;
    const auto add = [&](const std::string& where, const model::Step& step) {
        const double stretch = std::cbrt(*step.volume_m3 / *run.steps.front().volume_m3);
        const double exact = breathing_frequency_Hz(sphere, mu, stretch);
        outcome.rows.push_back(
            {.quantity = "natural frequency " + where + " [Hz]",
             .reference = exact,
             .source = "linearised equation of motion of an incompressible sphere",
             .ours = *std::ranges::min_element(step.frequencies_Hz, {}, [&](double f) { return std::abs(f - exact); }),
             .mesh = run.mesh,
             .seconds = run.seconds});
    };
    const auto beyond = [&](double stretch) -> const model::Step& {
        const double volume_m3 = stretch * stretch * stretch * *run.steps.front().volume_m3;
        return *std::ranges::find_if(run.steps, [&](const auto& step) { return *step.volume_m3 > volume_m3; });
    };
    add("at rest", run.steps.front());
    add("in the first row above a/A = 1.4", beyond(1.4));
    add("in the first row above a/A = 2, past the pressure maximum", beyond(2.0));
    add("at a/A = 3, past the pressure maximum", run.steps.back());
    return outcome;
}

Outcome solve_sphere() {
    const auto run = run_design("verification/sphere-breathing.yaml", {});
    const auto& material = run.model.materials.front();
    const double mu = material.constants.at("mu").front();
    const auto elastic_Pa = [&](double stretch) { return neo_hookean_sphere_pressure_Pa(mu, stretch, 2.0); };
    const solver::BreathingSphere sphere{10e-3, 20e-3, *material.density_kg_m3};
    constexpr int count = 80;  // every row
    const auto exact = solver::breathing_stretches(sphere, run.model.path.stages[0].supplies[0].value, elastic_Pa,
                                                   run.model.dynamics->duration_s, count);
    if (run.steps.size() != count + 1) throw std::runtime_error("the sphere has an unexpected number of rows");
    Outcome outcome;
    const auto inner = [&](int row) {
        return std::cbrt(*run.steps[static_cast<std::size_t>(row)].volume_m3 / *run.steps.front().volume_m3);
    };
    const auto add = [&](const std::string& quantity, double reference, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = "equation of motion of an incompressible sphere",
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    for (const int ms : {1, 2, 4, 8})
        add("a/A after " + std::to_string(ms) + " ms [-]", exact[10 * static_cast<std::size_t>(ms) - 1],
            inner(10 * ms));
    int worst = 1;
    double error = 0;
    for (int row = 1; row <= count; ++row) {
        const double there = std::abs(inner(row) / exact[static_cast<std::size_t>(row) - 1] - 1.0);
        if (there > error) {
            error = there;
            worst = row;
        }
    }
    add("a/A at the largest difference, after " + core::number_text(0.1 * worst) + " ms [-]",
        exact[static_cast<std::size_t>(worst) - 1], inner(worst));
    return outcome;
}

/// Compares the motion with the static curve at equal pressure, at the rows of the motion. Differences are relative to the elongation,
/// but at least to a tenth of its largest value, because a ramp starts with a jump of the velocity. The resulting vibration is damped;
/// after that the motion lags by the damping force at its velocity.
Outcome solve_slow_bellows() {
    const std::vector<std::string> common{"mesh.size=3 mm", "loads.cavity.pressure=20 kPa", "path={}"};
    auto slow = common, still = common;
    slow.insert(slow.end(), {"material.density=1080 kg/m^3", "dynamics.duration=2000 s", "dynamics.mass_damping=2 1/s",
                             "dynamics.stiffness_damping=2 ms", "dynamics.accuracy=1e-3"});
    still.push_back("solver.step_accuracy=5e-5");
    const auto run = run_design("bellows.yaml", slow), curve = run_design("bellows.yaml", still);
    struct Comparison {
        double static_m = 0, dynamic_m = 0, error = 0;
    };
    Comparison first, worst, last;
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const auto& step = run.steps[i];
        const double there = curve.at("pressure", step.pressure_Pa).outputs[0];
        const double scale = std::max(there, 0.1 * run.steps.back().outputs[0]);
        last = {there, step.outputs[0], std::abs(step.outputs[0] - there) / scale};
        if (first.error == 0.0 && there >= scale) first = last;
        if (last.error > worst.error) worst = last;
    }
    Outcome outcome;
    const auto add = [&](const std::string& what, double reference, double ours) {
        outcome.rows.push_back({.quantity = "elongation " + what + " [mm]",
                                .reference = 1e3 * reference,
                                .source = "the static curve of the same mesh",
                                .ours = 1e3 * ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    add("in the first row above a tenth of the final one", first.static_m, first.dynamic_m);
    add("at 20 kPa", last.static_m, last.dynamic_m);
    const double larger = std::max(worst.static_m, 0.1 * last.dynamic_m);
    add("at the largest difference, at least a tenth of the final one", larger,
        larger + worst.dynamic_m - worst.static_m);
    return outcome;
}

}  // namespace

std::vector<Problem> motion_problems() {
    return {{group, "cantilever, free vibration", solve_cantilever},
            {group, "sphere B/A = 2, breathing", solve_sphere},
            {group, "sphere B/A = 2, natural frequency of the breathing mode", solve_breathing_frequency},
            {group, "bellows, inflated slowly", solve_slow_bellows}};
}

}  // namespace soft::verification
