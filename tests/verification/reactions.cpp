// Support reactions: the nominal stress of a bar, and the balance of loads of a finger clamped at both ends.
#include <cmath>

#include "mesh/cell_map.hpp"
#include "problem.hpp"

namespace soft::verification {
namespace {

constexpr const char* group = "Reactions";

Row row(const Run& run, const std::string& quantity, const std::string& source, double reference, double ours) {
    return {.quantity = quantity,
            .reference = reference,
            .source = source,
            .ours = ours,
            .mesh = run.mesh,
            .seconds = run.seconds,
            .tolerance = homogeneous_tolerance};
}

/// A bar of 10 x 10 mm, stretched to twice its length by a prescribed displacement. Half and quarter models must report the force of the
/// whole bar.
struct Bar {
    const char *model, *supports;  // each face that is not a symmetry plane slides in its own plane
};

Outcome bar(const Bar& bar) {
    const Run run =
        run_design("rod.yaml", {std::string{"model="} + bar.model, std::string{"supports="} + bar.supports,
                                "material.kappa=incompressible", "loads={end: {displacement: 100 mm, along: x}}",
                                "outputs={force: {face: fixed, measure: force, along: x}}"});
    const double mu = run.model.materials.front().constants.at("mu").front(), l = 2;
    return {{row(run, "force at twice the length [N]", "A mu (l - 1/l^2)", 1e-4 * mu * (l - 1 / (l * l)),
                 run.steps.back().outputs.at(0))},
            {}};
}

/// A bending finger with a blocked tip under its weight and a force: the reactions balance these loads, because the pressure in a sealed
/// cavity has no resultant.
Outcome blocked_finger() {
    const Run run = run_design(
        "pneunet.yaml",
        {"geometry.chambers=2", "mesh={size: 4 mm, through_wall: 1, grading: 1}", "material.density=1080 kg/m^3",
         "supports={fixed: [fixed, tip]}",
         "loads={cavity: {pressure: 2 kPa}, bottom: {force: 0.02 N, along: x}, gravity: {acceleration: 9.81 m/s^2, along: -z}}",
         "outputs={root_x: {face: fixed, measure: force, along: x}, root_z: {face: fixed, measure: force, along: z}, "
         "tip_x: {face: tip, measure: force, along: x}, tip_z: {face: tip, measure: force, along: z}}"});
    const auto& outputs = run.steps.back().outputs;
    const double weight = 1080 * 9.81 * mesh::measure(run.model.mesh, mesh::Measure::plain) / run.model.model_fraction;
    Row along = row(run, "sum along the finger [N]", "the force applied", 0.02, outputs.at(0) + outputs.at(2));
    Row down = row(run, "sum across the finger [N]", "weight from the volume", -weight, outputs.at(1) + outputs.at(3));
    along.tolerance = down.tolerance = 1e-8;
    return {{along, down}, {}};
}

}  // namespace

std::vector<Problem> reaction_problems() {
    std::vector<Problem> problems;
    for (const Bar& one : {Bar{"solid", "{x: fixed, y: left, z: bottom}"}, Bar{"half", "{x: fixed, z: bottom}"},
                           Bar{"quarter", "{x: fixed}"}})
        problems.push_back(
            {group, std::string{"bar under prescribed displacement, "} + one.model, [one] { return bar(one); }});
    problems.push_back({group, "finger clamped at root and tip", blocked_finger});
    return problems;
}

}  // namespace soft::verification
