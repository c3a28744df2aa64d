#include "postprocess_summary.hpp"

#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"

namespace soft {
namespace {

/// The point's coordinates by the names of the curve's columns.
nlohmann::ordered_json place_json(const post::Curve& curve, const solution::LimitPoint& point) {
    nlohmann::ordered_json json = {{"step", point.step}};
    for (const post::Column& column : curve.columns)
        if (const auto value = post::value_at(column, point)) json[column.name] = *value;
    return json;
}

std::string place_line(const nlohmann::ordered_json& place) {
    std::vector<std::string> words;
    for (const auto& [name, value] : place.items())
        if (name != "step" && value.is_number_float())
            words.push_back(name + " " + core::rounded_text(value.get<double>(), 6));
    return core::join(words);
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
                                   {"limit_points", nlohmann::ordered_json::array()},
                                   {"bifurcations", nlohmann::ordered_json::array()}};
    for (const post::Column& column : curve.columns) json["columns"].push_back(column.name);
    if (!result.end) return json;
    json["stop_reason"] = solution::name(result.end->reason);
    json["detail"] = result.end->detail;
    json["newton_iterations"] = result.end->newton_iterations;
    json["factorizations"] = result.end->factorizations;
    for (const solution::LimitPoint& limit : result.end->limit_points)
        json["limit_points"].push_back(place_json(curve, limit));
    for (const solution::Bifurcation& bifurcation : result.end->bifurcations) {
        json["bifurcations"].push_back(place_json(curve, bifurcation.at));
        json["bifurcations"].back()["modes"] = bifurcation.modes;
        json["bifurcations"].back()["mode_stored"] = !bifurcation.mode.empty();
    }
    return json;
}

std::vector<std::string> summary_lines(const nlohmann::ordered_json& json) {
    const std::string reason = json["stop_reason"].is_null() ? "not finished: solve was stopped or is still at work"
                                                             : json["stop_reason"].get<std::string>();
    const std::string detail = json.value("detail", "");
    std::vector<std::string> lines{std::to_string(json["rows"].get<std::size_t>()) + " rows of " +
                                   std::to_string(json["steps"].get<std::size_t>()) + " steps; path: " + reason +
                                   (detail.empty() ? "" : " (" + detail + ")")};
    for (const auto& limit : json["limit_points"]) lines.push_back("limit point: " + place_line(limit));
    for (const auto& branch : json["bifurcations"]) lines.push_back("bifurcation: " + place_line(branch));
    return lines;
}

}  // namespace soft
