// Two spheres sharing one gas: the primary path, its bifurcation, and the branch on which one sphere grows and the other shrinks. Both
// spheres follow the curve p(a/A) of a single sphere, so the reference is a pair of points of this curve with equal pressure.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Two spheres sharing one gas";
constexpr double inner_mm = 10, outer_mm = 11;

struct Pair {
    const char* name;
    std::vector<std::string> sets;
    double right_scale = 1;  ///< thickness of the right wall
};

using Curve = std::function<double(double)>;

Curve curve_of(const ExtraStress& extra_stress, double scale) {
    const double ratio = 1 + (outer_mm - inner_mm) / inner_mm * scale;
    return [extra_stress, ratio](double l) { return sphere_pressure_Pa(extra_stress, l, ratio); };
}

/// For identical spheres the bifurcation is the limit point of a single sphere.
void add_bifurcation(const Run& run, const Peak& peak, Outcome& outcome) {
    const auto row = [&](const char* quantity, double reference, double ours) {
        return Row{.quantity = quantity,
                   .reference = reference,
                   .source = "quadrature, dp/dV = 0 of one sphere",
                   .ours = ours,
                   .mesh = run.mesh,
                   .seconds = run.seconds};
    };
    const auto& at = run.end.bifurcations.at(0).at;
    outcome.rows.push_back(row("pressure at the bifurcation [kPa]", 1e-3 * peak.value, 1e-3 * at.pressure_Pa));
    outcome.rows.push_back(row("V/V0 at the bifurcation [-]", std::pow(peak.location, 3),
                               at.volume_m3.value() / *run.steps.front().volume_m3));
}

/// Adds the states with one large and one small sphere at a total volume.
void add_unequal(const Run& run, const PairState& exact, double ratio, Outcome& outcome) {
    const auto point = run.at("volume", ratio * *run.steps.front().volume_m3);
    const auto [small, large] = std::minmax(point.volumes_m3.at(0), point.volumes_m3.at(1));
    const double V0 = 0.5 * *run.steps.front().volume_m3;
    const std::string at = " at V/V0 = " + core::number_text(ratio);
    const auto add = [&](const std::string& quantity, double reference, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = "quadrature, p(V1) = p(V2)",
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    add("pressure" + at + " [kPa]", 1e-3 * exact.pressure_Pa, 1e-3 * point.pressure_Pa);
    add("a/A of the larger" + at + " [-]", exact.large_stretch, std::cbrt(large / V0));
    add("a/A of the smaller" + at + " [-]", exact.small_stretch, std::cbrt(small / V0));
}

Outcome solve_pair(const Pair& pair) {
    auto sets = pair.sets;
    sets.insert(sets.end(), {"path.branch=follow", "solver.step_accuracy=2e-4",
                             "geometry.right_scale=" + core::number_text(pair.right_scale)});
    const auto run = run_design("two-spheres.yaml", sets);
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    // The sphere with the thinner wall grows.
    const auto strong = curve_of(extra_stress, std::max(1.0, pair.right_scale));
    const auto weak = curve_of(extra_stress, std::min(1.0, pair.right_scale));
    const auto peak = first_peak(strong, 1.001, 2.5);
    Outcome outcome;
    if (pair.right_scale == 1) {
        add_bifurcation(run, peak, outcome);
    } else {
        outcome.rows.push_back({.quantity = "limit pressure [kPa]",
                                .reference = 1e-3 * first_peak(weak, 1.001, 2.5).value,
                                .source = "quadrature, dp/dV = 0 of the thinner sphere",
                                .ours = 1e-3 * run.end.limit_points.at(0).pressure_Pa,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    }
    for (const double ratio : {3.5, 5.0, 8.0})
        add_unequal(run, sphere_pair(strong, weak, peak.location, ratio), ratio, outcome);
    return outcome;
}

/// Without path.branch=follow the spheres stay identical, and the bifurcation is reported.
Outcome solve_identical() {
    const auto run = run_design("two-spheres.yaml", {"path.branch=stay", "solver.step_accuracy=2e-4"});
    const auto extra_stress = extra_stress_of(run.model.materials.front());
    const auto curve = curve_of(extra_stress, 1);
    Outcome outcome;
    add_bifurcation(run, first_peak(curve, 1.001, 2.5), outcome);
    for (const double ratio : {2.0, 5.0, 9.0})
        outcome.rows.push_back({.quantity = "pressure at V/V0 = " + core::number_text(ratio) + " [kPa]",
                                .reference = 1e-3 * curve(std::cbrt(ratio)),
                                .source = "quadrature",
                                .ours = 1e-3 * run.at("volume", ratio * *run.steps.front().volume_m3).pressure_Pa,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    return outcome;
}

}  // namespace

std::vector<Problem> branch_problems() {
    const std::string mooney = "material={law: mooney-rivlin, c10: 0.075 MPa, c01: 0.0072 MPa, kappa: incompressible}";
    std::vector<Problem> problems{{group, "two spheres, neo-Hookean, identical", solve_identical}};
    for (const Pair& pair :
         {Pair{"two spheres, neo-Hookean, one grows", {}}, Pair{"two spheres, Mooney-Rivlin, one grows", {mooney}},
          Pair{"two spheres, neo-Hookean, right wall 5 % thicker", {}, 1.05},
          Pair{"two spheres, neo-Hookean, right wall 20 % thinner", {}, 0.8}})
        problems.push_back({group, pair.name, [pair] { return solve_pair(pair); }});
    return problems;
}

}  // namespace soft::verification
