#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "material/catalogue.hpp"
#include "material/stability.hpp"
#include "mesh/quality.hpp"
#include "model/rubber.hpp"
#include "view/sections.hpp"
#include "view/text.hpp"

namespace soft::view {
namespace {

std::string cell_names(const mesh::Mesh& mesh) {
    std::vector<std::string> names;
    for (const mesh::CellType type : mesh.cell_types) {
        const std::string name{mesh::topology(type).name};
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return core::join(names);
}

std::string_view formulation_text(const model::Case& model) {
    switch (model.formulation) {
        case material::Form::mixed: return "displacement and pressure (mixed)";
        case material::Form::displacement: return "displacement alone";
        case material::Form::f_bar: return "F-bar";
    }
    return "";
}

/// The error estimate of `solve --tolerance`, or how to obtain one.
std::string error_text(const post::Curve& curve) {
    std::vector<std::string> words;
    for (const post::Column& column : curve.columns) {
        const post::Column* error = curve.find(column.quantity + "_error");
        if (error == nullptr) continue;
        const double half = *std::max_element(error->values.begin(), error->values.end());
        double largest = 0;
        for (const double value : column.values) largest = std::max(largest, std::abs(value));
        words.push_back(
            column.quantity + " \u00B1 " + core::rounded_text(half, 2) + " " + column.unit +
            (largest > 0 ? " (" + core::rounded_text(100 * half / largest, 2) + " % of its largest value)" : ""));
    }
    if (words.empty() && curve.find("time") != nullptr)
        return "The discretization error has not been estimated. Compare with mesh.refine: 1 and a smaller dynamics.accuracy.";
    if (words.empty())
        return "The discretization error has not been estimated. solve --tolerance 1% refines the mesh until the error is below 1 % "
               "and adds an error bar to every step.";
    return "Largest discretization error along the path, estimated by refinement: " + core::join(words) +
           ". The table lists it for every step.";
}

std::string quantity_text(const material::Parameter& parameter, double value) {
    switch (parameter.quantity) {
        case material::Quantity::pressure: return core::quantity_text(value, core::Dimension::pressure);
        case material::Quantity::angle: return core::quantity_text(value, core::Dimension::angle);
        case material::Quantity::ratio:
        case material::Quantity::count: break;
    }
    return core::rounded_text(value, 6);
}

std::string constants_text(const material::LawInfo& law, const model::Material& rubber) {
    std::vector<std::string> words;
    for (const material::Parameter& parameter : law.parameters) {
        const auto constant = rubber.constants.find(std::string{parameter.name});
        if (constant == rubber.constants.end()) continue;
        std::vector<std::string> values;
        for (const double value : constant->second) values.push_back(quantity_text(parameter, value));
        words.push_back(std::string{parameter.name} + " = " + core::join(values));
    }
    words.push_back(rubber.bulk_modulus_Pa
                        ? "kappa = " + core::quantity_text(*rubber.bulk_modulus_Pa, core::Dimension::pressure)
                        : std::string{"incompressible"});
    return core::join(words);
}

std::string fibers_text(const model::Fibers& fibers) {
    const std::string angle = core::quantity_text(fibers.angle_rad, core::Dimension::angle);
    return std::string{fibers.families == 2 ? "two families at plus and minus " : "one family at "} + angle +
           " from the axis, k1 = " + core::quantity_text(fibers.k1_Pa, core::Dimension::pressure) +
           ", k2 = " + core::rounded_text(fibers.k2, 6);
}

/// The range of stretches in which the law is stable, within the range that is checked.
std::string range_text(const model::Material& rubber) {
    const std::string checked = " between stretches of " + core::rounded_text(material::default_stretch_range.min, 2) +
                                " and " + core::rounded_text(material::default_stretch_range.max, 2);
    const std::string limits = material::stability_text(material::stability_limits(model::make_rubber(rubber)));
    return limits.empty() ? "stable (Drucker)" + checked : limits + " (Drucker, checked" + checked + ")";
}

}  // namespace

std::string mesh_section(const Content& content) {
    const model::Case& model = content.result.model;
    const mesh::Quality quality = mesh::quality(model.mesh);
    const std::vector<Row> rows = {
        {{"cells", std::to_string(model.mesh.cell_count()) + " " + cell_names(model.mesh)}},
        {{"points", std::to_string(model.mesh.points.size())}},
        {{"unknowns of a cell", std::string{formulation_text(model)}}},
        {{"fraction of the actuator in the mesh", core::rounded_text(model.model_fraction, 4)}},
        {{"minimum scaled Jacobian of a cell", core::rounded_text(quality.min_scaled_jacobian, 3)}}};
    return "<h2>Verification of the mesh</h2>\n<p id='mesh-error'>" + escaped(error_text(content.curve)) + "</p>\n" +
           html_table({}, rows);
}

std::string material_section(const Content& content) {
    std::string html = "<h2>Materials</h2>\n";
    for (const model::Material& rubber : content.result.model.materials) {
        const material::LawInfo* law = material::find_law(rubber.law);
        if (law == nullptr) continue;  // read_result has refused it
        std::vector<Row> rows = {
            {{"in the design", rubber.source}},
            {{"law", rubber.law + (rubber.strain == model::Strain::small ? ", linear in the strain" : "")}},
            {{"energy per undeformed volume", std::string{law->energy}}},
            {{"constants", constants_text(*law, rubber)}},
            {{"valid for", std::string{law->validity}}},
            {{"range", range_text(rubber)}},
            {{"source", std::string{law->source}}}};
        if (rubber.fibers) rows.push_back({{"fibres", fibers_text(*rubber.fibers)}});
        html += "<h3>" + escaped(rubber.name) + "</h3>\n" + html_table({}, rows);
    }
    const std::vector<model::Step>& steps = content.result.steps;
    const auto by_stretch = [](const model::Step& a, const model::Step& b) { return a.stretch_p99 < b.stretch_p99; };
    if (!steps.empty()) {
        const double reached = std::max_element(steps.begin(), steps.end(), by_stretch)->stretch_p99;
        html += "<p>On this path the principal stretch of 99 % of the rubber is at most " +
                core::rounded_text(reached, 4) + ".</p>\n";
    }
    for (const std::string& note : content.material_notes) html += "<p>" + escaped(note) + "</p>\n";
    return html;
}

}  // namespace soft::view
