#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/text.hpp"
#include "io/path_columns.hpp"
#include "io/path_table.hpp"

namespace soft::io {
namespace {

using model::Bifurcation;
using model::LimitPoint;
using model::PathEnd;

template <class At>
std::vector<LimitPoint> positions_of(const std::vector<At>& events) {
    return column(events, [](const At& event) { return event.at; });
}

void require_valid(std::span<const LimitPoint> points, const model::Case& model, std::size_t steps) {
    for (const LimitPoint& point : points) {
        const bool row = point.step >= 0 && static_cast<std::size_t>(point.step) < steps;
        const bool values = point.outputs.size() == model.outputs.size() && all_finite(point.outputs) &&
                            std::isfinite(point.pressure_Pa) && std::isfinite(point.volume_m3.value_or(0)) &&
                            point.volume_m3.has_value() == points[0].volume_m3.has_value();
        if (!row || !values)
            throw Error(ExitCode::internal, "/path", "a limit point or bifurcation does not fit the path");
    }
}

void write_points(hid_t group, std::span<const LimitPoint> points, const model::Case& model) {
    write_column(group, {"step", "1", "row of the path at the point"}, points.size(),
                 [&](std::size_t i) { return static_cast<std::int64_t>(points[i].step); });
    write_column(group, {"pressure", load_units(model), "as /path/pressure"}, points.size(),
                 [&](std::size_t i) { return points[i].pressure_Pa; });
    if (!points.empty() && points[0].volume_m3)
        write_column(group, {"cavity_volume", "m3", "as /path/cavity_volume"}, points.size(),
                     [&](std::size_t i) { return *points[i].volume_m3; });
    write_lists(group, output_columns(model), points, &LimitPoint::outputs);
}

std::vector<LimitPoint> read_points(const GroupReader& group, const model::Case& model, std::size_t steps) {
    const auto rows = group.array<std::int64_t>("step", {any});
    const auto pressures = group.array<double>("pressure", {extent(rows.size())});
    std::vector<LimitPoint> points(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] < 0 || rows[i] >= extent(steps))
            throw group.refuse("step[" + std::to_string(i) + "]",
                               "step " + std::to_string(rows[i]) + " does not exist");
        points[i].step = static_cast<int>(rows[i]);
        points[i].pressure_Pa = pressures[i];
    }
    if (group.has("cavity_volume")) {
        const auto volumes = group.array<double>("cavity_volume", {extent(points.size())});
        for (std::size_t i = 0; i < points.size(); ++i) points[i].volume_m3 = volumes[i];
    }
    read_lists(group, output_columns(model), points, &LimitPoint::outputs);
    return points;
}

std::vector<Bifurcation> read_bifurcations(const GroupReader& group, const model::Case& model, std::size_t steps) {
    const auto points = read_points(group, model, steps);
    const auto modes = group.array<std::int64_t>("modes", {extent(points.size())});
    std::vector<Bifurcation> bifurcations;
    for (std::size_t i = 0; i < points.size(); ++i)
        bifurcations.push_back({points[i], group.to_int("modes[" + std::to_string(i) + "]", modes[i], 1), {}});
    return bifurcations;
}

void write_contacts(hid_t path, const PathEnd& end, const model::Case& model) {
    const auto& contacts = end.first_contacts;
    const GroupHandle group =
        create_group(path, "first_contacts", "first contacts with walls or obstacles, one row each");
    write_points(group.get(), positions_of(contacts), model);
    write_column(group.get(), {"obstacle", "1", "index of the obstacle in the design, -1: itself"}, contacts.size(),
                 [&](std::size_t i) { return static_cast<std::int64_t>(contacts[i].obstacle); });
    write_list(group.get(), {"location", "m", "undeformed position"},
               rows_of_three<double>(contacts, [](const model::FirstContact& contact) { return contact.location_m; }),
               {contacts.size(), 3});
}

std::vector<model::FirstContact> read_contacts(const GroupReader& group, const model::Case& model, std::size_t steps) {
    const auto points = read_points(group, model, steps);
    const auto obstacles = group.array<std::int64_t>("obstacle", {extent(points.size())});
    const auto locations = group.array<double>("location", {extent(points.size()), 3});
    std::vector<model::FirstContact> contacts;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (obstacles[i] < -1 || obstacles[i] >= extent(model.obstacles.size()))
            throw group.refuse("obstacle[" + std::to_string(i) + "]", "this obstacle does not exist");
        contacts.push_back({points[i], static_cast<int>(obstacles[i]), triple<double>(locations, i)});
    }
    return contacts;
}

}  // namespace

void write_end(hid_t path, const PathEnd& end, const model::Case& model, std::size_t steps) {
    const auto branching = positions_of(end.bifurcations);
    require_valid(end.limit_points, model, steps);
    require_valid(branching, model, steps);
    require_valid(positions_of(end.first_contacts), model, steps);
    // An attribute must fit into an object header of 64 KiB.
    constexpr std::size_t max_detail_bytes = 4096;
    write_attribute(path, "stop_reason", name(end.reason));
    write_attribute(path, "detail", core::one_line(end.detail, max_detail_bytes));
    write_attribute(path, "newton_iterations", std::int64_t{end.newton_iterations});
    write_attribute(path, "factorizations", std::int64_t{end.factorizations});
    write_attribute(path, "limit_points", extent(end.limit_points.size()));
    write_attribute(path, "bifurcations", extent(branching.size()));
    const GroupHandle limits =
        create_group(path, "limit_points", "extrema of the leading load along the path, one row each");
    write_points(limits.get(), end.limit_points, model);
    const GroupHandle group = create_group(path, "bifurcations", "intersections with other branches, one row each");
    write_points(group.get(), branching, model);
    write_column(group.get(), {"modes", "1", "eigenvalues of the tangent that change sign"}, branching.size(),
                 [&](std::size_t i) { return static_cast<std::int64_t>(end.bifurcations[i].modes); });
    write_contacts(path, end, model);
}

PathEnd read_end(const GroupReader& path, const model::Case& model, std::size_t steps) {
    PathEnd end;
    const std::string reason = path.text_attribute("stop_reason");
    const auto known = value_of(stop_reason_names, reason);
    if (!known) throw path.refuse("stop_reason", core::quoted(reason) + " is not a known value");
    end.reason = *known;
    end.detail = path.text_attribute("detail");
    end.newton_iterations = path.to_int("newton_iterations", path.integer_attribute("newton_iterations", 1)[0]);
    end.factorizations = path.to_int("factorizations", path.integer_attribute("factorizations", 1)[0]);
    end.limit_points = read_points(path.group("limit_points"), model, steps);
    end.bifurcations = read_bifurcations(path.group("bifurcations"), model, steps);
    end.first_contacts = read_contacts(path.group("first_contacts"), model, steps);
    if (path.integer_attribute("limit_points", 1)[0] != extent(end.limit_points.size()))
        throw path.refuse("limit_points", "does not match the number of limit points");
    if (path.integer_attribute("bifurcations", 1)[0] != extent(end.bifurcations.size()))
        throw path.refuse("bifurcations", "does not match the number of bifurcations");
    return end;
}

void write_modes(hid_t root, const PathEnd& end, std::size_t points) {
    std::vector<std::int64_t> owners;
    for (std::size_t i = 0; i < end.bifurcations.size(); ++i)
        if (!end.bifurcations[i].mode.empty()) owners.push_back(extent(i));
    if (owners.empty()) return;
    const GroupHandle group =
        create_group(root, "modes", "bifurcation modes: initial directions of the other branches");
    write_list(group.get(), {"bifurcation", "1", "row of /path/bifurcations of each mode"}, owners);
    const DatasetHandle rows = create_rows(
        group.get(), {"displacement", "1", "mode, point, component; the largest displacement is 1"}, {points, 3});
    for (const std::int64_t owner : owners) {
        const auto& mode = end.bifurcations[static_cast<std::size_t>(owner)].mode;
        if (mode.size() != 3 * points || !all_finite(mode))
            throw Error(ExitCode::internal, "/modes/displacement",
                        "a mode does not have three finite values per point");
        append_row(rows.get(), mode);
    }
}

void read_modes(const GroupReader& root, PathEnd& end, std::size_t points) {
    if (!root.has("modes")) return;
    const GroupReader group = root.group("modes");
    const auto owners = group.array<std::int64_t>("bifurcation", {any});
    const DatasetHandle rows = group.checked_rows("displacement", {extent(owners.size()), extent(points), 3});
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (owners[i] <= (i == 0 ? -1 : owners[i - 1]) || owners[i] >= extent(end.bifurcations.size()))
            throw group.refuse("bifurcation[" + std::to_string(i) + "]",
                               "bifurcation " + std::to_string(owners[i]) + " does not exist or is out of order");
        end.bifurcations[static_cast<std::size_t>(owners[i])].mode =
            group.row(rows.get(), "displacement", extent(i), 3 * points);
    }
}

}  // namespace soft::io
