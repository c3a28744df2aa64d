// Excess stiffness of an element: pressure over the converged pressure at the same elongation.
#include "locking.hpp"
#include "core/text.hpp"
#include "table.hpp"

namespace soft::verification {
namespace {

struct Choice {
    const char* name;
    std::vector<std::string> sets;
};

/// F-bar does not support wedges, which the solid has at the axis: it is measured on the section.
const std::vector<Choice>& choices() {
    const std::string quarter = "model=quarter", first = "mesh.order=1", split = "mesh.cells=simplices";
    const std::string displacement = "mesh.formulation=displacement";
    static const std::vector<Choice> all{
        {"solid, tetrahedra, first order, displacement", {quarter, split, first, displacement}},
        {"solid, hexahedra, first order, displacement", {quarter, first, displacement}},
        {"solid, tetrahedra, second order, displacement", {quarter, split, displacement}},
        {"solid, hexahedra, second order, displacement", {quarter, displacement}},
        {"solid, tetrahedra, second order, mixed", {quarter, split}},
        {"solid, hexahedra, second order, mixed", {quarter}},
        {"section, triangles, first order, displacement", {split, first, displacement}},
        {"section, quadrilaterals, first order, displacement", {first, displacement}},
        {"section, quadrilaterals, first order, f-bar", {first, "mesh.formulation=f-bar"}},
        {"section, quadrilaterals, first order, f-bar, three cells of 1.5 mm",
         {first, "mesh.formulation=f-bar", "mesh.size=1.5 mm", "mesh.through_wall=3"}},
        {"section, quadrilaterals, second order, displacement", {displacement}},
        {"section, quadrilaterals, second order, mixed", {}}};
    return all;
}

/// The bellows with one cell through the wall, compared with its converged section.
Outcome bellows() {
    const auto section = converged_bellows();
    Table table{
        "Locking: the bellows, kappa/mu = 100",
        "Stiffness factor: pressure over that of the converged section (the rows 'bellows, open') at the same elongation, the\n"
        "cavity open. The exact shape as a quarter solid or as a section, one cell of 3 mm through the wall unless stated,\n"
        "kappa/mu = 100.",
        {"element"},
        {}};
    for (const double elongation_mm : compared_elongations_mm)
        table.header.push_back("at " + core::number_text(elongation_mm) + " mm");
    table.header.insert(table.header.end(), {"mesh", "time [s]"});
    for (const Choice& choice : choices()) {
        std::vector<std::string> sets{"mesh.size=3 mm",
                                      "mesh.through_wall=1",
                                      "mesh.sectors=4",
                                      "loads.cavity.sealed=false",
                                      "loads.cavity.pressure=60 kPa",
                                      "solver.step_accuracy=2e-3",
                                      "path.contact=ignore"};  // the walls of some of these coarse bodies touch
        sets.insert(sets.end(), choice.sets.begin(), choice.sets.end());
        const auto run = run_design("verification/bellows.yaml", sets);
        std::vector<std::string> line{choice.name};
        for (const double elongation_mm : compared_elongations_mm) {
            const double elongation_m = 1e-3 * elongation_mm;
            line.push_back(run.reaches("elongation", elongation_m)
                               ? core::rounded_text(run.at("elongation", elongation_m).pressure_Pa /
                                                        section.at("elongation", elongation_m).pressure_Pa,
                                                    4)
                               : "not reached");
        }
        line.push_back(run.mesh);
        line.push_back(core::rounded_text(run.seconds, 3));
        table.lines.push_back(line);
    }
    return {{}, {table}};
}

}  // namespace

Run converged_bellows() { return run_design("verification/bellows.yaml", {"loads.cavity.sealed=false"}); }

std::vector<Problem> locking_problems() { return {{"Locking", "Locking", bellows, Duration::slow}}; }

}  // namespace soft::verification
