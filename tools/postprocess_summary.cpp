#include "postprocess_summary.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"
#include "design/fitted.hpp"
#include "event_summary.hpp"
#include "material_summary.hpp"
#include "post/cycles.hpp"

namespace soft {
namespace {

/// Values of the curve at the point, keyed by column name.
nlohmann::ordered_json location_json(const post::Curve& curve, const model::LimitPoint& point) {
    nlohmann::ordered_json json = {{"step", point.step}};
    for (const post::Column& column : curve.columns)
        if (const auto value = post::value_at(column, point)) json[column.name] = *value;
    return json;
}

std::string location_line(const nlohmann::ordered_json& point) {
    std::vector<std::string> words;
    for (const auto& [name, value] : point.items())
        if (name != "step" && value.is_number_float())
            words.push_back(name + " " + core::rounded_text(value.get<double>(), 6));
    return core::join(words);
}

const std::string& effective_design(const io::Result& result) {
    return (result.changed_design ? *result.changed_design : result.design).effective_yaml;
}

/// Test data of the fitted constants and the stretch reached by the result; null if the design has no fit data.
nlohmann::ordered_json fit_json(const io::Result& result) {
    const std::string& design = effective_design(result);
    const auto fitted = design::fitted_material(design);
    if (!fitted) return nullptr;
    double stretch = 1;
    for (const model::Step& step : result.steps) stretch = std::max(stretch, step.stretch_p99);
    nlohmann::ordered_json json = {{"name", nullptr},        {"law", fitted->law},
                                   {"range", fitted->range}, {"max_I1", fitted->max_I1},
                                   {"stretch_p99", stretch}, {"within", fitted->covers(stretch)}};
    if (!fitted->name.empty()) json["name"] = fitted->name;
    if (!fitted->max_error.empty()) json["max_error"] = fitted->max_error;
    if (const auto advice = design::fit_range_advice(design, stretch)) json["advice"] = *advice;
    return json;
}

std::string fit_line(const nlohmann::ordered_json& fit) {
    return "material: " + (fit["name"].is_null() ? "" : fit["name"].get<std::string>() + ", ") +
           fit["law"].get<std::string>() + " fitted over " + fit["range"].get<std::string>() + " strain" +
           (fit.contains("max_error") ? ", stress within " + fit["max_error"].get<std::string>() : "") +
           "; the rubber reaches a stretch of " + core::rounded_text(fit["stretch_p99"].get<double>(), 3);
}

}  // namespace

nlohmann::ordered_json postprocess_summary(const io::Result& result, const post::Curve& curve, std::size_t rows) {
    nlohmann::ordered_json json = cli::summary_head("postprocess");
    json.update({{"case", result.model.name},
                 {"rows", rows},
                 {"steps", result.steps.size()},
                 {"columns", nlohmann::ordered_json::array()},
                 {"materials", cli::materials_json(result.model, effective_design(result))},
                 {"material_fit", fit_json(result)},
                 {"stop_reason", nullptr}});
    cli::add_events(json, result.end.value_or(model::PathEnd{}), result.model,
                    [&](const model::LimitPoint& point) { return location_json(curve, point); });
    for (const post::Column& column : curve.columns) json["columns"].push_back(column.name);
    if (!result.end) return json;
    json["stop_reason"] = model::name(result.end->reason);
    json["detail"] = result.end->detail;
    json["newton_iterations"] = result.end->newton_iterations;
    json["factorizations"] = result.end->factorizations;
    return json;
}

nlohmann::ordered_json cycles_json(const io::Result& result) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const post::CycleEnergy& energy : post::cycle_energies(result.model, result.steps)) {
        json.push_back({{"cycle", energy.cycle},
                        {"load_work_mJ", 1e3 * energy.load_work_J},
                        {"dissipated_energy_mJ", 1e3 * energy.dissipated_J}});
        if (energy.friction_J) json.back()["friction_work_mJ"] = 1e3 * *energy.friction_J;
    }
    return json;
}

std::vector<std::string> summary_lines(const nlohmann::ordered_json& json) {
    const std::string reason = json["stop_reason"].is_null() ? "not finished: solve was interrupted or is still running"
                                                             : json["stop_reason"].get<std::string>();
    const std::string detail = json.value("detail", "");
    std::vector<std::string> lines{core::counted(json["rows"].get<std::size_t>(), "row") + " of " +
                                   core::counted(json["steps"].get<std::size_t>(), "step") + "; path: " + reason +
                                   (detail.empty() ? "" : " (" + detail + ")")};
    for (const auto& limit : json["limit_points"]) lines.push_back("limit point: " + location_line(limit));
    for (const auto& branch : json["bifurcations"]) lines.push_back("bifurcation: " + location_line(branch));
    for (const auto& contact : json["events"])
        lines.push_back("first contact: " + location_line(contact) + ": " + contact["text"].get<std::string>());
    if (json.contains("cycles")) {
        const auto& last = json["cycles"].back();
        lines.push_back(
            "cycle " + std::to_string(last["cycle"].get<int>()) + ": the loads do " +
            core::rounded_text(last["load_work_mJ"].get<double>(), 4) + " mJ of work, " +
            core::rounded_text(last["dissipated_energy_mJ"].get<double>() + last.value("friction_work_mJ", 0.0), 4) +
            " mJ are dissipated");
    }
    if (const auto& fit = json["material_fit"]; !fit.is_null()) lines.push_back(fit_line(fit));
    return lines;
}

std::optional<std::string> material_advice(const nlohmann::ordered_json& json) {
    const auto& fit = json["material_fit"];
    return fit.contains("advice") ? std::optional{fit["advice"].get<std::string>()} : std::nullopt;
}

std::vector<std::string> material_notes(const nlohmann::ordered_json& json) {
    std::vector<std::string> notes;
    if (json["material_fit"].is_null()) return notes;
    notes.push_back(fit_line(json["material_fit"]));
    if (const auto advice = material_advice(json)) notes.push_back(*advice);
    return notes;
}

}  // namespace soft
