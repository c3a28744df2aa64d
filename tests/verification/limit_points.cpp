// Control auto: sphere and tube past their limit points to ten times their volume; a long tube in which a bulge forms, grows and
// propagates.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "inflation_formula.hpp"
#include "problem.hpp"
#include "table.hpp"
#include "two_phase_tube.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Inflation";
constexpr double last_ratio = 10;

Row ratio_row(const Run& run) {
    return {.quantity = "V/V0 at the end [-]",
            .reference = last_ratio,
            .source = "the design",
            .ours = *run.steps.back().volume_m3 / *run.steps.front().volume_m3,
            .mesh = run.mesh,
            .seconds = run.seconds,
            .tolerance = 1e-8};
}

Outcome sphere() {
    const auto run = run_design("verification/sphere-neo-hookean.yaml",
                                {"path.control=auto", "path.until.volume_ratio=" + core::number_text(last_ratio)});
    const double mu = run.model.materials.front().constants.at("mu").front(), V0 = *run.steps.front().volume_m3;
    const auto exact = [mu](double l) { return neo_hookean_sphere_pressure_Pa(mu, l, 2); };
    Outcome outcome{{ratio_row(run)}, {}};
    const auto add = [&](const std::string& quantity, double reference, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = "closed form",
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    for (const double ratio : {1.5, 3.0, 6.0, 9.0})
        add("pressure at V/V0 = " + core::number_text(ratio) + " [kPa]", 1e-3 * exact(std::cbrt(ratio)),
            1e-3 * run.at("volume", ratio * V0).pressure_Pa);
    const auto peak = first_peak(exact, 1.001, 3);
    add("limit pressure [kPa]", 1e-3 * peak.value, 1e-3 * run.end.limit_points.at(0).pressure_Pa);
    add("V/V0 at the limit [-]", std::pow(peak.location, 3), *run.end.limit_points.at(0).volume_m3 / V0);
    return outcome;
}

/// The results of the tube (actuators.cpp) under control auto.
Outcome tube() {
    const auto run = run_design("verification/tube.yaml",
                                {"path.control=auto", "path.until.volume_ratio=" + core::number_text(last_ratio)});
    Outcome outcome{{ratio_row(run)}, {}};
    const auto add = [&](const char* quantity, double reference, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = "independent code",
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    add("elongation at 40 kPa [mm]", 5.8978, 1e3 * run.at("pressure", 40e3).outputs.at(0));
    const auto& limit = run.end.limit_points.at(0);
    add("limit pressure [kPa]", 44.3387, 1e-3 * limit.pressure_Pa);
    add("elongation at the limit [mm]", 13.45, 1e3 * limit.outputs.at(0));
    return outcome;
}

/// Hoop stretch of the inner wall at an axial position of the undeformed tube.
double inner_hoop(const Run& run, double x_m, double inner_m) {
    const auto node = nearest_node(run, {x_m, inner_m, 0});
    return 1 + run.displacement_m[3 * node + 1] / run.model.mesh.points[node][1];
}

struct Balloon {
    double length_m;
    const char* size;
};

Run blown_up(const Balloon& balloon) {  // one cell through the wall: membrane stretch dominates bending
    return run_design("balloon.yaml", {"geometry.length=" + core::number_text(1e3 * balloon.length_m) + " mm",
                                       std::string("mesh.size=") + balloon.size, "mesh.through_wall=1"});
}

std::vector<std::string> study_line(const Balloon& balloon, const Run& run) {
    double minimum = run.steps.back().pressure_Pa;
    bool past_limit = false;
    for (const auto& step : run.steps) {
        past_limit = past_limit || step.tangent_pressure * step.tangent_volume < 0;
        if (past_limit) minimum = std::min(minimum, step.pressure_Pa);
    }
    return {core::number_text(1e3 * balloon.length_m), balloon.size, printed_number(1e-3 * minimum),
            printed_number(run.pressure_kPa())};
}

/// The bulge propagates as volume is added: at V/V0 = 10 its two fronts are far from each other and from the caps.
Outcome balloon() {
    constexpr double inner_m = 9e-3, outer_m = 10e-3;
    Table study{"bulging balloon: mesh study",
                "Pressure [kPa] of the spreading bulge: the minimum after the limit point, and the value at V/V0 = 10.",
                {"length [mm]", "cells", "minimum [kPa]", "at V/V0 = 10 [kPa]"},
                {}};
    for (const Balloon& shorter : {Balloon{200e-3, "2 mm"}, Balloon{200e-3, "1 mm"}})
        study.lines.push_back(study_line(shorter, blown_up(shorter)));
    const Balloon longest{300e-3, "2 mm"};
    const auto run = blown_up(longest);
    study.lines.push_back(study_line(longest, run));

    const auto& constants = run.model.materials.front().constants;
    const GentTube tube{constants.at("mu").front(), constants.at("jm").front(), inner_m, outer_m};
    const auto pressure = [&](double l) { return even_tube(tube, l).pressure_Pa; };
    const auto maximum = first_peak(pressure, 1.001, 2.5);
    const auto minimum = first_peak([&](double l) { return -pressure(l); }, maximum.location + 0.1, 4);
    const auto line = coexistence(tube, maximum.location, minimum.location);

    Outcome outcome{{ratio_row(run)}, {study}};
    const auto add = [&](const char* quantity, double reference, double ours) {
        outcome.rows.push_back({.quantity = quantity,
                                .reference = reference,
                                .source = "Maxwell line by quadrature (Chater, Hutchinson)",
                                .ours = ours,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    };
    add("pressure of the spreading bulge, at V/V0 = 10 [kPa]", 1e-3 * line.pressure_Pa, run.pressure_kPa());
    double largest = 0, x_m = 0;
    for (std::size_t node = 0; node < run.model.mesh.points.size(); ++node) {
        const auto& p = run.model.mesh.points[node];
        if (std::abs(p[1] - inner_m) > 1e-9) continue;
        const double hoop = 1 + run.displacement_m[3 * node + 1] / p[1];
        if (hoop > largest) largest = hoop, x_m = p[0];
    }
    const auto relax_tolerance = [&] {
        outcome.rows.back().tolerance = 5e-3;
        outcome.rows.back().reason =
            "at V/V0 = 10 the bulge and the rest are only ten radii long each, and the fronts between them still influence their middles";
    };
    add("a/A in the bulge [-]", line.bulge.inner_stretch, largest);
    relax_tolerance();
    // The position farthest from the bulge outside the influence of the caps.
    constexpr double away_from_cap_m = 40e-3;
    const double far_m = x_m < 0.5 * longest.length_m ? longest.length_m - away_from_cap_m : away_from_cap_m;
    add("a/A outside the bulge [-]", line.thin.inner_stretch, inner_hoop(run, far_m, inner_m));
    relax_tolerance();
    return outcome;
}

}  // namespace

std::vector<Problem> limit_point_problems() {
    return {{group, "sphere B/A = 2 to V/V0 = 10, control auto", sphere},
            {group, "closed tube to V/V0 = 10, control auto", tube},
            {group, "bulging balloon (Gent), spreading bulge", balloon}};
}

}  // namespace soft::verification
