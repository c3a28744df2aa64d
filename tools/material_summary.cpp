#include "material_summary.hpp"

#include <nlohmann/json.hpp>

#include "design/fitted.hpp"

namespace soft::cli {
namespace {

nlohmann::ordered_json text_or_null(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
}

}  // namespace

nlohmann::ordered_json materials_json(const model::Case& model, std::string_view effective_yaml) {
    auto list = nlohmann::ordered_json::array();
    for (const model::Material& material : model.materials) {
        nlohmann::ordered_json json = {{"name", material.name},
                                       {"section", material.source},
                                       {"law", material.law},
                                       {"constants", nlohmann::ordered_json::object()}};
        for (const auto& [name, values] : material.constants)
            json["constants"][name] =
                values.size() == 1 ? nlohmann::ordered_json(values.front()) : nlohmann::ordered_json(values);
        if (const auto fitted = design::fitted_material(effective_yaml, material.source))
            json["fit"] = {{"name", text_or_null(fitted->name)},
                           {"range", fitted->range},
                           {"max_I1", fitted->max_I1},
                           {"max_error", text_or_null(fitted->max_error)}};
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace soft::cli
