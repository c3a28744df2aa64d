#include "design/law_list.hpp"

#include <algorithm>
#include <sstream>

#include "design/checks.hpp"
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
    return text;
}

/// Escapes the bars of a Markdown table cell.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string code(std::string_view text) { return std::string{}.append("`").append(text).append("`"); }

std::string markdown() {
    std::string text =
        "| law | energy per undeformed volume | for | source |\n"
        "|---|---|---|---|\n";
    const auto row = [&](const std::vector<std::string>& cells) {
        for (const std::string& content : cells) text.append("| ").append(cell(content)).append(" ");
        text.append("|\n");
    };
    for (const material::LawInfo& law : material::laws())
        row({std::string{law.name}, code(law.energy), std::string{law.validity}, std::string{law.source}});
    text +=
        "\n| law | parameter | unit | range | meaning |\n"
        "|---|---|---|---|---|\n";
    for (const material::LawInfo& law : material::laws())
        for (const material::Parameter& parameter : law.parameters)
            row({std::string{law.name}, code(parameter.name), unit_of(parameter.quantity), range_of(parameter),
                 std::string{parameter.meaning}});
    text +=
        "\n| law | change of volume | formulations |\n"
        "|---|---|---|\n";
    for (const material::LawInfo& law : material::laws()) row({std::string{law.name}, bulk_of(law), forms_of(law)});
    return text;
}

}  // namespace

std::string law_list(LawListStyle style) { return style == LawListStyle::plain ? plain() : markdown(); }

}  // namespace soft::design
