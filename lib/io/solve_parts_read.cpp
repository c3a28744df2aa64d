#include "core/text.hpp"
#include "io/columns.hpp"
#include "io/names.hpp"
#include "io/settings_io.hpp"
#include "io/solve_parts.hpp"

namespace soft::io {
namespace {

std::vector<model::Material> read_materials(const GroupReader& group) {
    std::vector<model::Material> materials;
    for (const std::string& name : ordered_names(group)) {
        const GroupReader one = group.group(name);
        model::Material& material = materials.emplace_back();
        material.name = name;
        material.law = one.text("law");
        if (one.has("source")) material.source = one.text("source");
        material.volumetric = one.word("volumetric", volumetric_names);
        material.strain = one.word("strain", strain_names);
        material.fiber_frame = one.word("fiber_frame", fiber_frame_names);
        if (one.has("bulk_modulus")) material.bulk_modulus_Pa = one.number("bulk_modulus");
        if (one.has("density")) material.density_kg_m3 = one.number("density");
        if (one.has("fibers")) {
            const GroupReader fibers = one.group("fibers");
            material.fibers = model::Fibers{fibers.number("angle"), fibers.number("k1"), fibers.number("k2"),
                                            fibers.int_count("families", 1)};
        }
        const GroupReader constants = one.group("constants");
        for (const std::string& key : constants.names()) material.constants[key] = constants.array<double>(key, {any});
    }
    return materials;
}

std::vector<model::PressureLoad> read_pressures(const GroupReader& group) {
    const auto names = group.texts("name");
    const std::int64_t count = extent(names.size());
    const auto sealed = group.flags("sealed", {count});
    const auto thrusts = group.flags("plug_thrust", {count});
    const auto ambients = group.array<double>("ambient_pressure", {count});
    const auto densities = group.array<double>("ambient_density", {count});
    const auto dead_volumes = group.array<double>("dead_volume", {count});
    const auto exponents = group.array<double>("exponent", {count});
    const auto shapes = read_words(group, "shape", load_shape_names, count);
    const auto resistances = group.array<double>("line_resistance", {count});
    const auto time_functions = read_time_functions(group, count);
    std::vector<model::PressureLoad> loads;
    for (std::size_t i = 0; i < names.size(); ++i) {
        loads.push_back({names[i],
                         {},
                         sealed[i] == 1,
                         {ambients[i], densities[i], dead_volumes[i], exponents[i]},
                         shapes[i],
                         time_functions[i],
                         {}});
        loads.back().plug_thrust = thrusts[i] == 1;
        if (resistances[i] != 0) loads.back().line = model::SupplyLine{resistances[i]};
    }
    const GroupReader targets = group.group("targets");
    const auto targeted = targets.texts("name");
    const auto owners = targets.array<std::int64_t>("load", {extent(targeted.size())});
    for (std::size_t i = 0; i < targeted.size(); ++i) {
        if (owners[i] < 0 || owners[i] >= count)
            throw targets.refuse("load[" + std::to_string(i) + "]",
                                 "load " + std::to_string(owners[i]) + " does not exist");
        loads[static_cast<std::size_t>(owners[i])].targets.push_back(targeted[i]);
    }
    return loads;
}

std::vector<model::TractionLoad> read_tractions(const GroupReader& group) {
    const auto faces = group.texts("face");
    const auto values = group.array<double>("traction", {extent(faces.size()), 3});
    const auto areas =
        group.has("area") ? group.array<double>("area", {extent(faces.size())}) : std::vector(faces.size(), 0.0);
    const auto time_functions = read_time_functions(group, extent(faces.size()));
    std::vector<model::TractionLoad> tractions;
    for (std::size_t i = 0; i < faces.size(); ++i)
        tractions.push_back({faces[i], triple<double>(values, i), time_functions[i], areas[i]});
    return tractions;
}

std::vector<model::BodyForce> read_body_forces(const GroupReader& group) {
    const auto names = group.texts("name");
    const auto values = group.array<double>("acceleration", {extent(names.size()), 3});
    const auto time_functions = read_time_functions(group, extent(names.size()));
    std::vector<model::BodyForce> forces;
    for (std::size_t i = 0; i < names.size(); ++i)
        forces.push_back({names[i], triple<double>(values, i), time_functions[i]});
    return forces;
}

std::vector<model::Motion> read_motions(const GroupReader& group) {
    const auto faces = group.texts("face");
    const auto moved = group.flags("moved", {extent(faces.size()), 3});
    const auto values = group.array<double>("displacement", {extent(faces.size()), 3});
    std::vector<model::Motion> motions;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        model::Motion& motion = motions.emplace_back(model::Motion{faces[i], {}});
        for (std::size_t k = 0; k < 3; ++k)
            if (moved[3 * i + k] == 1) motion.displacement_m[k] = values[3 * i + k];
    }
    return motions;
}

model::Stage read_stage(const GroupReader& group) {
    model::Stage stage;
    stage.name = group.text("name");
    stage.control = group.word("control", control_names);
    stage.controlled = group.text("controlled");
    const auto prescriptions = read_words(group, "prescription", prescription_names, any);
    const auto values = group.array<double>("value", {extent(prescriptions.size())});
    for (std::size_t i = 0; i < values.size(); ++i) stage.supplies.push_back({prescriptions[i], values[i]});
    stage.tractions = group.array<double>("tractions", {any});
    stage.body_forces = group.array<double>("body_forces", {any});
    stage.motions = group.array<double>("motions", {any});
    const GroupReader until = group.group("until");
    const auto quantities = until.texts("quantity");
    const auto goals = until.array<double>("value", {extent(quantities.size())});
    for (std::size_t i = 0; i < quantities.size(); ++i) stage.until.push_back({quantities[i], goals[i]});
    return stage;
}

model::PathSettings read_path(const GroupReader& group) {
    model::PathSettings path;
    path.branch = group.word("branch", branch_names);
    path.imperfection_m = group.number("imperfection");
    path.contact = group.word("contact", contact_names);
    path.stretch_limit = group.number("stretch_limit");
    if (group.has("frequencies")) path.frequencies = group.int_count("frequencies", 0);
    const GroupReader stages = group.group("stages");
    const std::size_t count = stages.names().size();
    for (std::size_t i = 0; i < count; ++i) path.stages.push_back(read_stage(stages.group(std::to_string(i))));
    return path;
}

}  // namespace

void read_solve_parts(const GroupReader& parent, model::Case& model) {
    model.materials = read_materials(parent.group("materials"));
    const GroupReader loads = parent.group("loads");
    model.loads = read_pressures(loads);
    model.tractions = read_tractions(loads.group("tractions"));
    model.body_forces = read_body_forces(loads.group("body_forces"));
    model.motions = read_motions(loads.group("motions"));
    const GroupReader control = parent.group("control");
    model.path = read_path(control);
    read_settings(control, model);
}

}  // namespace soft::io
