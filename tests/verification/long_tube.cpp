// A long closed tube: far from its ends the wall solves the plane problem with an axial force. The caps of a tube 400 mm long are 20
// diameters from its middle. Its limit pressure converges to that of an infinite tube with the inverse square of the length.
#include <cmath>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Inflation";
constexpr double inner_m = 7e-3, outer_m = 10e-3;

struct Middle {
    double hoop, axial;
};

/// Stretches of the inner wall halfway along the tube at the last state.
Middle middle_of(const Run& run, double length_m) {
    const auto node = nearest_node(run, {0.5 * length_m, inner_m, 0});
    constexpr double span_m = 4e-3;
    const auto left = nearest_node(run, {0.5 * length_m - span_m, inner_m, 0});
    const auto right = nearest_node(run, {0.5 * length_m + span_m, inner_m, 0});
    const double dx = run.model.mesh.points[right][0] - run.model.mesh.points[left][0];
    return {1 + run.displacement_m[3 * node + 1] / run.model.mesh.points[node][1],
            1 + (run.displacement_m[3 * right] - run.displacement_m[3 * left]) / dx};
}

Outcome rising_branch(const std::string& pressure_kPa) {
    const auto run = run_design("verification/tube-long.yaml", {"path.until.pressure=" + pressure_kPa + " kPa"});
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const double pressure_Pa = 1e3 * std::stod(pressure_kPa);
    const double hoop = root_of(
        [&](double l) { return closed_tube(extra_stress, inner_m, outer_m, l).pressure_Pa - pressure_Pa; }, 1.0, 1.79);
    const auto middle = middle_of(run, 0.4);
    const auto row = [&](const std::string& quantity, double reference, double ours) {
        return Row{.quantity = quantity + " at " + pressure_kPa + " kPa, middle [-]",
                   .reference = reference,
                   .source = "quadrature of the axial equilibrium",
                   .ours = ours,
                   .mesh = run.mesh,
                   .seconds = run.seconds};
    };
    return {{row("a/A", hoop, middle.hoop),
             row("axial stretch", closed_tube(extra_stress, inner_m, outer_m, hoop).axial_stretch, middle.axial)},
            {}};
}

Outcome limit_point() {
    const auto run = run_design("verification/tube-long.yaml", {});
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const auto peak =
        first_peak([&](double l) { return closed_tube(extra_stress, inner_m, outer_m, l).pressure_Pa; }, 1.001, 3.0);
    return {{{.quantity = "limit pressure [kPa]",
              .reference = 1e-3 * peak.value,
              .source = "quadrature of the axial equilibrium",
              .ours = 1e-3 * run.end.limit_points.at(0).pressure_Pa,
              .mesh = run.mesh,
              .seconds = run.seconds}},
            {}};
}

}  // namespace

std::vector<Problem> long_tube_problems() {
    return {{group, "long closed tube, rising branch, 30 kPa", [] { return rising_branch("30"); }},
            {group, "long closed tube, rising branch, 40 kPa", [] { return rising_branch("40"); }},
            {group, "long closed tube, limit point", limit_point}};
}

}  // namespace soft::verification
