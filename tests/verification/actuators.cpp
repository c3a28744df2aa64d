// The actuators of the specification against numbers from an independent code.
#include "core/text.hpp"
#include "problem.hpp"
#include "work.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Actuators";

struct Bellows {
    const char* name;
    std::vector<std::string> sets;
    const char* error;                  ///< of the independent code's numbers
    std::vector<double> pressures_kPa;  ///< at 20, 40, 80, 130 mm
    bool closed;                        ///< the pressure acts all around the volume that is measured
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
        "by the definition of the plug: its thrust is p times the undeformed area of the bore, on the mean motion of its face, "
        "while the volume is closed at the rim, where the bore has widened; the same at every mesh and step size";
    return outcome;
}

/// An elongation of the tube from the independent code, given to four decimals.
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

/// The tube by another element; coarse solids are stiff at the held rim and the inner corners, which are singular.
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
        "the held rim and the inner corners are singular, and every element converges there at first order";
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
    return problems;
}

std::vector<Problem> work_problems() {
    return {{"Actuators", "thick sphere, work", [] {
                 const auto run = run_design("verification/sphere-neo-hookean.yaml", {}, Energy::recorded);
                 return Outcome{{work_row(run)}, {}};
             }}};
}

}  // namespace soft::verification
