#include "post/curve_entries.hpp"

#include <cmath>
#include <limits>

#include "post/row_derivatives.hpp"

namespace soft::post {
namespace {

struct Unit {
    std::string_view name, suffix;  // "1/m", and the suffix of the column name: "per_m"
    core::Dimension dimension;
    double SI_per_unit;
};
constexpr Unit kilopascal{"kPa", "kPa", core::Dimension::pressure, 1e3}, newton{"N", "N", core::Dimension::force, 1},
    millilitre{"mL", "mL", core::Dimension::volume, 1e-6}, second{"s", "s", core::Dimension::time, 1},
    hertz{"Hz", "Hz", core::Dimension::rate, 1}, millijoule{"mJ", "mJ", core::Dimension::energy, 1e-3},
    millimetre{"mm", "mm", core::Dimension::length, 1e-3},
    per_volume{"kJ/m^3", "kJ_m3", core::Dimension::pressure, 1e3}, none{"", "", core::Dimension::ratio, 1};

Unit column_unit(model::Measure measure) {
    const model::MeasureUnit& unit = model::unit_of(measure);
    return {unit.shown, unit.suffix, unit.dimension, unit.SI_per_shown};
}

Column with_unit(const std::string& quantity, const Unit& unit, Role role, std::string meaning) {
    Column column;
    column.name = unit.name.empty() ? quantity : quantity + "_" + std::string{unit.suffix};
    column.quantity = quantity;
    column.unit = unit.name;
    column.meaning = std::move(meaning);
    column.dimension = unit.dimension;
    column.SI_per_unit = unit.SI_per_unit;
    column.role = role;
    return column;
}

Column coordinate(const std::string& quantity, const Unit& unit, Source source, std::string meaning,
                  std::size_t index = 0) {
    Column column = with_unit(quantity, unit, Role::coordinate, std::move(meaning));
    column.source = source;
    column.index = index;
    return column;
}

Column plain(const std::string& name, Role role, std::string meaning) {
    return with_unit(name, none, role, std::move(meaning));
}

/// Column with the half width of the error of a coordinate: "pressure_error_kPa".
Column error_column(const Column& of) {
    Column column = of;
    column.quantity += "_error";
    column.name = column.quantity + of.name.substr(of.quantity.size());
    column.meaning = of.source == Source::load
                         ? "half width of the mesh error of " + of.quantity +
                               ", at an equal value of the first output (or the volume) that moves with it"
                         : "half width of the mesh error of " + of.quantity + ", at equal load";
    column.role = Role::dependent;
    column.source = Source::other;
    return column;
}

Column leading_column(const model::Case& model) {
    switch (model::leading_load(model)) {
        case model::LeadingLoad::pressure:
            return coordinate("pressure", kilopascal, Source::load, "gauge pressure of the first load");
        case model::LeadingLoad::traction:
            return coordinate("traction", kilopascal, Source::load,
                              "first traction, positive along its direction, if the case has no pressure load");
        case model::LeadingLoad::force:
            return coordinate("load", newton, Source::load,
                              "first force on a face, positive along its direction, if the case has no pressure load");
        case model::LeadingLoad::load_factor: break;
    }
    return coordinate(
        "load_factor", none, Source::load,
        "fraction of the loads, if the case has no pressure, traction or force; in a motion that of gravity, without it of the first obstacle that moves");
}

using Step = model::Step;

Value value_of(std::optional<bool> flag) { return flag ? Value(*flag ? 1 : 0) : std::nullopt; }
Value value_of(const std::vector<double>& list, std::size_t i) {
    return i < list.size() ? Value(list[i]) : std::nullopt;
}

/// Adds a value of a list of a step and its derivative along the path, 0 if it is not known.
void add_item(std::vector<Entry>& entries, Column column, std::size_t i, std::vector<double> Step::*values,
              std::vector<double> Step::*slopes) {
    entries.push_back({std::move(column), [=](const Step& step) { return value_of(step.*values, i); },
                       [=](const Step& step) { return value_of(step.*slopes, i).value_or(0); }});
}

/// In a motion their rates are those of a very stiff contact at the small error of the velocities, and of friction that sticks.
bool is_contact_force(const model::Output& output) {
    return model::is_reaction(output.measure) || (!output.obstacle.empty() && output.measure == model::Measure::force);
}

void add_coordinates(std::vector<Entry>& entries, const model::Case& model) {
    entries.push_back({leading_column(model), [](const Step& step) { return step.pressure_Pa; },
                       [](const Step& step) { return step.tangent_pressure; }});
    for (std::size_t i = 0; i < model.outputs.size(); ++i) {
        const model::Output& output = model.outputs[i];
        const auto slope = [i, none = !model::has_slope(output.measure),
                            force = is_contact_force(output)](const Step& step) {
            return none || (step.motion && force) ? std::nullopt : Value(value_of(step.tangent_outputs, i).value_or(0));
        };
        add_item(entries,
                 coordinate(output.name, column_unit(output.measure), Source::output,
                            std::string{model::info_of(output.measure).meaning} + ": " +
                                (output.point_m            ? "a point"
                                 : output.obstacle.empty() ? output.face
                                                           : output.obstacle),
                            i),
                 i, &Step::outputs, &Step::tangent_outputs);
        entries.back().slope_SI = slope;
        entries.back().column.bends =
            !model.dynamics || !output.obstacle.empty();  // a body with mass keeps its velocity
    }
    entries.push_back({coordinate("volume", millilitre, Source::volume,
                                  "volume enclosed by the cavities of the first load, whole actuator"),
                       [](const Step& step) { return step.volume_m3; },
                       [](const Step& step) { return step.tangent_volume; }, true});
    entries.back().column.bends = !model.dynamics;
    for (std::size_t i = 0; model.loads.size() > 1 && i < model.loads.size(); ++i)
        add_item(entries,
                 coordinate("pressure_" + model.loads[i].name, kilopascal, Source::other,
                            "gauge pressure of each load, if there are several"),
                 i, &Step::pressures_Pa, &Step::tangent_pressures);
    const auto cavities = model::measured_cavities(model);
    for (std::size_t i = 0; cavities.size() > 1 && i < cavities.size(); ++i) {
        add_item(entries,
                 coordinate("volume_" + cavities[i]->name, millilitre, Source::other,
                            "volume enclosed by each cavity, if there are several"),
                 i, &Step::volumes_m3, &Step::tangent_volumes);
        entries.back().column.bends = !model.dynamics;
    }
}

/// Errors of the load and of the outputs.
void add_errors(std::vector<Entry>& entries) {
    std::vector<Entry> errors;
    for (const Entry& entry : entries) {
        const Column& of = entry.column;
        const auto error = [source = of.source, i = of.index](const Step& step) {
            return source == Source::load ? step.pressure_error_Pa : value_of(step.output_errors, i);
        };
        if (of.source == Source::load || of.source == Source::output)
            errors.push_back({.column = error_column(of), .value_SI = error, .is_optional = true});
    }
    entries.insert(entries.end(), errors.begin(), errors.end());
}

void add_motion_energies(std::vector<Entry>& entries) {
    const auto add = [&](const char* name, double Step::Motion::*energy, const char* meaning) {
        entries.push_back(
            {.column = with_unit(name, millijoule, Role::dependent, meaning),
             .value_SI =
                 [energy](const Step& step) { return step.motion ? Value((*step.motion).*energy) : std::nullopt; },
             .is_optional = true});
    };
    using Motion = Step::Motion;
    add("kinetic_energy", &Motion::kinetic_energy_J, "kinetic energy of the whole actuator, dynamic cases only");
    add("stored_energy", &Motion::stored_energy_J, "strain energy stored in the whole actuator");
    add("load_work", &Motion::load_work_J, "work done by the loads since the start of the path");
    add("damping_work", &Motion::damping_work_J,
        "energy dissipated by damping and by inelastic rubber, dynamic cases only");
}

void add_local_values(std::vector<Entry>& entries, const model::Case& model) {
    entries.push_back({plain("stretch_p99", Role::dependent,
                             "principal stretch exceeded in 1 % of the rubber; converges with the mesh"),
                       [](const Step& step) { return step.stretch_p99; }});
    entries.push_back({plain("max_stretch", Role::dependent, "largest principal stretch at a quadrature point"),
                       [](const Step& step) { return step.max_stretch; }});
    entries.push_back({plain("min_J", Role::dependent, "smallest volume ratio J at a quadrature point"),
                       [](const Step& step) { return step.min_jacobian; }});
    if (model.dynamics) return;  // the stability of a state in motion is not known
    entries.push_back({plain("stable", Role::flag,
                             "1 if the state is stable under the loads as stated in the design; static paths only"),
                       [](const Step& step) { return value_of(step.stable); }});
    entries.push_back({.column = plain("stable_under_control", Role::flag,
                                       "1 if the state is stable under the control used, such as a prescribed volume"),
                       .value_SI = [](const Step& step) { return value_of(step.stable_under_control); },
                       .is_optional = true});
}

/// Quantities that are part of the table only on request.
void add_on_demand(std::vector<Entry>& entries, const model::Case& model) {
    const auto add = [&](const char* name, const Unit& unit, const char* meaning, auto value) -> Entry& {
        entries.push_back(
            {.column = with_unit(name, unit, Role::dependent, meaning), .value_SI = value, .is_optional = true});
        entries.back().column.shown = Shown::on_demand;
        return entries.back();
    };
    const auto tangent = [](const Step& s) { return s.energies->tangent_J; };
    Entry& stored = add("stored_energy", millijoule, "strain energy stored in the whole actuator",
                        [](const Step& s) { return s.energies ? Value(s.energies->stored_J) : std::nullopt; });
    if (!model::is_inelastic(model)) stored.slope_SI = tangent;
    add("load_work", millijoule, "work done by the loads since the start of the path", [](const Step& s) {
        return s.energies ? Value(s.energies->load_work_J) : std::nullopt;
    }).slope_SI = tangent;
    add("dissipated_energy", millijoule,
        "energy dissipated by inelastic rubber and by snaps since the start of the path",
        [](const Step& s) { return s.energies ? s.energies->dissipated_J : std::nullopt; });
    add("friction_work", millijoule, "energy dissipated by friction since the start of the path",
        [](const Step& s) { return s.friction_J; });
    const auto position = [&](const char* name, std::size_t i) {
        add(name, millimetre, "undeformed position of max_stretch",
            [i](const Step& s) { return s.extremes ? Value(s.extremes->stretch_at_m[i]) : std::nullopt; });
    };
    position("max_stretch_x", 0);
    position(model.kinematics == model::Kinematics::axisymmetric ? "max_stretch_r" : "max_stretch_y", 1);
    if (model.kinematics == model::Kinematics::solid) position("max_stretch_z", 2);
    add("max_energy_density", per_volume, "largest strain energy per undeformed volume at a quadrature point",
        [](const Step& s) { return s.extremes ? Value(s.extremes->energy_J_m3) : std::nullopt; });
}

/// "1/m" -> "per_m"; "%" -> "percent"
std::string suffix_of(const std::string& unit) {
    std::string suffix = unit == "%" ? "percent" : unit;
    for (char& c : suffix)
        if (c == '/' || c == '*' || c == '^') c = '_';
    return suffix;
}

/// The stiffness along the path, and the derivatives of the load at a fixed first output, or of both at a fixed time (sensitivity.hpp).
void add_derivatives(std::vector<Entry>& entries, const model::Case& model, std::span<const Step> steps) {
    if (model.outputs.empty() || model.parameters.empty()) return;
    const Column load = leading_column(model);
    const bool is_timed = model::is_timed(model);
    struct Scale {
        std::string unit;
        double SI_per_unit;
    };
    const auto add = [&](const std::string& quantity, const Scale& of, const Scale& by, std::string meaning,
                         std::function<Value(const Step&)> value) {
        Column column = plain(quantity, Role::dependent, std::move(meaning));
        const std::string numerator = of.unit.empty() ? "1" : of.unit;
        column.unit = by.unit.empty() ? of.unit : numerator + "/" + by.unit;
        if (!column.unit.empty())
            column.name += "_" + suffix_of(numerator) + (by.unit.empty() ? "" : "_per_" + suffix_of(by.unit));
        column.SI_per_unit = of.SI_per_unit / by.SI_per_unit;
        column.shown = Shown::on_demand;
        column.jumps = !is_timed;
        entries.push_back({.column = std::move(column), .value_SI = std::move(value), .is_optional = true});
    };
    const Unit unit = column_unit(model.outputs.front().measure);
    const Scale of_load{load.unit, load.SI_per_unit}, of_output{std::string{unit.suffix}, unit.SI_per_unit};
    // The row of a stage in which nothing changes has no direction: that of the row before.
    const auto directed = [steps](const Step& step) -> const Step& {
        auto row = static_cast<std::size_t>(&step - steps.data());
        while (row > 0 && steps[row].tangent_pressure == 0 && steps[row].tangent_outputs[0] == 0 &&
               !model::holds_load(steps[row]))
            --row;
        return steps[row];
    };
    const auto is_held = [directed](const Step& step) { return model::holds_load(directed(step)); };
    const auto stiffness = [directed](const Step& step) {
        const Step& at = directed(step);
        return model::holds_load(at) ? 0 : at.tangent_pressure / at.tangent_outputs[0];
    };
    if (!is_timed) {
        Column held = plain("load_is_held", Role::stage, "1 where the load is constant along the path, else 0");
        held.shown = Shown::on_demand;
        const auto value = [=](const Step& step) {
            return step.tangent_outputs.empty() ? std::nullopt : Value(is_held(step) ? 1.0 : 0.0);
        };
        entries.push_back({.column = std::move(held), .value_SI = value, .is_optional = true});
        add("stiffness", of_load, of_output, "slope of the load over the first output along the path",
            [=](const Step& step) { return step.tangent_outputs.empty() ? std::nullopt : Value(stiffness(step)); });
    }
    const std::size_t quantities = 1 + model.outputs.size();
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        const model::DesignParameter& parameter = model.parameters[i];
        const Scale by{parameter.unit, parameter.SI_per_unit};
        const auto at_rows = [=](auto value_of) {
            return [=](const Step& step) {
                if (step.derivatives.size() < (i + 1) * quantities) return Value();
                const auto row = static_cast<std::size_t>(&step - steps.data());
                return Value(with_derivatives(steps, row, [&](std::size_t known) {
                    return value_of(steps[known], &steps[known].derivatives[i * quantities]);
                }));
            };
        };
        if (is_timed) {
            const std::string meaning = "derivative by a number of the design at a fixed time";
            add(load.quantity + "_by_" + parameter.key, of_load, by, meaning,
                at_rows([](const Step&, const double* D) { return D[0]; }));
            add(model.outputs.front().name + "_by_" + parameter.key, of_output, by, meaning,
                at_rows([](const Step&, const double* D) { return D[1]; }));
        } else {
            const auto load_by = [stiffness](const Step& step, const double* D) {
                // No load gives another value of an output that stands still.
                if (std::isinf(stiffness(step))) return std::numeric_limits<double>::quiet_NaN();
                return D[0] - stiffness(step) * D[1];
            };
            add(load.quantity + "_by_" + parameter.key, of_load, by,
                "derivative of the load by a number of the design at a fixed first output", at_rows(load_by));
            add(model.outputs.front().name + "_by_" + parameter.key, of_output, by,
                "derivative of the first output by a number of the design at a fixed load; 0 where it is infinite",
                at_rows([=](const Step& step, const double* D) {
                    const double slope = is_held(step) ? D[1] : -load_by(step, D) / stiffness(step);
                    return std::isfinite(slope) ? slope : 0;
                }));
        }
    }
}

}  // namespace

std::vector<Entry> entries_of(const model::Case& model, std::span<const Step> steps) {
    std::vector<Entry> entries;
    entries.push_back({plain("step", Role::counter, "number of the row"),
                       [first = steps.data()](const Step& step) { return static_cast<double>(&step - first); }});
    entries.push_back({coordinate("time", second, Source::time, "time since the undeformed state at rest"),
                       [](const Step& step) { return step.motion ? Value(step.motion->time_s) : step.time_s; },
                       [](const Step&) { return 1; },  // the other slopes are derivatives by time
                       true});
    const int cycles = model.path.cycles, stages = static_cast<int>(model.path.stages.size()) / cycles;
    if (cycles > 1)
        entries.push_back({plain("cycle", Role::stage, "number of the cycle, from 1, if the stages are repeated"),
                           [=](const Step& step) { return step.stage / stages + 1; }});
    if (model.path.stages.size() > 1)
        entries.push_back({plain("stage", Role::stage, "number of the stage, from 1, if the path has several"),
                           [=](const Step& step) { return step.stage % stages + 1; }});
    add_coordinates(entries, model);
    add_errors(entries);
    for (std::size_t i = 0; !steps.empty() && i < steps.front().frequencies_Hz.size(); ++i)
        entries.push_back({with_unit("frequency_" + std::to_string(i + 1), hertz, Role::dependent,
                                     "natural frequency 1, 2 ... about the state, loads held; negative: unstable"),
                           [i](const Step& step) { return step.frequencies_Hz[i]; }});
    add_motion_energies(entries);
    add_local_values(entries, model);
    add_on_demand(entries, model);
    add_derivatives(entries, model, steps);
    return entries;
}

}  // namespace soft::post
