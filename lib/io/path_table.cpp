#include "io/path_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/text.hpp"
#include "io/hdf5_write.hpp"

namespace soft::io {
namespace {

using solution::LimitPoint;
using solution::PathEnd;
using solution::Step;

/// One table serves writing, reading and checking, so that the three cannot drift apart.
struct NumberColumn {
    const char* name;
    const char* units;
    const char* description;
    double Step::*member;
};
constexpr std::array number_columns{
    NumberColumn{"load_parameter", "1", "factor on all loads; 1 is the full load", &Step::load_factor},
    NumberColumn{"pressure", "Pa", "of the first load, above ambient; a traction where nothing else loads", &Step::pressure_Pa},
    NumberColumn{"stretch_p99", "1", "largest principal stretch exceeded in 1 % of the rubber", &Step::stretch_p99},
    NumberColumn{"max_stretch", "1", "largest principal stretch", &Step::max_stretch},
    NumberColumn{"min_jacobian", "1", "least det F over the integration points", &Step::min_jacobian},
};
constexpr std::array tangent_columns{
    NumberColumn{"load_parameter", "1", "derivative along the path", &Step::tangent_load_factor},
    NumberColumn{"pressure", "Pa", "derivative along the path", &Step::tangent_pressure},
};
constexpr NumberColumn volume_tangent{"cavity_volume", "m3", "derivative along the path", &Step::tangent_volume};

struct CountColumn {
    const char* name;
    const char* description;
    int Step::*member;
};
constexpr std::array count_columns{
    CountColumn{"newton_iterations", "iterations of the step, failed attempts included", &Step::newton_iterations},
    CountColumn{"factorizations", "factorisations of the step", &Step::factorizations},
};

template <class Pick>
void write_column(hid_t group, const Label& label, std::size_t rows, Pick pick) {
    std::vector<decltype(pick(std::size_t{}))> values(rows);
    for (std::size_t i = 0; i < rows; ++i) values[i] = pick(i);
    using T = typename decltype(values)::value_type;
    write_array<T>(group, label, values, {rows}, Growth::rows);
}

void write_numbers(hid_t group, const NumberColumn& column, std::span<const Step> steps) {
    write_column(group, {column.name, column.units, column.description}, steps.size(),
                 [&](std::size_t i) { return steps[i].*column.member; });
}

void read_numbers(const GroupReader& group, const NumberColumn& column, std::vector<Step>& steps) {
    const auto values = group.array<double>(column.name, {static_cast<std::int64_t>(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].*column.member = values[i];
}

/// Group `outputs` with a column for each, for any row type with a list of values.
template <class Row>
void write_outputs(hid_t parent, std::span<const Row> rows, const std::vector<std::string>& outputs,
                   std::vector<double> Row::*member) {
    const GroupHandle group = create_group(parent, "outputs", "measured displacements by name");
    for (std::size_t k = 0; k < outputs.size(); ++k)
        write_column(group.get(), {outputs[k], "m", "area mean over the output's face"}, rows.size(),
                     [&](std::size_t i) { return (rows[i].*member)[k]; });
}

template <class Row>
void read_outputs(const GroupReader& parent, std::vector<Row>& rows, const std::vector<std::string>& outputs,
                  std::vector<double> Row::*member) {
    const GroupReader group = parent.group("outputs");
    for (Row& row : rows) (row.*member).reserve(outputs.size());
    for (const std::string& name : outputs) {
        const auto values = group.array<double>(name, {static_cast<std::int64_t>(rows.size())});
        for (std::size_t i = 0; i < rows.size(); ++i) (rows[i].*member).push_back(values[i]);
    }
}

template <class Row>
void write_volumes(hid_t group, std::span<const Row> rows) {
    if (rows.empty() || !rows[0].volume_m3) return;
    write_column(group, {"cavity_volume", "m3", "enclosed by the first loaded cavity, whole actuator"}, rows.size(),
                 [&](std::size_t i) { return rows[i].volume_m3.value_or(0); });
}

template <class Row>
bool read_volumes(const GroupReader& group, std::vector<Row>& rows) {
    if (!group.has("cavity_volume")) return false;
    const auto values = group.array<double>("cavity_volume", {static_cast<std::int64_t>(rows.size())});
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].volume_m3 = values[i];
    return true;
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

void require_sound(const Step& step, std::size_t outputs) {
    const auto refuse = [](const std::string& problem) { throw Error(ExitCode::internal, "/path", problem); };
    if (step.outputs_m.size() != outputs || step.tangent_outputs.size() != outputs)
        refuse("a step does not have one value for each output");
    if (!all_finite(step.outputs_m) || !all_finite(step.tangent_outputs) || !std::isfinite(step.volume_m3.value_or(0)))
        refuse("a step has a value that is not finite");
    const auto require_finite = [&](const NumberColumn& column) {
        if (!std::isfinite(step.*column.member)) refuse(std::string{column.name} + " of a step is not finite");
    };
    std::for_each(number_columns.begin(), number_columns.end(), require_finite);
    std::for_each(tangent_columns.begin(), tangent_columns.end(), require_finite);
    require_finite(volume_tangent);
}

namespace {

void require_sound(const PathEnd& end, std::size_t outputs, std::size_t steps) {
    for (const LimitPoint& point : end.limit_points) {
        const bool row = point.step >= 0 && static_cast<std::size_t>(point.step) < steps;
        const bool values = point.outputs_m.size() == outputs && all_finite(point.outputs_m) &&
                            std::isfinite(point.pressure_Pa) && std::isfinite(point.volume_m3.value_or(0)) &&
                            point.volume_m3.has_value() == end.limit_points[0].volume_m3.has_value();
        if (!row || !values)
            throw Error(ExitCode::internal, "/path/limit_points", "a limit point does not fit the path");
    }
}

}  // namespace

void write_steps(hid_t path, std::span<const Step> steps, const std::vector<std::string>& outputs) {
    write_column(path, {"step", "1", "row number"}, steps.size(),
                 [](std::size_t i) { return static_cast<std::int64_t>(i); });
    write_column(path, {"time", "1", "pseudo time: the load parameter"}, steps.size(),
                 [&](std::size_t i) { return steps[i].load_factor; });
    for (const NumberColumn& column : number_columns) write_numbers(path, column, steps);
    for (const CountColumn& column : count_columns)
        write_column(path, {column.name, "1", column.description}, steps.size(),
                     [&](std::size_t i) { return static_cast<std::int64_t>(steps[i].*column.member); });
    write_column(path, {"stable", "1", "1: stable for the controlled variable"}, steps.size(),
                 [&](std::size_t i) { return static_cast<std::uint8_t>(steps[i].stable); });
    write_volumes(path, steps);
    write_outputs(path, steps, outputs, &Step::outputs_m);
    const GroupHandle tangents =
        create_group(path, "tangents", "derivatives along the path by one parameter of any positive scale");
    for (const NumberColumn& column : tangent_columns) write_numbers(tangents.get(), column, steps);
    if (!steps.empty() && steps[0].volume_m3) write_numbers(tangents.get(), volume_tangent, steps);
    write_outputs(tangents.get(), steps, outputs, &Step::tangent_outputs);
}

std::vector<Step> read_steps(const GroupReader& path, const std::vector<std::string>& outputs) {
    const auto numbers = path.array<std::int64_t>("step", {any});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != static_cast<std::int64_t>(i))
            throw path.refuse("step[" + std::to_string(i) + "]", "is not the number of its row");
    std::vector<Step> steps(numbers.size());
    for (const NumberColumn& column : number_columns) read_numbers(path, column, steps);
    for (const CountColumn& column : count_columns) {
        const auto values = path.array<std::int64_t>(column.name, {static_cast<std::int64_t>(steps.size())});
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i].*column.member = path.small(std::string{column.name} + "[" + std::to_string(i) + "]", values[i]);
    }
    const auto stable = path.flags("stable", {static_cast<std::int64_t>(steps.size())});
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].stable = stable[i] == 1;
    read_outputs(path, steps, outputs, &Step::outputs_m);
    const GroupReader tangents = path.group("tangents");
    for (const NumberColumn& column : tangent_columns) read_numbers(tangents, column, steps);
    if (read_volumes(path, steps)) read_numbers(tangents, volume_tangent, steps);
    read_outputs(tangents, steps, outputs, &Step::tangent_outputs);
    return steps;
}

void write_end(hid_t path, const PathEnd& end, const std::vector<std::string>& outputs, std::size_t steps) {
    require_sound(end, outputs.size(), steps);
    // An attribute must fit into an object header of 64 KiB.
    constexpr std::size_t longest_detail = 4096;
    write_attribute(path, "stop_reason", name(end.reason));
    write_attribute(path, "detail", core::one_line(end.detail, longest_detail));
    write_attribute(path, "newton_iterations", std::int64_t{end.newton_iterations});
    write_attribute(path, "factorizations", std::int64_t{end.factorizations});
    write_attribute(path, "limit_points", static_cast<std::int64_t>(end.limit_points.size()));
    const std::span<const LimitPoint> points = end.limit_points;
    const GroupHandle group = create_group(path, "limit_points", "extrema of the load along the path, one row each");
    write_column(group.get(), {"step", "1", "row of the path at or before the point"}, points.size(),
                 [&](std::size_t i) { return static_cast<std::int64_t>(points[i].step); });
    write_column(group.get(), {"pressure", "Pa", "of the first load"}, points.size(),
                 [&](std::size_t i) { return points[i].pressure_Pa; });
    write_volumes(group.get(), points);
    write_outputs(group.get(), points, outputs, &LimitPoint::outputs_m);
}

PathEnd read_end(const GroupReader& path, const std::vector<std::string>& outputs, std::size_t steps) {
    PathEnd end;
    const std::string reason = path.text_attribute("stop_reason");
    const auto known = value_of(stop_reason_names, reason);
    if (!known) throw path.refuse("stop_reason", core::quoted(reason) + " is not a known value");
    end.reason = *known;
    end.detail = path.text_attribute("detail");
    end.newton_iterations = path.small("newton_iterations", path.integer_attribute("newton_iterations", 1)[0]);
    end.factorizations = path.small("factorizations", path.integer_attribute("factorizations", 1)[0]);
    const GroupReader group = path.group("limit_points");
    const auto rows = group.array<std::int64_t>("step", {any});
    if (path.integer_attribute("limit_points", 1)[0] != static_cast<std::int64_t>(rows.size()))
        throw path.refuse("limit_points", "is not their number");
    const auto pressures = group.array<double>("pressure", {static_cast<std::int64_t>(rows.size())});
    end.limit_points.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] < 0 || rows[i] >= static_cast<std::int64_t>(steps))
            throw group.refuse("step[" + std::to_string(i) + "]",
                               "step " + std::to_string(rows[i]) + " does not exist");
        end.limit_points[i].step = static_cast<int>(rows[i]);
        end.limit_points[i].pressure_Pa = pressures[i];
    }
    read_volumes(group, end.limit_points);
    read_outputs(group, end.limit_points, outputs, &LimitPoint::outputs_m);
    return end;
}

}  // namespace soft::io
