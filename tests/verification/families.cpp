// Example designs of the families that bend or shorten, on coarse meshes, compared with the extrapolated values of their mesh studies
// (notes.md, "Mesh studies of the families"). There are no results of an independent code.
#include <numbers>

#include "problem.hpp"

namespace soft::verification {
namespace {

struct Study {
    const char* name;
    const char* design;
    std::vector<std::string> sets;
    const char* quantity;
    double units;      ///< factor from the SI unit of the output
    double converged;  ///< extrapolated from the study
    double tolerance;  ///< error of this mesh in the study, rounded up
};

constexpr double degrees = 180 / std::numbers::pi, millimetres = 1e3;

Problem make_problem(const Study& study) {
    return {"Families", study.name, [study] {
                auto sets = study.sets;
                sets.insert(sets.end(), {"path.control=pressure", "solver.steps=constant"});
                const auto run = run_design(study.design, sets);
                return Outcome{{{.quantity = study.quantity,
                                 .reference = study.converged,
                                 .source = "own mesh study, extrapolated",
                                 .ours = study.units * run.steps.back().outputs.at(0),
                                 .mesh = run.mesh,
                                 .seconds = run.seconds,
                                 .tolerance = study.tolerance,
                                 .reason = "the mesh is coarse; the mesh study gives its error"}},
                               {}};
            }};
}

}  // namespace

std::vector<Problem> family_problems() {
    std::vector<Problem> problems;
    for (const Study& study :
         {Study{"braided muscle shortens",
                "fiber-tube.yaml",
                {"loads.cavity.pressure=40 kPa", "solver.first_step=0.5"},
                "elongation at 40 kPa [mm]",
                millimetres,
                -4.7866,
                5e-4},
          Study{"braided muscle, quarter solid",
                "fiber-tube.yaml",
                {"loads.cavity.pressure=40 kPa", "solver.first_step=0.5", "model=quarter", "mesh.size=3 mm",
                 "mesh.sectors=3", "mesh.through_wall=2"},
                "elongation at 40 kPa [mm]",
                millimetres,
                -4.7866,
                2e-3},
          Study{"half-round muscle bends",
                "bending-fiber-tube.yaml",
                {"loads.cavity.pressure=6 kPa", "solver.first_step=1"},
                "bend at 6 kPa [deg]",
                degrees,
                6.906,
                3e-3},
          Study{"module of three chambers bends",
                "segment.yaml",
                {"loads.cavities.chamber_1.pressure=2 kPa", "solver.first_step=1"},
                "bend at 2 kPa [deg]",
                degrees,
                1.280,
                4e-3},
          Study{"finger of two chambers bends",
                "pneunet.yaml",
                {"geometry.chambers=2", "loads.cavity.pressure=0.2 kPa", "solver.first_step=1", "mesh.through_wall=2"},
                "bend at 0.2 kPa [deg]",
                degrees,
                0.4219,
                1.5e-2},
          Study{"bellows with a strip bends",
                "bending-bellows.yaml",
                {"loads.cavity.pressure=1 kPa", "solver.first_step=1", "mesh.size=2 mm", "mesh.sectors=5"},
                "bend at 1 kPa [deg]",
                degrees,
                -2.7267,
                3e-3},
          // The default meshes of solids at working pressure are within 1 %.
          Study{"finger with its default mesh",
                "pneunet.yaml",
                {"solver.first_step=0.5"},
                "bend at 3.5 kPa [deg]",
                degrees,
                12.52,
                8e-3},
          Study{"bellows with a strip and its default mesh",
                "bending-bellows.yaml",
                {"solver.first_step=0.2"},
                "bend at 4 kPa [deg]",
                degrees,
                -5.931,
                5e-3}})
        problems.push_back(make_problem(study));
    return problems;
}

}  // namespace soft::verification
