#include "io/path_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/path_columns.hpp"

namespace soft::io {
namespace {

using model::Step;

/// One table is used for writing, reading and checking, so that the three cannot diverge.
struct NumberColumn {
    const char* name;
    const char* units;
    const char* description;
    double Step::*member;
};
constexpr std::array number_columns{
    NumberColumn{"load_parameter", "1", "fraction of the stage's load increment that is applied", &Step::load_factor},
    NumberColumn{"stretch_p99", "1", "principal stretch that is exceeded in 1 % of the material", &Step::stretch_p99},
    NumberColumn{"max_stretch", "1", "largest principal stretch", &Step::max_stretch},
    NumberColumn{"min_jacobian", "1", "smallest det F at the quadrature points", &Step::min_jacobian},
};
constexpr NumberColumn load_tangent{"load_parameter", "1", "derivative along the path", &Step::tangent_load_factor};
constexpr NumberColumn volume_tangent{"cavity_volume", "m3", "derivative along the path", &Step::tangent_volume};

NumberColumn pressure_column(const model::Case& model) {
    return {"pressure", load_units(model),
            "leading load: first pressure, above ambient; else first traction or force; else the load parameter",
            &Step::pressure_Pa};
}
NumberColumn pressure_tangent(const model::Case& model) {
    return {"pressure", load_units(model), "derivative along the path", &Step::tangent_pressure};
}

/// Columns of a dynamic path. In a static path, /path/time is pseudo time.
struct MotionColumn {
    const char* name;
    const char* units;
    const char* description;
    double Step::Motion::*member;
};
constexpr std::array motion_columns{
    MotionColumn{"time", "s", "time since the undeformed state at rest", &Step::Motion::time_s},
    MotionColumn{"kinetic_energy", "J", "kinetic energy of the whole actuator", &Step::Motion::kinetic_energy_J},
    MotionColumn{"stored_energy", "J", "strain energy of the whole actuator", &Step::Motion::stored_energy_J},
    MotionColumn{"load_work", "J", "work of the loads since time 0", &Step::Motion::load_work_J},
    MotionColumn{"damping_work", "J", "work dissipated by damping since time 0", &Step::Motion::damping_work_J},
};

/// Columns that older files do not have; find() returns nullptr if the step has no such value.
struct OptionalColumn {
    const char* name;
    const char* units;
    const char* description;
    double* (*find)(Step&);
};
const std::array optional_columns{
    OptionalColumn{"max_stretch_x", "m", "undeformed position of max_stretch",
                   [](Step& s) { return s.extremes ? &s.extremes->stretch_at_m[0] : nullptr; }},
    OptionalColumn{"max_stretch_y", "m", "undeformed position of max_stretch; r if axisymmetric",
                   [](Step& s) { return s.extremes ? &s.extremes->stretch_at_m[1] : nullptr; }},
    OptionalColumn{"max_stretch_z", "m", "undeformed position of max_stretch",
                   [](Step& s) { return s.extremes ? &s.extremes->stretch_at_m[2] : nullptr; }},
    OptionalColumn{"max_energy_density", "J/m3", "largest strain energy per undeformed volume at a quadrature point",
                   [](Step& s) { return s.extremes ? &s.extremes->energy_J_m3 : nullptr; }},
    OptionalColumn{"stored_energy", "J", "strain energy of the whole actuator",
                   [](Step& s) { return s.energies ? &s.energies->stored_J : nullptr; }},
    OptionalColumn{"load_work", "J", "work of the loads since the start of the path",
                   [](Step& s) { return s.energies ? &s.energies->load_work_J : nullptr; }},
};

/// Name of the common tangent of stored_energy and load_work, whose derivatives are equal in equilibrium.
constexpr const char* energy_tangent = "load_work";

bool has_energy_tangent(const Step& step) { return step.energies && step.energies->tangent_J; }

struct CountColumn {
    const char* name;
    const char* description;
    int Step::*member;
};
constexpr std::array count_columns{
    CountColumn{"stage", "row of /control/stages", &Step::stage},
    CountColumn{"newton_iterations", "iterations of the step, failed attempts included", &Step::newton_iterations},
    CountColumn{"factorizations", "factorisations of the step", &Step::factorizations},
};

/// A list member of the rows and its derivative along the path.
struct ListMember {
    ListColumns columns;
    std::vector<double> Step::*values;
    std::vector<double> Step::*tangents;
};
std::array<ListMember, 3> list_members(const model::Case& model) {
    return {{{pressure_columns(model), &Step::pressures_Pa, &Step::tangent_pressures},
             {volume_columns(model), &Step::volumes_m3, &Step::tangent_volumes},
             {output_columns(model), &Step::outputs, &Step::tangent_outputs}}};
}

void write_numbers(hid_t group, const NumberColumn& column, std::span<const Step> steps) {
    write_column(group, {column.name, column.units, column.description}, steps.size(),
                 [&](std::size_t i) { return steps[i].*column.member; });
}

void read_numbers(const GroupReader& group, const NumberColumn& column, std::vector<Step>& steps) {
    const auto values = group.array<double>(column.name, {extent(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].*column.member = values[i];
}

void write_times(hid_t path, std::span<const Step> steps, const model::Case& model) {
    if (!model.dynamics) {
        write_column(path, {"time", "1", "pseudo time: stage number + load parameter"}, steps.size(),
                     [&](std::size_t i) { return steps[i].stage + steps[i].load_factor; });
        return;
    }
    for (const MotionColumn& column : motion_columns)
        write_column(path, {column.name, column.units, column.description}, steps.size(),
                     [&](std::size_t i) { return (*steps[i].motion).*column.member; });
}

void read_times(const GroupReader& path, std::vector<Step>& steps, const model::Case& model) {
    if (!model.dynamics) return;
    for (Step& step : steps) step.motion = model::Step::Motion{};
    for (const MotionColumn& column : motion_columns) {
        const auto values = path.array<double>(column.name, {extent(steps.size())});
        for (std::size_t i = 0; i < steps.size(); ++i) (*steps[i].motion).*column.member = values[i];
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto row = [&](const char* name) { return std::string{name} + "[" + std::to_string(i) + "]"; };
        if (steps[i].motion->time_s < 0 || (i > 0 && !(steps[i].motion->time_s > steps[i - 1].motion->time_s)))
            throw path.refuse(row("time"), "must ascend and not be negative");
        if (steps[i].motion->kinetic_energy_J < 0) throw path.refuse(row("kinetic_energy"), "is negative");
    }
}

void write_optional(hid_t path, std::span<const Step> steps) {
    std::vector<Step> rows(steps.begin(), steps.end());  // find() requires mutable steps
    for (const OptionalColumn& column : optional_columns)
        if (!rows.empty() && std::ranges::all_of(rows, column.find))
            write_column(path, {column.name, column.units, column.description}, rows.size(),
                         [&](std::size_t i) { return *column.find(rows[i]); });
}

void read_optional(const GroupReader& path, std::vector<Step>& steps, const model::Case& model) {
    for (Step& step : steps) {
        if (path.has("max_energy_density")) step.extremes = model::Step::Extremes{};
        if (path.has("stored_energy") && !model.dynamics) step.energies = model::Step::Energies{};
    }
    for (const OptionalColumn& column : optional_columns) {
        if (steps.empty() || column.find(steps.front()) == nullptr) continue;
        const auto values = path.array<double>(column.name, {extent(steps.size())});
        for (std::size_t i = 0; i < steps.size(); ++i) *column.find(steps[i]) = values[i];
    }
}

void write_energy_tangents(hid_t tangents, std::span<const Step> steps) {
    if (steps.empty() || !std::ranges::all_of(steps, has_energy_tangent)) return;
    write_column(tangents, {energy_tangent, "J", "derivative along the path; also of stored_energy"}, steps.size(),
                 [&](std::size_t i) { return *steps[i].energies->tangent_J; });
}

void read_energy_tangents(const GroupReader& tangents, std::vector<Step>& steps) {
    if (steps.empty() || !steps.front().energies || !tangents.has(energy_tangent)) return;
    const auto values = tangents.array<double>(energy_tangent, {extent(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].energies->tangent_J = values[i];
}

bool is_error(double value) { return std::isfinite(value) && value >= 0; }

void write_errors(hid_t path, std::span<const Step> steps, const model::Case& model) {
    if (steps.empty() || !steps[0].pressure_error_Pa) return;
    write_column(path,
                 {"pressure_error", load_units(model),
                  "half width of the error bar of pressure, at an equal first output (else volume)"},
                 steps.size(), [&](std::size_t i) { return steps[i].pressure_error_Pa.value_or(0); });
    write_lists(path, output_error_columns(model), steps, &Step::output_errors);
}

void read_errors(const GroupReader& path, std::vector<Step>& steps, const model::Case& model) {
    if (!path.has("pressure_error")) return;
    const auto values = path.array<double>("pressure_error", {extent(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].pressure_error_Pa = values[i];
    read_lists(path, output_error_columns(model), steps, &Step::output_errors);
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (!is_error(values[i]) || !std::ranges::all_of(steps[i].output_errors, is_error))
            throw path.refuse("pressure_error[" + std::to_string(i) + "]",
                              "an error of step " + std::to_string(i) + " is negative");
}

}  // namespace

void require_valid(const Step& step, const model::Case& model) {
    const auto refuse = [](const std::string& problem) { throw Error(ExitCode::internal, "/path", problem); };
    if (step.stage < 0 || static_cast<std::size_t>(step.stage) >= model.path.stages.size())
        refuse("a step refers to a stage that does not exist");
    for (const ListMember& list : list_members(model)) {
        const std::size_t expected = list.columns.names.size();
        if ((step.*list.values).size() != expected || (step.*list.tangents).size() != expected)
            refuse("a step does not have one value per entry of the " + list.columns.group);
        if (!all_finite(step.*list.values) || !all_finite(step.*list.tangents))
            refuse("a step has a value that is not finite");
    }
    if (step.frequencies_Hz.size() != static_cast<std::size_t>(model.path.frequencies) ||
        !all_finite(step.frequencies_Hz))
        refuse("a step does not have one finite value per natural frequency");
    if (step.output_errors.size() != (step.pressure_error_Pa ? model.outputs.size() : 0))
        refuse("a step does not have one error per output");
    if (!is_error(step.pressure_error_Pa.value_or(0)) || !std::ranges::all_of(step.output_errors, is_error))
        refuse("an error of a step is negative or not finite");
    if (!std::isfinite(step.volume_m3.value_or(0))) refuse("a step has a value that is not finite");
    const auto require_finite = [&](const NumberColumn& column) {
        if (!std::isfinite(step.*column.member)) refuse(std::string{column.name} + " of a step is not finite");
    };
    std::for_each(number_columns.begin(), number_columns.end(), require_finite);
    for (const NumberColumn& column : {pressure_column(model), pressure_tangent(model), load_tangent, volume_tangent})
        require_finite(column);
    if (step.motion.has_value() != model.dynamics.has_value())
        refuse("a step of a dynamic case lacks time and energies, or a step of a static case has them");
    Step copy = step;
    for (const OptionalColumn& column : optional_columns)
        if (const double* value = column.find(copy); value != nullptr && !std::isfinite(*value))
            refuse(std::string{column.name} + " of a step is not finite");
    if (has_energy_tangent(step) && !std::isfinite(*step.energies->tangent_J))
        refuse("the energy tangent of a step is not finite");
    for (const MotionColumn& column : motion_columns)
        if (step.motion && !std::isfinite((*step.motion).*column.member))
            refuse(std::string{column.name} + " of a step is not finite");
}

void write_steps(hid_t path, std::span<const Step> steps, const model::Case& model) {
    write_column(path, {"step", "1", "row number"}, steps.size(),
                 [](std::size_t i) { return static_cast<std::int64_t>(i); });
    write_times(path, steps, model);
    for (const NumberColumn& column : number_columns) write_numbers(path, column, steps);
    write_numbers(path, pressure_column(model), steps);
    for (const CountColumn& column : count_columns)
        write_column(path, {column.name, "1", column.description}, steps.size(),
                     [&](std::size_t i) { return static_cast<std::int64_t>(steps[i].*column.member); });
    write_column(path, {"stable", "1", "1: stable under the loads of the case"}, steps.size(),
                 [&](std::size_t i) { return static_cast<std::uint8_t>(steps[i].stable); });
    if (!steps.empty() &&
        std::ranges::all_of(steps, [](const Step& step) { return step.stable_under_control.has_value(); }))
        write_column(path, {"stable_under_control", "1", "1: stable under the control that found the state"},
                     steps.size(),
                     [&](std::size_t i) { return static_cast<std::uint8_t>(*steps[i].stable_under_control); });
    write_optional(path, steps);
    write_volumes(path, steps);
    write_errors(path, steps, model);
    write_lists(path, frequency_columns(model), steps, &Step::frequencies_Hz);
    const GroupHandle tangents =
        create_group(path, "tangents", "derivatives by a common path parameter of arbitrary positive scale");
    write_numbers(tangents.get(), load_tangent, steps);
    write_numbers(tangents.get(), pressure_tangent(model), steps);
    if (!steps.empty() && steps[0].volume_m3) write_numbers(tangents.get(), volume_tangent, steps);
    write_energy_tangents(tangents.get(), steps);
    for (const ListMember& list : list_members(model)) {
        write_lists(path, list.columns, steps, list.values);
        write_lists(tangents.get(), list.columns, steps, list.tangents);
    }
}

namespace {

void check_stages(const GroupReader& path, const std::vector<Step>& steps, const model::Case& model) {
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (static_cast<std::size_t>(steps[i].stage) >= model.path.stages.size())
            throw path.refuse("stage[" + std::to_string(i) + "]",
                              "stage " + std::to_string(steps[i].stage) + " does not exist");
}

}  // namespace

std::vector<Step> read_steps(const GroupReader& path, const model::Case& model) {
    const auto numbers = path.array<std::int64_t>("step", {any});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != extent(i))
            throw path.refuse("step[" + std::to_string(i) + "]", "does not match the row number");
    std::vector<Step> steps(numbers.size());
    for (const NumberColumn& column : number_columns) read_numbers(path, column, steps);
    read_numbers(path, pressure_column(model), steps);
    for (const CountColumn& column : count_columns) {
        const auto values = path.array<std::int64_t>(column.name, {extent(steps.size())});
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i].*column.member = path.to_int(std::string{column.name} + "[" + std::to_string(i) + "]", values[i]);
    }
    check_stages(path, steps, model);
    const auto stable = path.flags("stable", {extent(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].stable = stable[i] == 1;
    if (path.has("stable_under_control")) {
        const auto controlled = path.flags("stable_under_control", {extent(steps.size())});
        for (std::size_t i = 0; i < steps.size(); ++i) steps[i].stable_under_control = controlled[i] == 1;
    }
    read_errors(path, steps, model);
    read_lists(path, frequency_columns(model), steps, &Step::frequencies_Hz);
    read_times(path, steps, model);
    read_optional(path, steps, model);
    const GroupReader tangents = path.group("tangents");
    read_numbers(tangents, load_tangent, steps);
    read_numbers(tangents, pressure_tangent(model), steps);
    if (read_volumes(path, steps)) read_numbers(tangents, volume_tangent, steps);
    read_energy_tangents(tangents, steps);
    for (const ListMember& list : list_members(model)) {
        read_lists(path, list.columns, steps, list.values);
        read_lists(tangents, list.columns, steps, list.tangents);
    }
    return steps;
}

}  // namespace soft::io
