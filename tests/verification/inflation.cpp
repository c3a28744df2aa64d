// Spheres and plane-strain cylinders of incompressible rubber: pressures along the curve and limit points.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Inflation";

std::string mm_text(double metres) { return core::number_text(1e3 * metres) + " mm"; }

/// A sphere, inflated to the volume ratio of its largest inner stretch.
struct Sphere {
    const char* name;
    const char* design;
    std::vector<std::string> sets;
    double inner_m, outer_m;
    std::vector<double> inner_stretches;  ///< where the pressure is compared
    bool has_limit_point = true;
    bool closed_form = false;  ///< neo-Hookean
};

double inner_stretch(const Run& run, double volume_m3) { return std::cbrt(volume_m3 / *run.steps.front().volume_m3); }

Outcome solve_sphere(const Sphere& sphere) {
    auto sets = sphere.sets;
    sets.push_back("geometry.inner_radius=" + mm_text(sphere.inner_m));
    sets.push_back("geometry.outer_radius=" + mm_text(sphere.outer_m));
    const double last = sphere.inner_stretches.back() * 1.02;
    sets.push_back("path.until.volume_ratio=" + core::number_text(std::pow(last, 3)));
    const auto run = run_design("verification/" + std::string(sphere.design) + ".yaml", sets);
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const double ratio = sphere.outer_m / sphere.inner_m, volume = *run.steps.front().volume_m3;
    const auto exact = [&](double l) {
        return sphere.closed_form
                   ? neo_hookean_sphere_pressure_Pa(run.model.materials.front().constants.at("mu").front(), l, ratio)
                   : sphere_pressure_Pa(extra_stress, l, ratio);
    };
    const std::string source = sphere.closed_form ? "closed form" : "quadrature";
    Outcome outcome;
    for (const double l : sphere.inner_stretches)
        outcome.rows.push_back({.quantity = "pressure at a/A = " + core::number_text(l) + " [kPa]",
                                .reference = 1e-3 * exact(l),
                                .source = source,
                                .ours = 1e-3 * run.at("volume", volume * l * l * l).pressure_Pa,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    if (!sphere.has_limit_point) return outcome;
    const auto peak = first_peak(exact, 1.001, last);
    const auto& limit = run.end.limit_points.at(0);
    outcome.rows.push_back({.quantity = "limit pressure [kPa]",
                            .reference = 1e-3 * peak.value,
                            .source = source,
                            .ours = 1e-3 * limit.pressure_Pa,
                            .mesh = run.mesh,
                            .seconds = run.seconds});
    outcome.rows.push_back({.quantity = "a/A at the limit [-]",
                            .reference = peak.location,
                            .source = source,
                            .ours = inner_stretch(run, *limit.volume_m3),
                            .mesh = run.mesh,
                            .seconds = run.seconds});
    return outcome;
}

std::vector<Sphere> spheres() {
    const char* neo = "sphere-neo-hookean";
    const std::vector<std::string> plain, solid{"model=quarter", "mesh.size=3.3 mm", "mesh.sectors=4"};
    return {
        {"sphere B/A = 2, neo-Hookean", neo, plain, 10e-3, 20e-3, {1.25, 1.5, 2, 3}, true, true},
        {"sphere B/A = 1.1, neo-Hookean", neo, {"mesh.size=1 mm"}, 10e-3, 11e-3, {1.2, 2}, true, true},
        {"sphere B/A = 1.5, neo-Hookean, A = 4 mm", neo, {"mesh.size=0.7 mm"}, 4e-3, 6e-3, {1.5, 4}, true, true},
        {"sphere B/A = 6, neo-Hookean, A = 2 mm", neo, {"mesh.size=0.6 mm"}, 2e-3, 12e-3, {1.5, 3}, false, true},
        {"sphere B/A = 2, neo-Hookean, triangles", neo, {"mesh.cells=simplices"}, 10e-3, 20e-3, {1.5, 2}, true, true},
        {"sphere B/A = 2, neo-Hookean, solid eighth", neo, solid, 10e-3, 20e-3, {1.5, 2}, true, true},
        {"sphere B/A = 2, Mooney-Rivlin", "sphere-mooney-rivlin", plain, 10e-3, 20e-3, {1.25, 1.5, 3}, true},
        {"sphere B/A = 1.1, Mooney-Rivlin", "sphere-mooney-rivlin", {"mesh.size=1 mm"}, 10e-3, 11e-3, {1.2, 2}, true},
        {"sphere B/A = 2, Yeoh", "sphere-yeoh", plain, 10e-3, 20e-3, {1.25, 1.5, 2, 3}, true},
        {"sphere B/A = 2, Ogden (Treloar)", "sphere-ogden", plain, 10e-3, 20e-3, {1.25, 1.5, 2, 3}, true},
        {"sphere B/A = 1.1, Ogden (Treloar)", "sphere-ogden", {"mesh.size=1 mm"}, 10e-3, 11e-3, {1.2, 2, 3}, true},
    };
}

/// The limit point of a thin shell converges to that of a membrane. p R/(mu t) and the stretch (R: middle radius) of two shells are
/// extrapolated to t = 0 as a + b t^2 (by symmetry about the middle surface; `formula_test` checks the same for the closed form).
Problem thin_sphere() {
    return {group, "sphere of vanishing thickness, neo-Hookean", [] {
                struct Shell {
                    double thickness_m, pressure, stretch;
                    Run run;
                };
                constexpr double middle_m = 10e-3;
                std::vector<Shell> shells;
                for (const double t : {1e-3, 0.5e-3}) {
                    const auto run =
                        run_design("verification/sphere-neo-hookean.yaml",
                                   {"mesh.size=0.5 mm", "mesh.through_wall=1", "path.until.volume_ratio=4",
                                    "solver.step_accuracy=2e-4", "geometry.inner_radius=" + mm_text(middle_m - 0.5 * t),
                                    "geometry.outer_radius=" + mm_text(middle_m + 0.5 * t)});
                    const auto& limit = run.end.limit_points.at(0);
                    const double mu = run.model.materials.front().constants.at("mu").front();
                    const double inner = std::cbrt(*limit.volume_m3 / *run.steps.front().volume_m3);
                    const double a = middle_m - 0.5 * t;
                    const double middle = std::cbrt(1 + (inner * inner * inner - 1) * std::pow(a / middle_m, 3));
                    shells.push_back({t, limit.pressure_Pa * middle_m / (mu * t), middle, run});
                }
                const auto extrapolated = [&](double Shell::*value) {
                    return (4 * (shells[1].*value) - shells[0].*value) / 3;  // t halves
                };
                const double seconds = shells[0].run.seconds + shells[1].run.seconds;
                const std::string source = "membrane, closed form";
                const std::string mesh = shells[1].run.mesh + " (t/R = 1/10, 1/20, extrapolated)";
                const double l = std::pow(7.0, 1.0 / 6.0);  // p R/(mu t) = 2 (1/l - 1/l^7)
                return Outcome{{{.quantity = "p R/(mu t) at the limit [-]",
                                 .reference = 2 * (1 / l - std::pow(l, -7)),
                                 .source = source,
                                 .ours = extrapolated(&Shell::pressure),
                                 .mesh = mesh,
                                 .seconds = seconds},
                                {.quantity = "stretch at the limit [-]",
                                 .reference = l,
                                 .source = source,
                                 .ours = extrapolated(&Shell::stretch),
                                 .mesh = mesh,
                                 .seconds = seconds}},
                               {}};
            }};
}

/// Radial displacement [m] of a node on the x axis.
double radial_displacement(const Run& run, double R_m) {
    return run.displacement_m[3 * nearest_node(run, {R_m, 0, 0})];
}

Problem plane_cylinder() {
    return {group, "plane-strain cylinder B/A = 2, neo-Hookean", [] {
                const auto run = run_design("verification/cylinder-neo-hookean.yaml", {});
                const double mu = run.model.materials.front().constants.at("mu").front();
                Outcome outcome;
                for (const double l : {1.5, 2.0, 3.0})
                    outcome.rows.push_back(
                        {.quantity = "pressure at a/A = " + core::number_text(l) + " [kPa]",
                         .reference = 1e-3 * neo_hookean_cylinder_pressure_Pa(mu, l, 2),
                         .source = "closed form",
                         .ours = 1e-3 * run.at("volume", *run.steps.front().volume_m3 * l * l).pressure_Pa,
                         .mesh = run.mesh,
                         .seconds = run.seconds});
                return outcome;
            }};
}

Problem thick_cylinder() {
    return {group, "plane-strain cylinder 7 / 18.625 m, Mooney-Rivlin", [] {
                constexpr double A = 7, B = 18.625, pressure_Pa = 100e6;
                const auto run = run_design("verification/cylinder-mooney-rivlin.yaml", {});
                const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
                const Cylinder cylinder{A, B, 1};
                const double l = root_of(
                    [&](double x) { return cylinder_pressure_Pa(extra_stress, cylinder, x) - pressure_Pa; }, 1.0, 2.0);
                const double outer = cylinder.deformed_radius_m(B, l) / B;
                const double in = radial_displacement(run, A), out = radial_displacement(run, B);
                const auto row = [&](const char* quantity, double reference, double ours) {
                    return Row{.quantity = quantity,
                               .reference = reference,
                               .source = "quadrature",
                               .ours = ours,
                               .mesh = run.mesh,
                               .seconds = run.seconds};
                };
                // At a free or pressurised wall the radial stress is known, and the law gives the hoop stress from the stretch.
                return Outcome{{row("inner radial displacement [m]", A * (l - 1), in),
                                row("outer radial displacement [m]", B * (outer - 1), out),
                                row("inner hoop stress [MPa]", 1e-6 * hoop_stress_Pa(extra_stress, l, -pressure_Pa),
                                    1e-6 * hoop_stress_Pa(extra_stress, 1 + in / A, -pressure_Pa)),
                                row("outer hoop stress [MPa]", 1e-6 * hoop_stress_Pa(extra_stress, outer, 0),
                                    1e-6 * hoop_stress_Pa(extra_stress, 1 + out / B, 0))},
                               {}};
            }};
}

/// Yeoh inside, neo-Hookean outside, each region with its own material.
Problem layered_cylinder() {
    return {group, "plane-strain cylinder of two rubbers, 10 / 12.5 / 20 mm", [] {
                const auto run = run_design("verification/two-layers.yaml", {});
                const auto extra_stress = [&](const char* region) {
                    return extra_stress_of(*std::ranges::find(run.model.materials, region, &model::Material::name));
                };
                Outcome outcome;
                for (const double l : {1.2, 1.5, 2.0})
                    outcome.rows.push_back(
                        {.quantity = "pressure at a/A = " + core::number_text(l) + " [kPa]",
                         .reference = 1e-3 * layered_cylinder_pressure_Pa(extra_stress("liner"), extra_stress("jacket"),
                                                                          {10e-3, 20e-3, 1}, 12.5e-3, l),
                         .source = "quadrature",
                         .ours = 1e-3 * run.at("volume", *run.steps.front().volume_m3 * l * l).pressure_Pa,
                         .mesh = run.mesh,
                         .seconds = run.seconds});
                return outcome;
            }};
}

}  // namespace

std::vector<Problem> inflation_problems() {
    std::vector<Problem> problems;
    for (const Sphere& sphere : spheres())
        problems.push_back({group, sphere.name, [sphere] { return solve_sphere(sphere); }});
    problems.push_back(thin_sphere());
    problems.push_back(plane_cylinder());
    problems.push_back(thick_cylinder());
    problems.push_back(layered_cylinder());
    return problems;
}

}  // namespace soft::verification
