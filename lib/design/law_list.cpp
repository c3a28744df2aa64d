#include "design/law_list.hpp"

#include <algorithm>
#include <sstream>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/checks.hpp"
#include "design/markdown.hpp"
#include "design/material_library.hpp"
#include "design/materials.hpp"

namespace soft::design {
namespace {

constexpr std::size_t max_line_width = 120;

/// Wraps `text` at `max_line_width`; the first line starts with `head`, the others are indented by its width.
std::string wrapped(std::string head, const std::string& text) {
    const std::size_t indent = head.size();
    std::string lines, line = std::move(head);
    std::istringstream words{text};
    bool first = true;
    for (std::string word; words >> word; first = false) {
        if (!first && line.size() + 1 + word.size() > max_line_width) {
            lines.append(line).append("\n");
            line.assign(indent, ' ');
            first = true;
        }
        line.append(first ? "" : " ").append(word);
    }
    return lines.append(line).append("\n");
}

std::string unit_of(material::Quantity quantity) {
    switch (quantity) {
        case material::Quantity::pressure: return "Pa, kPa, MPa";
        case material::Quantity::ratio: return "ratio";
        case material::Quantity::angle: return "deg, rad";
        case material::Quantity::count: return "number";
    }
    return "";
}

std::string range_of(const material::Parameter& parameter) {
    std::string text = range_text(parameter_key(parameter));
    if (!parameter.fallback.empty()) text.append("; default ").append(parameter.fallback);
    return text;
}

/// The volumetric parameters of a law.
std::string bulk_of(const material::LawInfo& law) {
    std::string text = law.bulk == material::Bulk::finite ? "kappa (required)" : "kappa or incompressible";
    if (law.takes_volumetric) text += ", volumetric";
    if (law.takes_young_poisson) text += "; or young and poisson in place of mu and kappa";
    return text;
}

std::string forms_of(const material::LawInfo& law) {
    std::string text{"displacement"};
    if (law.mixed) text += ", mixed";
    if (law.f_bar) text += ", f-bar";
    return text;
}

std::string plain() {
    constexpr std::size_t name_column = 18;
    std::string text;
    for (const material::LawInfo& law : material::laws()) {
        text.append(text.empty() ? "" : "\n").append(law.name).append("\n");
        text += wrapped("  W               ", std::string{law.energy});
        text += wrapped("  use             ", std::string{law.validity});
        for (const material::Parameter& parameter : law.parameters) {
            std::string head(2, ' ');
            head.append(parameter.name);
            head.resize(std::max(head.size() + 1, name_column), ' ');
            text += wrapped(head, range_of(parameter) + ": " + std::string{parameter.meaning});
        }
        text += wrapped("  volume          ", bulk_of(law));
        text += wrapped("  runs as         ", forms_of(law));
        text += wrapped("  source          ", std::string{law.source});
    }
    std::vector<std::string> names;
    for (const MaterialFile& file : material_files()) names.emplace_back(file.name);
    return text + "\nsilicones of the library\n" + wrapped("  names           ", core::join(names));
}

/// "54.43 kPa" for "54.43110081 kPa".
std::string rounded(const std::string& quantity) {
    constexpr int digits = 4;
    const core::QuantityParts parts = core::quantity_parts(quantity);
    return core::rounded_text(std::stod(parts.number), digits) + (parts.unit.empty() ? "" : " ") + parts.unit;
}

/// The constants of a set of the material library: "c1 = 54.43 kPa, c2 = 9.162 kPa".
std::string constants_of(const MaterialSet& set) {
    std::vector<std::string> constants;
    for (const material::Parameter& parameter : material::find_law(set.law)->parameters)
        if (const Node* value = find(set.block, parameter.name))
            constants.push_back(std::string{parameter.name} + " = " + rounded(value->text));
    return core::join(constants);
}

std::string material_table() {
    std::string text = table_head({"name", "law", "range of strain", "constants", "largest error"});
    for (const MaterialFile& file : material_files())
        for (const MaterialSet& set : material_sets(file)) {
            const Node* error = find_path(set.block, "fit.max_error");
            text += table_row({std::string{file.name}, set.law, set.strain_text, constants_of(set),
                               error == nullptr ? "-" : error->text});
        }
    return text;
}

std::string markdown() {
    std::string text = "## Laws\n\n" + table_head({"law", "energy per undeformed volume", "use", "source"});
    for (const material::LawInfo& law : material::laws())
        text +=
            table_row({std::string{law.name}, code(law.energy), std::string{law.validity}, std::string{law.source}});
    text += "\n## Parameters\n\n" + table_head({"law", "parameter", "unit", "range", "meaning"});
    for (const material::LawInfo& law : material::laws())
        for (const material::Parameter& parameter : law.parameters)
            text += table_row({std::string{law.name}, code(parameter.name), unit_of(parameter.quantity),
                               range_of(parameter), std::string{parameter.meaning}});
    text += "\n## Volumetric parameters and formulations\n\n" +
            table_head({"law", "volumetric parameters", "`mesh.formulation`"});
    for (const material::LawInfo& law : material::laws())
        text += table_row({std::string{law.name}, bulk_of(law), forms_of(law)});
    return text + "\n## Silicones of the material library\n\n" + material_table();
}

}  // namespace

std::string law_list(LawListStyle style) { return style == LawListStyle::plain ? plain() : markdown(); }

}  // namespace soft::design
