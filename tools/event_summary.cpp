#include "event_summary.hpp"

#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "model/location.hpp"

namespace soft::cli {
namespace {

/// "12.3 kPa", "2 N", or "load factor 0.5" for a case without pressures, tractions and forces.
std::string load_text(double load, const model::Case& model) {
    switch (model::leading_load(model)) {
        case model::LeadingLoad::pressure:
        case model::LeadingLoad::traction: return core::rounded_text(1e-3 * load, 5) + " kPa";
        case model::LeadingLoad::force: return core::rounded_text(load, 5) + " N";
        case model::LeadingLoad::load_factor: break;
    }
    return "load factor " + core::rounded_text(load, 5);
}

std::string output_text(const model::Output& output, double value) {
    const model::MeasureUnit& unit = model::unit_of(output.measure);
    return output.name + " " + core::rounded_text(value / unit.SI_per_shown, 6) + " " + std::string{unit.shown};
}

nlohmann::ordered_json contact_json(const nlohmann::ordered_json& point, const model::FirstContact& contact,
                                    const model::Case& model) {
    nlohmann::ordered_json json = {{"kind", "first_contact"}};
    json.update(point);
    json["obstacle"] = contact.obstacle < 0 ? std::string{model::self_contact}
                                            : model.obstacles[static_cast<std::size_t>(contact.obstacle)].name;
    for (const double position_m : contact.location_m) json["location_mm"].push_back(1e3 * position_m);
    json["text"] = model::contact_text(model, contact);
    return json;
}

std::vector<std::string> first_few(std::vector<std::string> lines, const std::string& further) {
    constexpr std::size_t max_lines = 6;
    if (lines.size() <= max_lines) return lines;
    const std::size_t more = lines.size() - max_lines;
    lines.resize(max_lines);
    lines.push_back(core::counted(more, further) + ", see postprocess");
    return lines;
}

std::vector<std::string> limit_lines(const model::PathEnd& end, int steps, const model::Case& model) {
    std::vector<std::string> lines;
    for (const model::LimitPoint& point : end.limit_points)
        if (point.step < steps) lines.push_back("limit point at " + location_text(point, model));
    return first_few(std::move(lines), "further limit point");
}

std::vector<std::string> bifurcation_lines(const model::PathEnd& end, const model::Case& model) {
    std::vector<std::string> lines;
    for (const auto& bifurcation : end.bifurcations) {
        const std::string leaving =
            bifurcation.modes == 1
                ? "another branch intersects the path"
                : std::to_string(bifurcation.modes) + " critical modes, so several branches intersect the path";
        lines.push_back(
            "bifurcation at " + location_text(bifurcation.at, model) + ": " + leaving +
            (bifurcation.mode.empty() ? "; no mode is stored" : "; the mode is stored in the result (/modes)"));
    }
    return lines;
}

std::vector<std::string> contact_lines(const model::PathEnd& end, const model::Case& model) {
    std::vector<std::string> lines;
    for (const model::FirstContact& contact : end.first_contacts)
        lines.push_back("first contact at " + location_text(contact.at, model) + ": " +
                        model::contact_text(model, contact));
    return first_few(std::move(lines), "further first contact");
}

}  // namespace

std::string location_text(const model::LimitPoint& point, const model::Case& model) {
    std::string text = load_text(point.pressure_Pa, model);
    for (std::size_t i = 0; i < point.outputs.size(); ++i)
        text += ", " + output_text(model.outputs[i], point.outputs[i]);
    if (point.volume_m3) text += ", volume " + core::rounded_text(1e6 * *point.volume_m3, 6) + " mL";
    return text;
}

void add_point(nlohmann::ordered_json& json, const model::LimitPoint& point, const model::Case& model) {
    switch (model::leading_load(model)) {
        case model::LeadingLoad::pressure: json["pressure_Pa"] = point.pressure_Pa; break;
        case model::LeadingLoad::traction: json["traction_Pa"] = point.pressure_Pa; break;
        case model::LeadingLoad::force: json["load_N"] = point.pressure_Pa; break;
        case model::LeadingLoad::load_factor: json["load_factor"] = point.pressure_Pa; break;
    }
    if (point.volume_m3) json["volume_m3"] = *point.volume_m3;
    for (std::size_t i = 0; i < point.outputs.size(); ++i)
        json[model.outputs[i].name + "_" + std::string{model::unit_of(model.outputs[i].measure).SI_suffix}] =
            point.outputs[i];
}

void add_events(nlohmann::ordered_json& json, const model::PathEnd& end, const model::Case& model,
                const PointJson& point_json) {
    for (const char* key : {"limit_points", "bifurcations", "events"}) json[key] = nlohmann::ordered_json::array();
    for (const model::LimitPoint& limit : end.limit_points) json["limit_points"].push_back(point_json(limit));
    for (const model::Bifurcation& bifurcation : end.bifurcations) {
        nlohmann::ordered_json point = point_json(bifurcation.at);
        point["modes"] = bifurcation.modes;
        point["mode_stored"] = !bifurcation.mode.empty();
        json["bifurcations"].push_back(std::move(point));
    }
    for (const model::FirstContact& contact : end.first_contacts)
        json["events"].push_back(contact_json(point_json(contact.at), contact, model));
}

std::vector<std::string> event_lines(const model::PathEnd& end, int steps, const model::Case& model) {
    std::vector<std::string> lines = limit_lines(end, steps, model);
    for (const auto& more : {bifurcation_lines(end, model), contact_lines(end, model)})
        lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

}  // namespace soft::cli
