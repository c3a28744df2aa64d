#include "sweep/results.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::sweep {
namespace {

std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
    return quoted + "\"";
}

bool is_number(const std::string& text) {
    return std::holds_alternative<double>(core::parse_quantity(text, core::Dimension::ratio));
}

/// The common unit of all values of a factor; empty if there is none.
std::string common_unit(const Plan& plan, std::size_t factor) {
    std::string unit;
    for (const PlannedDesign& design : plan.designs) {
        const core::QuantityParts quantity = core::quantity_parts(design.values[factor]);
        if (!is_number(quantity.number) || quantity.unit.empty() || (!unit.empty() && quantity.unit != unit)) return "";
        unit = quantity.unit;
    }
    return unit;
}

/// A unit as part of a column name: "kg_per_m3" for "kg/m^3".
std::string unit_name(const std::string& unit) {
    std::string name;
    for (const char c : unit) {
        if (c == '/') name += "_per_";
        if (c == '%') name += "percent";
        if (std::string_view{"/%^. *"}.find(c) == std::string_view::npos) name += c;
    }
    return name;
}

/// Header and cells of the factor columns.
class FactorColumns {
public:
    FactorColumns(const Sweep& sweep, const Plan& plan) {
        for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
            units_.push_back(common_unit(plan, f));
            std::string name = sweep.factors[f].path;
            std::ranges::replace(name, '.', '_');
            if (!units_[f].empty()) name.append("_").append(unit_name(units_[f]));
            header_.append(",").append(cell(name));
        }
    }
    [[nodiscard]] const std::string& header() const noexcept { return header_; }
    [[nodiscard]] std::string of(const PlannedDesign& design) const {
        std::string text;
        for (std::size_t f = 0; f < units_.size(); ++f)
            text.append(",").append(
                cell(units_[f].empty() ? design.values[f] : core::quantity_parts(design.values[f]).number));
        return text;
    }

private:
    std::vector<std::string> units_;
    std::string header_;
};

std::string_view word(State state) {
    switch (state) {
        case State::waiting: return "waiting";
        case State::done: return "done";
        case State::refused: return "refused";
    }
    return "waiting";
}

/// Adds words that are not in the list yet.
void add_new(std::vector<std::string>& list, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}

/// Column names of all outcomes in order of first appearance; columns that only later designs have come last.
std::vector<std::string> output_columns(std::span<const Outcome> outcomes) {
    std::vector<std::string> columns;
    for (const Outcome& outcome : outcomes)
        for (const Cell& output : outcome.outputs) add_new(columns, {output.column});
    return columns;
}

}  // namespace

std::vector<std::string> waiting_ids(const Plan& plan, std::span<const State> states) {
    std::vector<std::string> ids;
    std::set<std::string_view> seen;
    for (std::size_t d = 0; d < plan.designs.size(); ++d)
        if (states[d] == State::waiting && seen.insert(plan.designs[d].id).second) ids.push_back(plan.designs[d].id);
    return ids;
}

std::string plan_csv(const Sweep& sweep, const Plan& plan, std::span<const State> states) {
    const FactorColumns factors{sweep, plan};
    std::string text = "id,state" + factors.header() + ",settings,refusal\n";
    for (std::size_t d = 0; d < plan.designs.size(); ++d) {
        const PlannedDesign& design = plan.designs[d];
        text.append(design.id).append(",").append(word(states[d])).append(factors.of(design)).append(",");
        text.append(cell(settings_text(sweep, design))).append(",").append(cell(design.refusal)).append("\n");
    }
    return text;
}

std::string results_csv(const Sweep& sweep, const Plan& plan, std::span<const Outcome> outcomes) {
    std::vector<std::string> known;
    for (const Outcome& outcome : outcomes) add_new(known, outcome.columns);
    if (!known.empty()) check_outputs(sweep, known);
    const FactorColumns factors{sweep, plan};
    const std::vector<std::string> columns = output_columns(outcomes);
    std::string text = "id" + factors.header();
    for (const std::string& column : columns) text.append(",").append(cell(column));
    text += ",stop_reason,exit_code,error\n";
    for (std::size_t d = 0; d < plan.designs.size(); ++d) {
        const Outcome& outcome = outcomes[d];
        std::map<std::string, std::string> outputs;
        for (const Cell& output : outcome.outputs)
            outputs[output.column] = output.value ? core::number_text(*output.value) : "";
        text.append(plan.designs[d].id).append(factors.of(plan.designs[d]));
        for (const std::string& column : columns) text.append(",").append(outputs[column]);
        text.append(",").append(cell(outcome.stop_reason)).append(",");
        text.append(outcome.exit_code ? std::to_string(*outcome.exit_code) : "")
            .append(",")
            .append(cell(outcome.error))
            .append("\n");
    }
    return text;
}

}  // namespace soft::sweep
