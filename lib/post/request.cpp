#include "post/request.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

const Column& coordinate(const Curve& curve, std::string_view quantity) {
    const Column* column = curve.find(quantity);
    if (column == nullptr || column->role != Role::coordinate)
        throw Error(ExitCode::usage, "--at", "the curve has no " + core::quoted(quantity),
                    "it has " + curve.coordinate_names());
    return *column;
}

std::vector<std::vector<double>> rows_of(const Path& path, const Curve& curve, const Request& request) {
    const Column& column = coordinate(curve, request.quantity);
    const auto index = curve.index_of(column);
    const double value = path.within_reach(index, in_column_unit(column, request.value_SI));
    std::vector<std::vector<double>> rows;
    for (const double s : path.crossings(index, value)) {
        rows.push_back(path.at(s));
        rows.back()[index] = value;  // exact, without rounding in the last bit
    }
    return rows;
}

Error not_reached(const Path& path, const Curve& curve, const Request& request) {
    const Column& column = coordinate(curve, request.quantity);
    const Path::Range range = path.range(curve.index_of(column));
    return {ExitCode::bad_input,
            "--at " + request.quantity + "=" + core::rounded_text(in_column_unit(column, request.value_SI), 6) +
                column.unit,
            "the path does not reach it",
            "it goes from " + core::rounded_text(range.lowest, 6) + " to " + core::rounded_text(range.highest, 6) +
                " " + column.unit};
}

}  // namespace

std::vector<Request> parse_requests(std::string_view text, const Curve& curve) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        throw Error(ExitCode::usage, "--at", core::quoted(text) + " names no value", "write e.g. pressure=10kPa,20kPa");
    const std::string quantity{core::trimmed(text.substr(0, equals))};
    const Column& column = coordinate(curve, quantity);
    std::vector<Request> requests;
    for (const std::string& value : core::split(text.substr(equals + 1), ','))
        requests.push_back(
            {quantity, core::quantity_or_throw(value, column.dimension, ExitCode::usage, "--at " + quantity)});
    return requests;
}

std::vector<std::vector<double>> crossing_rows(const Curve& curve, const Request& request) {
    return rows_of(Path(curve), curve, request);
}

Curve rows_at(const Curve& curve, std::span<const Request> requests) {
    const Path path(curve);
    Curve table = curve;
    table.kinks.clear();
    for (Column& column : table.columns) {
        column.values.clear();
        column.slopes.clear();
    }
    for (const Request& request : requests) {
        const std::vector<std::vector<double>> found = rows_of(path, curve, request);
        if (found.empty()) throw not_reached(path, curve, request);
        for (const std::vector<double>& row : found)
            for (std::size_t i = 0; i < row.size(); ++i) table.columns[i].values.push_back(row[i]);
    }
    return table;
}

}  // namespace soft::post
