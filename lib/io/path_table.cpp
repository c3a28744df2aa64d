#include "io/path_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "io/path_columns.hpp"

namespace soft::io {
namespace {

using model::Step;

/// A column of /path or /path/tangents. The tables below declare each column once, for writing, reading and checking.
template <class T>
struct Column {
    const char* name;
    const char* units;  ///< nullptr: that of the leading load
    const char* description;
    T* (*find)(Step&);                ///< nullptr if the row does not have the value
    void (*create)(Step&) = nullptr;  ///< creates an optional value in a row whose file has the column
};

template <class T>
using Table = std::span<const Column<T>>;

template <auto member>
auto* in_row(Step& step) {
    return &(step.*member);
}
template <auto optional>
auto* in_optional(Step& step) {
    return step.*optional ? &*(step.*optional) : nullptr;
}
template <auto optional, auto member>
auto* in_optional(Step& step) {
    return step.*optional ? &((*(step.*optional)).*member) : nullptr;
}
template <auto optional>
void create(Step& step) {
    auto& value = step.*optional;
    if (!value) value = typename std::remove_reference_t<decltype(value)>::value_type{};
}

template <std::size_t axis>
double* max_stretch_at(Step& step) {
    return step.extremes ? &step.extremes->stretch_at_m[axis] : nullptr;
}

template <auto member>
constexpr auto moving = in_optional<&Step::motion, member>;
template <auto member>
constexpr auto resting = in_optional<&Step::energies, member>;

template <auto member>
double* in_energies(Step& step) {
    return step.energies && (*step.energies).*member ? &*((*step.energies).*member) : nullptr;
}
double* time_of(Step& step) {
    if (step.motion) return &step.motion->time_s;
    return step.time_s ? &*step.time_s : nullptr;
}
double* volume_tangent(Step& step) { return step.volume_m3 ? &step.tangent_volume : nullptr; }
/// In a dynamic path, the columns of the same names are those of the motion.
void create_energies(Step& step) {
    if (!step.motion) create<&Step::energies>(step);
}
template <auto member>
void create_in_energies(Step& step) {
    create_energies(step);
    if (step.energies) ((*step.energies).*member).emplace();
}

using Motion = Step::Motion;
using Energies = Step::Energies;
constexpr Column<double> number_columns[]{
    {"load_parameter", "1", "fraction of the stage's load increment that is applied", in_row<&Step::load_factor>},
    {"pressure", nullptr,
     "leading load: first pressure, above ambient; else first traction or force; else the load parameter",
     in_row<&Step::pressure_Pa>},
    {"pressure_error", nullptr, "half width of the error bar of pressure, at an equal first output (else volume)",
     in_optional<&Step::pressure_error_Pa>, create<&Step::pressure_error_Pa>},
    {"cavity_volume", "m3", "enclosed by the cavities of the first load, whole actuator", in_optional<&Step::volume_m3>,
     create<&Step::volume_m3>},
    {"stretch_p99", "1", "principal stretch that is exceeded in 1 % of the material", in_row<&Step::stretch_p99>},
    {"max_stretch", "1", "largest principal stretch", in_row<&Step::max_stretch>},
    {"max_stretch_x", "m", "undeformed position of max_stretch", max_stretch_at<0>, create<&Step::extremes>},
    {"max_stretch_y", "m", "undeformed position of max_stretch; r if axisymmetric", max_stretch_at<1>,
     create<&Step::extremes>},
    {"max_stretch_z", "m", "undeformed position of max_stretch", max_stretch_at<2>, create<&Step::extremes>},
    {"max_energy_density", "J/m3", "largest strain energy per undeformed volume at a quadrature point",
     in_optional<&Step::extremes, &Step::Extremes::energy_J_m3>, create<&Step::extremes>},
    {"min_jacobian", "1", "smallest det F at the quadrature points", in_row<&Step::min_jacobian>},
    {"stored_energy", "J", "strain energy of the whole actuator", resting<&Energies::stored_J>, create_energies},
    {"load_work", "J", "work of the loads since the start of the path", resting<&Energies::load_work_J>,
     create_energies},
    {"dissipated_energy", "J", "dissipated by snaps and by inelastic materials since the start of the path",
     in_energies<&Energies::dissipated_J>, create_in_energies<&Energies::dissipated_J>},
    {"friction_work", "J", "dissipated by friction since the start of the path", in_optional<&Step::friction_J>,
     create<&Step::friction_J>},
    {"time", "s", "time since the undeformed state at rest", time_of},
    {"kinetic_energy", "J", "kinetic energy of the whole actuator", moving<&Motion::kinetic_energy_J>},
    {"stored_energy", "J", "strain energy of the whole actuator", moving<&Motion::stored_energy_J>},
    {"load_work", "J", "work of the loads since time 0", moving<&Motion::load_work_J>},
    {"damping_work", "J", "work dissipated by damping since time 0", moving<&Motion::damping_work_J>},
};
constexpr Column<int> count_columns[]{
    {"stage", "1", "index of the stage in path.stages of the design", in_row<&Step::stage>},
    {"newton_iterations", "1", "iterations of the step, failed attempts included", in_row<&Step::newton_iterations>},
    {"factorizations", "1", "factorisations of the step", in_row<&Step::factorizations>},
};
constexpr Column<bool> flag_columns[]{
    {"stable", "1", "1: stable under the loads of the case", in_row<&Step::stable>},
    {"stable_under_control", "1", "1: stable under the control that found the state",
     in_optional<&Step::stable_under_control>, create<&Step::stable_under_control>},
};
constexpr Column<double> tangent_columns[]{
    {"load_parameter", "1", "derivative along the path", in_row<&Step::tangent_load_factor>},
    {"pressure", nullptr, "derivative along the path", in_row<&Step::tangent_pressure>},
    {"cavity_volume", "m3", "derivative along the path", volume_tangent},
    {"load_work", "J", "derivative along the path; also of stored_energy", in_energies<&Energies::tangent_J>,
     create_in_energies<&Energies::tangent_J>},
};

/// A group of columns for a list of the rows, and for its derivative along the path if it has one.
struct ListMember {
    ListColumns columns;
    std::vector<double> Step::*values;
    std::vector<double> Step::*tangents;
};
std::vector<ListMember> list_members(const model::Case& model, const Step& row) {
    ListColumns errors = output_error_columns(model);
    if (!row.pressure_error_Pa) errors.names.clear();
    return {{pressure_columns(model), &Step::pressures_Pa, &Step::tangent_pressures},
            {volume_columns(model), &Step::volumes_m3, &Step::tangent_volumes},
            {output_columns(model), &Step::outputs, &Step::tangent_outputs},
            {std::move(errors), &Step::output_errors, nullptr},
            {frequency_columns(model), &Step::frequencies_Hz, nullptr},
            {derivative_columns(model), &Step::derivatives, nullptr}};
}

/// Calls `use` with each table of /path.
void for_each_table(const auto& use) {
    use(Table<double>{number_columns});
    use(Table<int>{count_columns});
    use(Table<bool>{flag_columns});
}

/// Type in the file.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, double>, double,
                                  std::conditional_t<std::is_same_v<T, int>, std::int64_t, std::uint8_t>>;

/// Writes the columns whose value every row has.
template <class T>
void write_columns(hid_t group, Table<T> columns, std::vector<Step>& rows, const model::Case& model) {
    for (const Column<T>& column : columns)
        if (std::ranges::all_of(rows, column.find))
            write_column(group, {column.name, column.units ? column.units : load_units(model), column.description},
                         rows.size(), [&](std::size_t i) { return static_cast<Stored<T>>(*column.find(rows[i])); });
}

/// Creates the optional values whose columns the group has.
template <class T>
void create_values(const GroupReader& group, Table<T> columns, Step& row) {
    for (const Column<T>& column : columns)
        if (column.create != nullptr && group.has(column.name)) column.create(row);
}

template <class T>
void read_columns(const GroupReader& group, Table<T> columns, std::vector<Step>& rows) {
    for (const Column<T>& column : columns) {
        if (column.find(rows[0]) == nullptr) continue;
        const auto values = group.array<Stored<T>>(column.name, {extent(rows.size())});
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string item = column.name + ("[" + std::to_string(i) + "]");
            if constexpr (std::is_same_v<T, int>)
                *column.find(rows[i]) = group.to_int(item, values[i]);
            else
                *column.find(rows[i]) = static_cast<T>(values[i]);
            if (std::is_same_v<T, bool> && values[i] > 1) throw group.refuse(item, "is neither 0 nor 1");
        }
    }
}

}  // namespace

std::optional<RowProblem> problem_of(const Step& step, const Step* before, const model::Case& model) {
    const auto is_error = [](double value) { return value >= 0; };
    if (step.stage < 0 || static_cast<std::size_t>(step.stage) >= model.path.stages.size())
        return RowProblem{"stage", "stage " + std::to_string(step.stage) + " does not exist"};
    for (const ListMember& list : list_members(model, step))
        for (const auto member : {list.values, list.tangents}) {
            if (member == nullptr) continue;
            if ((step.*member).size() != list.columns.names.size())
                return RowProblem{list.columns.group, "does not have one value per column"};
            if (!all_finite(step.*member)) return RowProblem{list.columns.group, "is not finite"};
        }
    Step row = step;  // find() requires mutable rows
    for (const auto table : {Table<double>{number_columns}, Table<double>{tangent_columns}})
        for (const Column<double>& column : table)
            if (const double* value = column.find(row); value != nullptr && !std::isfinite(*value))
                return RowProblem{column.name, "is not finite"};
    for (const Column<int>& column : count_columns)
        if (*column.find(row) < 0) return RowProblem{column.name, "is negative"};
    if (!is_error(step.pressure_error_Pa.value_or(0)) || !std::ranges::all_of(step.output_errors, is_error))
        return RowProblem{"pressure_error", "an error is negative"};
    if (step.motion.has_value() != model.dynamics.has_value() || step.time_s.has_value() != model::is_timed(model))
        return RowProblem{"time", "must exist in a dynamic case and on a path in time, and only there"};
    Step earlier = before ? *before : Step{};
    const double *time = time_of(row), *time_before = before ? time_of(earlier) : nullptr;
    if (time != nullptr && (*time < 0 || (time_before != nullptr && !(*time > *time_before))))
        return RowProblem{"time", "must ascend and not be negative"};
    if (step.motion && step.motion->kinetic_energy_J < 0) return RowProblem{"kinetic_energy", "is negative"};
    if (before && step.volume_m3.has_value() != before->volume_m3.has_value())
        return RowProblem{"cavity_volume", "some steps have a volume, some have none"};
    if (before && step.pressure_error_Pa.has_value() != before->pressure_error_Pa.has_value())
        return RowProblem{"pressure_error", "some steps have an error, some have none"};
    return std::nullopt;
}

void write_steps(hid_t path, std::span<const Step> steps, const model::Case& model) {
    write_column(path, {"step", "1", "row number"}, steps.size(),
                 [](std::size_t i) { return static_cast<std::int64_t>(i); });
    if (steps.empty()) return;
    if (!model::runs_in_time(model))
        write_column(path, {"time", "1", "pseudo time: stage number + load parameter"}, steps.size(),
                     [&](std::size_t i) { return steps[i].stage + steps[i].load_factor; });
    std::vector<Step> rows(steps.begin(), steps.end());  // find() requires mutable rows
    const GroupHandle tangents =
        create_group(path, "tangents", "derivatives by a common path parameter of arbitrary positive scale");
    for_each_table([&](auto columns) { write_columns(path, columns, rows, model); });
    write_columns(tangents.get(), Table<double>{tangent_columns}, rows, model);
    for (const ListMember& list : list_members(model, steps[0])) {
        write_lists(path, list.columns, steps, list.values);
        if (list.tangents != nullptr) write_lists(tangents.get(), list.columns, steps, list.tangents);
    }
}

std::vector<Step> read_steps(const GroupReader& path, const model::Case& model) {
    const auto numbers = path.array<std::int64_t>("step", {any});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != extent(i))
            throw path.refuse("step[" + std::to_string(i) + "]", "does not match the row number");
    if (numbers.empty()) return {};
    const GroupReader tangents = path.group("tangents");
    Step row;
    if (model.dynamics) row.motion = Step::Motion{};
    if (model::is_timed(model)) row.time_s = 0.0;
    for_each_table([&](auto columns) { create_values(path, columns, row); });
    create_values(tangents, Table<double>{tangent_columns}, row);
    std::vector<Step> steps(numbers.size(), row);
    for_each_table([&](auto columns) { read_columns(path, columns, steps); });
    read_columns(tangents, Table<double>{tangent_columns}, steps);
    for (const ListMember& list : list_members(model, row)) {
        read_lists(path, list.columns, steps, list.values);
        if (list.tangents != nullptr) read_lists(tangents, list.columns, steps, list.tangents);
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (const auto problem = problem_of(steps[i], i > 0 ? &steps[i - 1] : nullptr, model))
            throw path.refuse(problem->column + "[" + std::to_string(i) + "]", problem->text);
    return steps;
}

}  // namespace soft::io
