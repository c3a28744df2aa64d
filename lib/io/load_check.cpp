#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/checker.hpp"

namespace soft::io {
namespace {

using core::quoted;

template <class List>
bool has_name(const List& list, const std::string& name) {
    return std::any_of(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
}

bool acts_on_cavities(const model::Case& input, const model::PressureLoad& load) {
    return has_name(input.cavities, load.targets.front());
}

void check_cavities(const Checker& check) {
    const auto& cavities = check.model().cavities;
    check.require_unique(cavities, "/loads/cavities", [](const model::Cavity& cavity) { return cavity.name; });
    for (const model::Cavity& cavity : cavities) {
        const std::string location = "/loads/cavities/" + cavity.name;
        check.require_face(cavity.wall, location + "/wall");
        for (std::size_t i = 0; i < cavity.inner_faces.size(); ++i)
            check.require_face(cavity.inner_faces[i], Checker::item(location + "/inner_faces", i));
        for (std::size_t i = 0; i < cavity.openings.size(); ++i) {
            const model::Opening& opening = cavity.openings[i];
            check.require_face(opening.face, Checker::item(location + "/openings/face", i));
            check.require_positive(opening.area_m2, Checker::item(location + "/openings/area", i));
            check.require_unit(opening.direction, Checker::item(location + "/openings/direction", i));
        }
    }
}

/// The targets must be cavities that no other load has, or a single face.
void check_targets(const Checker& check, const model::PressureLoad& load, std::vector<std::string>& taken) {
    const std::string location = "/loads/targets/name";
    const model::Case& input = check.model();
    if (load.targets.empty()) check.refuse(location, "the load " + quoted(load.name) + " has no target");
    for (const std::string& target : load.targets) {
        const bool cavity = has_name(input.cavities, target);
        check.require(cavity || input.mesh.facet_sets.contains(target), location,
                      "there is no cavity or face named " + quoted(target));
        check.require(cavity || load.targets.size() == 1, location,
                      quoted(target) + " of the load " + quoted(load.name) + " is not a cavity");
        if (!cavity) check.require_face(target, location);
        if (cavity && std::find(taken.begin(), taken.end(), target) != taken.end())
            check.refuse(location, "the cavity " + quoted(target) + " is loaded twice");
        taken.push_back(target);
    }
}

void check_pressures(const Checker& check) {
    const auto& loads = check.model().loads;
    check.require_unique(loads, "/loads/name", [](const model::PressureLoad& load) { return load.name; });
    std::vector<std::string> taken;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        check_targets(check, loads[i], taken);
        const model::Gas& gas = loads[i].gas;
        check.require_positive(gas.ambient_Pa, Checker::item("/loads/ambient_pressure", i));
        check.require_positive(gas.ambient_density_kg_m3, Checker::item("/loads/ambient_density", i));
        check.require_positive(gas.exponent, Checker::item("/loads/exponent", i));
        check.require(std::isfinite(gas.dead_volume_m3) && gas.dead_volume_m3 >= 0,
                      Checker::item("/loads/dead_volume", i), "must not be negative");
        check_time_function(check, loads[i].time_function, "/loads", i);
        if (!loads[i].line) continue;
        check.require_positive(loads[i].line->resistance_Pa_s_m3, Checker::item("/loads/line_resistance", i));
        check.require(acts_on_cavities(check.model(), loads[i]), Checker::item("/loads/line_resistance", i),
                      "the load " + quoted(loads[i].name) + " acts on a face, so it cannot have a supply line");
    }
}

void check_forces(const Checker& check) {
    const model::Case& input = check.model();
    for (std::size_t i = 0; i < input.tractions.size(); ++i) {
        check.require_face(input.tractions[i].face, Checker::item("/loads/tractions/face", i));
        for (const double component : input.tractions[i].traction_Pa)
            check.require_finite(component, Checker::item("/loads/tractions/traction", i));
        check.require(std::isfinite(input.tractions[i].area_m2) && input.tractions[i].area_m2 >= 0,
                      Checker::item("/loads/tractions/area", i), "must not be negative");
        check_time_function(check, input.tractions[i].time_function, "/loads/tractions", i);
    }
    check.require_unique(input.body_forces, "/loads/body_forces/name",
                         [](const model::BodyForce& force) { return force.name; });
    for (std::size_t i = 0; i < input.body_forces.size(); ++i) {
        const std::string location = Checker::item("/loads/body_forces/acceleration", i);
        const auto& acceleration = input.body_forces[i].acceleration_m_s2;
        for (const double component : acceleration) check.require_finite(component, location);
        if (input.kinematics == model::Kinematics::axisymmetric)
            check.require(acceleration[1] == 0 && acceleration[2] == 0, location, "does not point along the axis");
        check_time_function(check, input.body_forces[i].time_function, "/loads/body_forces", i);
    }
}

void check_motions(const Checker& check) {
    const auto& motions = check.model().motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        check.require_face(motions[i].face, Checker::item("/loads/motions/face", i));
        const auto& components = motions[i].displacement_m;
        for (const auto& component : components)
            check.require_finite(component.value_or(0), Checker::item("/loads/motions/displacement", i));
        check.require(std::any_of(components.begin(), components.end(), [](const auto& c) { return c.has_value(); }),
                      Checker::item("/loads/motions/moved", i), "prescribes no component");
    }
}

void check_point(const Checker& check, const model::Output& output, std::size_t i) {
    for (const double coordinate : *output.point_m)
        check.require_finite(coordinate, Checker::item("/outputs/point", i));
    check.require(output.face.empty(), Checker::item("/outputs/face", i), "must be empty where a point is measured");
    check.require(output.measure == model::Measure::displacement, Checker::item("/outputs/measure", i),
                  "must be displacement where a point is measured");
}

void check_outputs(const Checker& check) {
    const auto& outputs = check.model().outputs;
    check.require_unique(outputs, "/outputs/name", [](const model::Output& output) { return output.name; });
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const model::Output& output = outputs[i];
        if (output.point_m)
            check_point(check, output, i);
        else
            check.require_face(output.face, Checker::item("/outputs/face", i));
        check.require_unit(output.direction, Checker::item("/outputs/direction", i));
        const std::string location = Checker::item("/outputs/reference", i);
        if (output.measure == model::Measure::bend)
            check.require_face(output.reference, location);
        else
            check.require(output.reference.empty(), location, "must be empty: only a bend has a reference face");
    }
}

void check_stop_conditions(const Checker& check, const model::Stage& stage, const std::string& location) {
    constexpr std::array<std::string_view, 3> quantities{"pressure", "volume_ratio", "steps"};
    const model::Case& input = check.model();
    for (std::size_t i = 0; i < stage.until.size(); ++i) {
        const model::Until& until = stage.until[i];
        const bool known = std::find(quantities.begin(), quantities.end(), until.quantity) != quantities.end() ||
                           has_name(input.outputs, until.quantity);
        check.require(known, Checker::item(location + "/until/quantity", i),
                      "there is no output named " + quoted(until.quantity));
        check.require_finite(until.value, Checker::item(location + "/until/value", i));
    }
    const std::string controlled = location + "/controlled";
    if (stage.controlled.empty()) return;
    const bool load = has_name(input.loads, stage.controlled), output = has_name(input.outputs, stage.controlled);
    switch (stage.control) {
        case model::Control::volume:
            check.require(load, controlled, "there is no load named " + quoted(stage.controlled));
            return;
        case model::Control::displacement:
            check.require(output, controlled, "there is no output named " + quoted(stage.controlled));
            return;
        case model::Control::automatic:
        case model::Control::pressure:
        case model::Control::arc_length:
            check.require(load || output, controlled, "there is no load or output named " + quoted(stage.controlled));
    }
}

void check_supply(const Checker& check, const model::PressureLoad& load, const model::SupplyTarget& supply,
                  const std::string& location) {
    check.require_finite(supply.value, location);
    const bool gas = supply.what == model::Prescription::mass || supply.what == model::Prescription::closed;
    const bool volume = supply.what == model::Prescription::volume || supply.what == model::Prescription::volume_ratio;
    check.require(!(gas || volume) || acts_on_cavities(check.model(), load), location,
                  "the load " + quoted(load.name) + " acts on a face, so only its pressure can be prescribed");
    if (volume) check.require_positive(supply.value, location);
}

void check_levels(const Checker& check, const std::vector<double>& levels, std::size_t loads,
                  const std::string& location) {
    check.require(levels.size() == loads, location, "must have one entry per load");
    for (std::size_t i = 0; i < levels.size(); ++i) check.require_finite(levels[i], Checker::item(location, i));
}

void check_stage(const Checker& check, const model::Stage& stage, const std::string& location) {
    const model::Case& input = check.model();
    check_stop_conditions(check, stage, location);
    check.require(stage.supplies.size() == input.loads.size(), location + "/prescription",
                  "must have one entry per load");
    for (std::size_t i = 0; i < stage.supplies.size(); ++i)
        check_supply(check, input.loads[i], stage.supplies[i], Checker::item(location + "/value", i));
    check_levels(check, stage.tractions, input.tractions.size(), location + "/tractions");
    check_levels(check, stage.body_forces, input.body_forces.size(), location + "/body_forces");
    check_levels(check, stage.motions, input.motions.size(), location + "/motions");
}

void check_frequencies(const Checker& check) {
    const model::Case& input = check.model();
    const int count = input.path.frequencies;
    const std::string location = "/control/frequencies";
    check.require(count >= 0 && count <= model::max_frequencies, location, "must be between 0 and 50");
    if (count == 0) return;
    check.require(!input.dynamics, location, "must be 0 in a dynamic case");
    for (const model::Material& material : input.materials)
        check.require(material.density_kg_m3.has_value(), "/materials/" + material.name + "/density",
                      "is missing, but natural frequencies require it");
}

}  // namespace

void check_loads(const Checker& check) {
    check_cavities(check);
    check_pressures(check);
    check_forces(check);
    check_motions(check);
    check_outputs(check);
}

void check_path(const Checker& check) {
    const model::PathSettings& path = check.model().path;
    check.require(!path.stages.empty(), "/control/stages", "there is no stage");
    if (path.stages.size() > 1)
        check.require_unique(path.stages, "/control/stages", [](const model::Stage& stage) { return stage.name; });
    for (std::size_t i = 0; i < path.stages.size(); ++i)
        check_stage(check, path.stages[i], "/control/stages/" + std::to_string(i));
    check.require_positive(path.imperfection_m, "/control/imperfection");
    check.require(std::isfinite(path.stretch_limit) && path.stretch_limit > 1, "/control/stretch_limit",
                  "must be greater than 1");
    check_frequencies(check);
    check_settings(check);
}

}  // namespace soft::io
