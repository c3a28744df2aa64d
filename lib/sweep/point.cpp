#include "sweep/point.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace soft::sweep {

bool is_requested(const Sweep& sweep, const post::Column& column) {
    const bool is_derivative = column.name.find('.') != std::string::npos;  // by geometry.wall: see derivatives.hpp
    if (sweep.outputs.empty()) return column.role != post::Role::counter && !is_derivative;
    return std::ranges::find(sweep.outputs, column.name, &SourceText::text) != sweep.outputs.end();
}

std::vector<post::Request> requests_of(const SourceText& point, const post::Curve& curve) {
    try {
        return post::parse_requests(point.text, curve);
    } catch (const Error& error) {
        throw Error(ExitCode::bad_input, point.location + ": at", error.what());
    }
}

bool is_named_point(const SourceText& point) { return point.text == "end" || point.text == "limit"; }

PointRow row_at(const SourceText& point, const post::Curve& curve, std::span<const model::LimitPoint> limit_points) {
    const auto row = [&curve](std::size_t r) {
        std::vector<double> values;
        for (const post::Column& column : curve.columns) values.push_back(column.values.at(r));
        return values;
    };
    if (curve.row_count() == 0) return {std::nullopt, "at " + point.text + ": the path has no rows"};
    if (point.text == "end") return {row(curve.row_count() - 1), ""};
    if (point.text == "limit") {
        if (limit_points.empty()) return {std::nullopt, "at limit: the path has no limit point"};
        return {row(static_cast<std::size_t>(limit_points.front().step)), ""};
    }
    try {
        const post::Curve there = post::rows_at(curve, requests_of(point, curve));
        std::vector<double> values;
        for (const post::Column& column : there.columns) values.push_back(column.values.front());
        return {values, ""};
    } catch (const Error& error) {
        const std::string_view reason = error.what();
        constexpr std::string_view option = "--at ";
        if (!reason.starts_with(option)) throw;  // not a point that any path could reach
        return {std::nullopt, "at " + std::string{reason.substr(option.size())}};
    }
}

std::string label_at(const std::string& quantity, const std::string& point, const std::string& by) {
    std::string label = quantity;
    std::ranges::replace(label, '_', ' ');
    return label + (by.empty() ? "" : " by " + by) + " at " + point;
}

}  // namespace soft::sweep
