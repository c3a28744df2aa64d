// The actuators of the specification compared with results of an independent code.
#include <array>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "problem.hpp"
#include "work.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Actuators";

struct Bellows {
    const char* name;
    std::vector<std::string> sets;
    const char* error;                  ///< of the results of the independent code
    std::vector<double> pressures_kPa;  ///< at 20, 40, 80, 130 mm
    bool closed;                        ///< the pressure acts on the whole surface of the measured volume
};

Outcome solve_bellows(const Bellows& bellows) {
    const auto run = run_design("verification/bellows.yaml", bellows.sets, Energy::recorded);
    const std::vector<double> elongations_mm{20, 40, 80, 130};
    Outcome outcome;
    for (std::size_t i = 0; i < elongations_mm.size(); ++i)
        outcome.rows.push_back({.quantity = "pressure at " + core::number_text(elongations_mm[i]) + " mm [kPa]",
                                .reference = bellows.pressures_kPa[i],
                                .source = std::string("independent code (") + bellows.error + " %)",
                                .ours = 1e-3 * run.at("elongation", 1e-3 * elongations_mm[i]).pressure_Pa,
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    if (!bellows.closed) return outcome;
    outcome.rows.push_back(work_row(run));
    outcome.rows.back().tolerance = 2e-3;
    outcome.rows.back().reason =
        "follows from the definition of the plug: its thrust is p times the undeformed area of the bore, on the mean motion of its face, "
        "while the volume is closed at the rim, where the bore has widened; the difference is the same for every mesh and step size";
    return outcome;
}

/// Elongation of the tube from the independent code, to four decimals.
struct TubePoint {
    double pressure_kPa, elongation_mm;
};

Outcome solve_tube() {
    const auto run = run_design("verification/tube.yaml", {}, Energy::recorded);
    const char* source = "independent code";
    Outcome outcome;
    for (const auto& [pressure_kPa, elongation_mm] :
         {TubePoint{10, 0.2817}, TubePoint{20, 0.9168}, TubePoint{30, 2.2875}, TubePoint{40, 5.8978}})
        outcome.rows.push_back({.quantity = "elongation at " + core::number_text(pressure_kPa) + " kPa [mm]",
                                .reference = elongation_mm,
                                .source = source,
                                .ours = 1e3 * run.at("pressure", 1e3 * pressure_kPa).outputs.at(0),
                                .mesh = run.mesh,
                                .seconds = run.seconds});
    const auto& limit = run.end.limit_points.at(0);
    outcome.rows.push_back({.quantity = "limit pressure [kPa]",
                            .reference = 44.3387,
                            .source = source,
                            .ours = 1e-3 * limit.pressure_Pa,
                            .mesh = run.mesh,
                            .seconds = run.seconds});
    outcome.rows.push_back({.quantity = "elongation at the limit [mm]",
                            .reference = 13.45,
                            .source = source,
                            .ours = 1e3 * limit.outputs.at(0),
                            .mesh = run.mesh,
                            .seconds = run.seconds});
    outcome.rows.push_back(work_row(run));
    return outcome;
}

/// The tube with other elements. Coarse solids are too stiff at the clamped rim and the inner corners, which are singular.
struct TubeMesh {
    const char* name;
    std::vector<std::string> sets;
    double tolerance;
    const char* reason;
};

Outcome solve_tube_mesh(const TubeMesh& mesh) {
    auto sets = mesh.sets;
    sets.push_back("path.until.pressure=30 kPa");
    const auto run = run_design("verification/tube.yaml", sets);
    return {{{.quantity = "elongation at 30 kPa [mm]",
              .reference = 2.2875,
              .source = "independent code",
              .ours = run.output_mm(),
              .mesh = run.mesh,
              .seconds = run.seconds,
              .tolerance = mesh.tolerance,
              .reason = mesh.reason}},
            {}};
}

// A long prism with closed ends under internal pressure, linear elasticity, far from its ends (derived here). The section is that of
// designs/verification/pneunet-long.yaml. Only two moments of the in-plane stresses are needed. They follow from virtual work with the
// displacements (y, z) and (y z, (z^2 - y^2)/2), whose strains are 1 and z times the unit tensor,
//     int (s_yy + s_zz) dA = 2 p A,    int (s_yy + s_zz) z dA = 2 p A c      (A, c: area and centroid of the hole).
// With s_xx = E (e + k z) + nu (s_yy + s_zz), int s_xx dA = p A and int s_xx z dA = p A c, at equal nu of all layers:
//     int E (e + k z) dA = (1 - 2 nu) p A,    int E (e + k z) z dA = (1 - 2 nu) p A c.
// An incompressible prism neither elongates nor bends to first order. Q2 meshes contain both displacements, so any mesh is exact.
struct Prism {
    double pressure_Pa, poisson;
    struct Layer {
        double low_m, high_m, width_m, young_Pa;  ///< negative for the hole
    };
    std::vector<Layer> layers;
    Layer hole;

    struct Strain {
        double at_zero, curvature_1_m;
    };
    [[nodiscard]] Strain strain() const {
        std::array<double, 3> moment{};  // int E z^n dA
        for (const Layer& l : layers)
            for (std::size_t n = 0; n < 3; ++n) {
                const double power = static_cast<double>(n) + 1;
                moment[n] += l.young_Pa * l.width_m * (std::pow(l.high_m, power) - std::pow(l.low_m, power)) / power;
            }
        const double force = (1 - 2 * poisson) * pressure_Pa * hole.width_m * (hole.high_m - hole.low_m);
        const double torque = force * 0.5 * (hole.low_m + hole.high_m);
        const double determinant = moment[0] * moment[2] - moment[1] * moment[1];
        return {(force * moment[2] - torque * moment[1]) / determinant,
                (torque * moment[0] - force * moment[1]) / determinant};
    }
};

/// Two lengths have the same end effects: their difference is that of a beam.
Outcome solve_long_finger() {
    constexpr double short_m = 100e-3, long_m = 140e-3, tip_middle_m = 4.5e-3;
    const auto run = [](double length_m) {
        return run_design("verification/pneunet-long.yaml",
                          {"geometry.chamber_length=" + core::number_text(1e3 * length_m) + " mm"});
    };
    const Run one = run(short_m), other = run(long_m);
    constexpr double base_m = 3e-3, top_m = 12e-3, width_m = 12e-3, strip_m = 1e-3, young_Pa = 1e6, strip_Pa = 5e6;
    const Prism::Layer hole{base_m, 9e-3, 6e-3, -young_Pa};
    const Prism prism{10, 0.3, {{0, strip_m, width_m, strip_Pa}, {strip_m, top_m, width_m, young_Pa}, hole}, hole};
    const auto [strain, curvature_1_m] = prism.strain();
    const auto row = [&](const char* quantity, double reference, double ours) {
        return Row{.quantity = quantity,
                   .reference = reference,
                   .source = "closed form: virtual work on the section",
                   .ours = ours,
                   .mesh = other.mesh,
                   .seconds = one.seconds + other.seconds,
                   .tolerance = homogeneous_tolerance};
    };
    const auto more = [&](std::size_t output) {
        return other.steps.back().outputs.at(output) - one.steps.back().outputs.at(output);
    };
    return {
        {row("additional bend for 40 mm more chamber [urad]", 1e6 * curvature_1_m * (long_m - short_m), 1e6 * more(0)),
         row("additional elongation for 40 mm more chamber [nm]",
             1e9 * (strain + curvature_1_m * tip_middle_m) * (long_m - short_m), 1e9 * more(1))},
        {}};
}

/// The same for a section whose centroid lies on the axis and whose second moment of area I is equal about all diameters, as with three
/// equal chambers: strain (1 - 2 nu) p A / (E A_rubber), curvature (1 - 2 nu) p A c / (E I).
Outcome solve_long_segment() {
    constexpr double short_m = 120e-3, long_m = 160e-3;
    const auto run = [](double length_m) {
        return run_design("verification/segment-long.yaml",
                          {"geometry.length=" + core::number_text(1e3 * length_m) + " mm"});
    };
    const Run one = run(short_m), other = run(long_m);
    constexpr double pi = std::numbers::pi, bore_m = 3e-3, inside_m = 5e-3, outside_m = 10e-3, outer_m = 12e-3;
    constexpr double angle = pi / 2, load = (1 - 2 * 0.3) * 10 / 1e6;  // (1 - 2 nu) p / E; 120 less 30 degrees
    const auto difference = [](double high, double low, int power) {
        return std::pow(high, power) - std::pow(low, power);
    };
    const double hole_m2 = 0.5 * angle * difference(outside_m, inside_m, 2);
    const double hole_m3 = 2.0 / 3.0 * std::sin(0.5 * angle) * difference(outside_m, inside_m, 3);  // A c
    const double rubber_m2 = pi * difference(outer_m, bore_m, 2) - 3 * hole_m2;
    const double second_m4 =
        0.25 * pi * difference(outer_m, bore_m, 4) - 3 * 0.125 * angle * difference(outside_m, inside_m, 4);
    const auto row = [&](const char* quantity, double reference, std::size_t output) {
        return Row{.quantity = quantity,
                   .reference = reference,
                   .source = "closed form: virtual work on the section",
                   .ours = 1e6 * (other.steps.back().outputs.at(output) - one.steps.back().outputs.at(output)),
                   .mesh = other.mesh,
                   .seconds = one.seconds + other.seconds};
    };
    return {
        {row("additional bend for 40 mm more length [urad]", 1e6 * load * hole_m3 / second_m4 * (long_m - short_m), 0),
         row("additional elongation for 40 mm more length [um]", 1e6 * load * hole_m2 / rubber_m2 * (long_m - short_m),
             1)},
        {}};
}

}  // namespace

std::vector<Problem> actuator_problems() {
    const std::vector<std::string> open{"loads.cavity.sealed=false"};
    std::vector<Problem> problems;
    for (const Bellows& bellows :
         {Bellows{"bellows, open", open, "0.01", {1.38862, 3.31042, 10.06423, 26.49325}, false},
          Bellows{"bellows, open, incompressible",
                  {open.front(), "material.kappa=incompressible"},
                  "0.03",
                  {1.40115, 3.33858, 10.14409, 26.73582},
                  false},
          Bellows{"bellows, sealed", {}, "0.04", {1.30717, 3.10447, 9.33862, 24.69085}, true}})
        problems.push_back({group, bellows.name, [bellows] { return solve_bellows(bellows); }});
    problems.push_back({group, "closed tube", solve_tube});
    const char* corners =
        "the clamped rim and the inner corners are singular, and every element converges there with first order";
    for (const TubeMesh& mesh :
         {TubeMesh{"closed tube, triangles", {"mesh.cells=simplices", "mesh.size=0.5 mm"}, 1.5e-3, corners},
          TubeMesh{"closed tube, quarter solid, hexahedra",
                   {"model=quarter", "mesh.size=2.5 mm", "mesh.sectors=3"},
                   5e-3,
                   corners},
          TubeMesh{"closed tube, quarter solid, tetrahedra",
                   {"model=quarter", "mesh.size=2.5 mm", "mesh.sectors=3", "mesh.cells=simplices"},
                   1e-2,
                   corners}})
        problems.push_back({group, mesh.name, [mesh] { return solve_tube_mesh(mesh); }});
    problems.push_back({group, "bending finger, one long chamber", solve_long_finger});
    problems.push_back({group, "segment, one of three long chambers", solve_long_segment});
    return problems;
}

std::vector<Problem> work_problems() {
    return {{"Actuators", "thick sphere, work", [] {
                 const auto run = run_design("verification/sphere-neo-hookean.yaml", {}, Energy::recorded);
                 return Outcome{{work_row(run)}, {}};
             }}};
}

}  // namespace soft::verification
