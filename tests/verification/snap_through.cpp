// Snap-through of a thin clamped cap: both limit pressures compared with thin-shell theory. The error of the theory has three parts. It is
// of the order of t/R (1 t/R because the pressure acts on the outer face, which is larger than the middle surface). It is of the order
// of the strain, here angle^2 / 4, which is of order t/R too. And it is of the order of the part of the meridian next to the clamped face
// where the rubber is not in plane stress, (t/R)^(1/2) with a small factor. A study over R/t at fixed lambda shows that the difference
// vanishes.
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "problem.hpp"
#include "snapping_cap.hpp"
#include "table.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Snap-through";
constexpr const char* design = "verification/dome-thin.yaml";
constexpr double degree = std::numbers::pi / 180;

struct Dome {
    double thickness_mm, radius_mm, angle_deg;
    int through_wall = 1;
    double size_mm = 1;
};

Cap cap_of(const Dome& dome, const Run& run) {
    const double mu = run.model.materials.front().constants.at("mu").front();
    return {1e-3 * dome.radius_mm, 1e-3 * dome.thickness_mm, dome.angle_deg * degree, 3 * mu, 0.5};
}

Run pressed(const Dome& dome) {
    const double part = dome.thickness_mm / dome.radius_mm;  // pressures scale with (t/R)^2
    return run_design(design, {"geometry.radius=" + core::number_text(dome.radius_mm) + " mm",
                               "geometry.thickness=" + core::number_text(dome.thickness_mm) + " mm",
                               "geometry.angle=" + core::number_text(dome.angle_deg) + " deg",
                               "mesh.size=" + core::number_text(dome.size_mm) + " mm",
                               "mesh.through_wall=" + std::to_string(dome.through_wall),
                               "loads.outer.pressure=" + core::number_text(2.5e6 * part * part) + " Pa"});
}

std::string percent(double ours, double reference) {
    return core::number_text(std::round(1e4 * (ours / reference - 1)) / 100);
}

Outcome solve_thin_cap() {
    constexpr int states = 200;
    Table study{
        "thin clamped cap: vanishing thickness",
        "Limit pressures over the buckling pressure of the whole sphere, 2 E (t/R)^2 / (3 (1 - nu^2))^(1/2), for caps\n"
        "of lambda = 3.99, and their difference from thin-shell theory.",
        {"R/t", "cells through the wall, length [t]", "upper [-]", "difference from theory [%], upper", "lower [-]",
         "difference from theory [%], lower"},
        {}};
    Outcome outcome;
    for (const Dome& dome : {Dome{1, 125, 11.8}, Dome{1, 500, 5.9}, Dome{1, 500, 5.9, 2, 0.5}, Dome{1, 2000, 2.95}}) {
        const auto run = pressed(dome);
        const Cap cap = cap_of(dome, run);
        const auto theory = snap_pressures(cap, states);
        const double upper = run.end.limit_points.at(0).pressure_Pa, lower = run.end.limit_points.at(1).pressure_Pa;
        study.lines.push_back(
            {core::number_text(dome.radius_mm / dome.thickness_mm),
             std::to_string(dome.through_wall) + ", " + core::number_text(dome.size_mm),
             printed_number(upper / cap.classical_pressure_Pa()), percent(upper, theory.upper.pressure_Pa),
             printed_number(lower / cap.classical_pressure_Pa()), percent(lower, theory.lower.pressure_Pa)});
        if (dome.radius_mm != 500 || dome.through_wall != 1) continue;
        const auto add = [&](const char* quantity, double reference, double ours) {
            outcome.rows.push_back(
                {.quantity = quantity,
                 .reference = reference,
                 .source = "Reissner's equations of thin shells, shooting",
                 .ours = ours,
                 .mesh = run.mesh,
                 .seconds = run.seconds,
                 .tolerance = 5e-3,
                 .reason = "the theory neglects terms of the order of t/R = 0.2 % and of the strain, 0.3 %, and the "
                           "effect of the clamped face on the adjacent rubber"});
        };
        add("upper limit pressure [Pa]", theory.upper.pressure_Pa, upper);
        add("lower limit pressure [Pa]", theory.lower.pressure_Pa, lower);
    }
    outcome.tables.push_back(study);
    return outcome;
}

}  // namespace

std::vector<Problem> snap_problems() { return {{group, "thin clamped cap", solve_thin_cap}}; }

}  // namespace soft::verification
