#include "io/columns.hpp"
#include "io/names.hpp"
#include "io/settings_io.hpp"
#include "io/solve_parts.hpp"

namespace soft::io {
namespace {

void write_materials(hid_t parent, const std::vector<model::Material>& materials) {
    const GroupHandle group = create_group(parent, "materials", "one group per cell region, by name");
    std::int64_t order = 0;
    for (const model::Material& material : materials) {
        const GroupHandle one = create_group(group.get(), material.name, "constitutive law and constants");
        write_count(one.get(), {"order", "1", "index in the list of materials"}, order++);
        write_text(one.get(), {"law", "1", "name of the law"}, material.law);
        write_text(one.get(), {"source", "1", "section of the design that defines it"}, material.source);
        write_text(one.get(), {"volumetric", "1", "volumetric energy: quadratic | log | mixed"},
                   name_of(volumetric_names, material.volumetric));
        write_text(one.get(), {"strain", "1", "finite | small"}, name_of(strain_names, material.strain));
        write_text(one.get(), {"fiber_frame", "1", "directions of fibres: cartesian x, y | cylindrical x, hoop"},
                   name_of(fiber_frame_names, material.fiber_frame));
        if (material.bulk_modulus_Pa)
            write_number(one.get(), {"bulk_modulus", "Pa", "kappa; absent: incompressible"}, *material.bulk_modulus_Pa);
        if (material.density_kg_m3)
            write_number(one.get(),
                         {"density", "kg/m3", "undeformed; may be absent without body forces in a static case"},
                         *material.density_kg_m3);
        if (material.fibers) {
            const GroupHandle fibers = create_group(one.get(), "fibers", "fibres in addition to the law; absent: none");
            write_number(fibers.get(), {"angle", "rad", "angle from the first direction of the frame"},
                         material.fibers->angle_rad);
            write_number(fibers.get(), {"k1", "Pa", "stiffness at small stretch"}, material.fibers->k1_Pa);
            write_number(fibers.get(), {"k2", "1", "exponential stiffening of the fibres"}, material.fibers->k2);
            write_count(fibers.get(), {"families", "1", "2: at plus and minus the angle; 1: at plus the angle"},
                        material.fibers->families);
        }
        const GroupHandle constants = create_group(one.get(), "constants", "constants, by parameter name of the law");
        for (const auto& [key, values] : material.constants)
            write_list(constants.get(), {key, "SI", "constant of the law, one value or a list"}, values);
    }
}

void write_targets(hid_t loads_group, const std::vector<model::PressureLoad>& loads) {
    const GroupHandle group =
        create_group(loads_group, "targets", "cavities and faces on which the pressures act, one row per target");
    std::vector<std::int64_t> owners;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < loads.size(); ++i)
        for (const std::string& target : loads[i].targets) {
            owners.push_back(extent(i));
            names.push_back(target);
        }
    write_list(group.get(), {"load", "1", "row of /loads/name"}, owners);
    write_texts(group.get(), {"name", "1", "cavity, or one named face"}, names);
}

template <class Load>
std::vector<model::TimeFunction> time_functions_of(const std::vector<Load>& loads) {
    return column(loads, [](const auto& load) { return load.time_function; });
}

void write_pressures(hid_t group, const std::vector<model::PressureLoad>& loads) {
    write_texts(group, {"name", "1", "name of the load"}, column(loads, [](const auto& l) { return l.name; }));
    write_list(group, {"sealed", "1", "1: plugs and inner faces are also loaded"},
               column(loads, [](const auto& l) { return static_cast<std::uint8_t>(l.sealed); }));
    write_list(group,
               {"plug_thrust", "1", "1: the plugs of a sealed load push on the actuator; 0: a fixture carries them"},
               column(loads, [](const auto& l) { return static_cast<std::uint8_t>(l.plug_thrust); }));
    const auto gas = [&](const Label& label, double model::Gas::*member) {
        write_list(group, label, column(loads, [&](const auto& l) { return l.gas.*member; }));
    };
    gas({"ambient_pressure", "Pa", "absolute pressure outside the actuator"}, &model::Gas::ambient_Pa);
    gas({"ambient_density", "kg/m3", "density of the gas at ambient pressure"}, &model::Gas::ambient_density_kg_m3);
    gas({"dead_volume", "m3", "volume of the tubing, filled with the same gas; whole actuator"},
        &model::Gas::dead_volume_m3);
    gas({"exponent", "1", "p + ambient is proportional to density to this power; 1: isothermal"},
        &model::Gas::exponent);
    write_texts(group, {"shape", "1", "deformed | undeformed: configuration in which the pressure acts"},
                column(loads, [](const auto& l) { return std::string{name_of(load_shape_names, l.shape)}; }));
    write_list(
        group,
        {"line_resistance", "Pa.s/m3", "resistance of the tube that fills the cavities in a dynamic case; 0: no tube"},
        column(loads, [](const auto& l) { return l.line ? l.line->resistance_Pa_s_m3 : 0.0; }));
    write_time_functions(group, time_functions_of(loads));
    write_targets(group, loads);
}

void write_forces(hid_t loads_group, const model::Case& model) {
    const auto& tractions = model.tractions;
    const GroupHandle dead = create_group(loads_group, "tractions", "dead tractions at level 1, one row per load");
    write_texts(dead.get(), {"face", "1", "named face"}, column(tractions, [](const auto& t) { return t.face; }));
    write_list(dead.get(), {"traction", "Pa", "force per undeformed area: x, y, z (axisymmetric: x, r, unused)"},
               rows_of_three<double>(tractions, [](const auto& t) { return t.traction_Pa; }), {tractions.size(), 3});
    write_list(dead.get(), {"area", "m2", "area of the whole face if the load is given as a force; else 0"},
               column(tractions, [](const auto& t) { return t.area_m2; }));
    write_time_functions(dead.get(), time_functions_of(tractions));
    const auto& forces = model.body_forces;
    const GroupHandle body = create_group(loads_group, "body_forces", "body forces at level 1, one row per load");
    write_texts(body.get(), {"name", "1", "name of the load"}, column(forces, [](const auto& f) { return f.name; }));
    write_list(body.get(), {"acceleration", "m/s2", "force per mass: x, y, z (axisymmetric: x only)"},
               rows_of_three<double>(forces, [](const auto& f) { return f.acceleration_m_s2; }), {forces.size(), 3});
    write_time_functions(body.get(), time_functions_of(forces));
}

void write_motions(hid_t loads_group, const std::vector<model::Motion>& motions) {
    const GroupHandle group =
        create_group(loads_group, "motions", "prescribed displacements at level 1, one row per load");
    std::vector<double> values;
    std::vector<std::uint8_t> moved;
    for (const model::Motion& motion : motions)
        for (const auto& component : motion.displacement_m) {
            values.push_back(component.value_or(0));
            moved.push_back(component.has_value());
        }
    write_texts(group.get(), {"face", "1", "named face"}, column(motions, [](const auto& m) { return m.face; }));
    write_list(group.get(), {"moved", "1", "1 where x, y, z (axisymmetric: x, r, unused) is prescribed, else free"},
               moved, {motions.size(), 3});
    write_list(group.get(), {"displacement", "m", "x, y, z (axisymmetric: x, r, unused); 0 where free"}, values,
               {motions.size(), 3});
}

void write_until(hid_t stage_group, const std::vector<model::Until>& until) {
    const GroupHandle group =
        create_group(stage_group, "until", "stopping conditions; the stage ends at the first one that is reached");
    write_texts(group.get(), {"quantity", "1", "pressure | volume_ratio | steps | name of an output"},
                column(until, [](const auto& u) { return u.quantity; }));
    write_list(group.get(), {"value", "SI", "in the unit of the quantity: Pa, 1, 1, m or rad"},
               column(until, [](const auto& u) { return u.value; }));
}

void write_stage(hid_t stages_group, const model::Stage& stage, std::size_t number) {
    const GroupHandle group =
        create_group(stages_group, std::to_string(number), "loads at the end of the stage, one entry per load");
    const hid_t id = group.get();
    write_text(id, {"name", "1", "name of the stage"}, stage.name);
    write_text(id, {"control", "1", "auto | pressure | volume | displacement | arc_length"},
               name_of(control_names, stage.control));
    write_text(id, {"controlled", "1", "name of a load (volume) or an output (displacement); empty: the first"},
               stage.controlled);
    write_texts(id, {"prescription", "1", "pressure | volume | volume_ratio | mass | closed"},
                column(stage.supplies, [](const auto& s) { return std::string{name_of(prescription_names, s.what)}; }));
    write_list(id, {"value", "SI", "prescribed value at the end of the stage: Pa, m3, 1, kg, unused"},
               column(stage.supplies, [](const auto& s) { return s.value; }));
    write_list(id, {"tractions", "1", "levels at the end of the stage"}, stage.tractions);
    write_list(id, {"body_forces", "1", "levels at the end of the stage"}, stage.body_forces);
    write_list(id, {"motions", "1", "levels at the end of the stage"}, stage.motions);
    write_until(id, stage.until);
}

void write_control(hid_t parent, const model::Case& model) {
    const model::PathSettings& path = model.path;
    const GroupHandle group = create_group(parent, "control", "settings of the path following");
    write_text(group.get(), {"branch", "1", "stay | follow, at a bifurcation"}, name_of(branch_names, path.branch));
    write_number(group.get(), {"imperfection", "m", "maximum displacement of the perturbation used to switch branches"},
                 path.imperfection_m);
    write_text(group.get(), {"contact", "1", "stop | ignore, where walls of the actuator touch"},
               name_of(contact_names, path.contact));
    write_number(group.get(),
                 {"stretch_limit", "1", "stretch_p99 beyond which a load that cannot be reached is abandoned"},
                 path.stretch_limit);
    write_count(group.get(), {"frequencies", "1", "number of natural frequencies of each row"}, path.frequencies);
    const GroupHandle stages = create_group(group.get(), "stages", "load programme, one group per stage: 0, 1 ...");
    for (std::size_t i = 0; i < path.stages.size(); ++i) write_stage(stages.get(), path.stages[i], i);
    write_settings(group.get(), model);
}

}  // namespace

void write_solve_parts(hid_t parent, const model::Case& model) {
    write_materials(parent, model.materials);
    {
        const GroupHandle loads = create_group(parent, "loads", "follower pressures, one row per load");
        write_pressures(loads.get(), model.loads);
        write_forces(loads.get(), model);
        write_motions(loads.get(), model.motions);
    }
    write_control(parent, model);
}

}  // namespace soft::io
