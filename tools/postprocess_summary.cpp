#include "postprocess_summary.hpp"

#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"

namespace soft {
namespace {

/// The limit point's coordinates by the names of the curve's columns.
nlohmann::ordered_json limit_point_json(const post::Curve& curve, const solution::LimitPoint& limit) {
    nlohmann::ordered_json json = {{"step", limit.step}};
    auto output = limit.outputs_m.begin();
    for (const post::Column& column : curve.columns) {
        if (column.role != post::Role::coordinate) continue;
        if (column.quantity == "pressure")
            json[column.name] = post::in_column_unit(column, limit.pressure_Pa);
        else if (column.dimension == core::Dimension::volume)
            json[column.name] = post::in_column_unit(column, limit.volume_m3.value_or(0));
        else if (output != limit.outputs_m.end())
            json[column.name] = post::in_column_unit(column, *output++);
    }
    return json;
}

}  // namespace

nlohmann::ordered_json postprocess_summary(const io::Result& result, const post::Curve& curve, std::size_t rows) {
    nlohmann::ordered_json json = {{"tool", "postprocess"},
                                   {"version", cli::version()},
                                   {"revision", cli::revision()},
                                   {"case", result.model.name},
                                   {"rows", rows},
                                   {"steps", result.steps.size()},
                                   {"columns", nlohmann::ordered_json::array()},
                                   {"stop_reason", nullptr},
                                   {"limit_points", nlohmann::ordered_json::array()}};
    for (const post::Column& column : curve.columns) json["columns"].push_back(column.name);
    if (!result.end) return json;
    json["stop_reason"] = solution::name(result.end->reason);
    json["detail"] = result.end->detail;
    json["newton_iterations"] = result.end->newton_iterations;
    json["factorizations"] = result.end->factorizations;
    for (const solution::LimitPoint& limit : result.end->limit_points)
        json["limit_points"].push_back(limit_point_json(curve, limit));
    return json;
}

std::vector<std::string> summary_lines(const nlohmann::ordered_json& json) {
    const std::string reason = json["stop_reason"].is_null() ? "not finished: solve was stopped or is still at work"
                                                             : json["stop_reason"].get<std::string>();
    const std::string detail = json.value("detail", "");
    std::vector<std::string> lines{std::to_string(json["rows"].get<std::size_t>()) + " rows of " +
                                   std::to_string(json["steps"].get<std::size_t>()) + " steps; path: " + reason +
                                   (detail.empty() ? "" : " (" + detail + ")")};
    for (const auto& limit : json["limit_points"]) {
        std::vector<std::string> words;
        for (const auto& [name, value] : limit.items())
            if (name != "step") words.push_back(name + " " + core::rounded_text(value.get<double>(), 6));
        lines.push_back("limit point: " + core::join(words));
    }
    return lines;
}

}  // namespace soft
