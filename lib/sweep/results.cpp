#include "sweep/results.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "sweep/table.hpp"

namespace soft::sweep {
namespace {

std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
    return quoted + "\"";
}

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

/// A line for the header (no design) or for a design, with a comma before each cell.
void append_cells(std::string& text, std::span<const TableColumn> columns, std::optional<std::size_t> design) {
    for (const TableColumn& column : columns)
        text.append(",").append(cell(design ? column.cells[*design] : column.name));
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
    const std::vector<TableColumn> factors = factor_columns(sweep, plan);
    std::string text = "id,state";
    append_cells(text, factors, std::nullopt);
    text += ",settings,refusal\n";
    for (std::size_t d = 0; d < plan.designs.size(); ++d) {
        const PlannedDesign& design = plan.designs[d];
        text.append(design.id).append(",").append(word(states[d]));
        append_cells(text, factors, d);
        text.append(",")
            .append(cell(settings_text(sweep, design)))
            .append(",")
            .append(cell(design.refusal))
            .append("\n");
    }
    return text;
}

std::string results_csv(const Sweep& sweep, const Plan& plan, std::span<const Outcome> outcomes) {
    std::vector<std::string> known;
    for (const Outcome& outcome : outcomes) add_new(known, outcome.columns);
    if (!known.empty()) check_outputs(sweep, known);
    std::vector<TableColumn> columns = factor_columns(sweep, plan);
    std::ranges::move(output_columns(outcomes), std::back_inserter(columns));
    std::string text = "id";
    append_cells(text, columns, std::nullopt);
    text += ",stop_reason,exit_code,error\n";
    for (std::size_t d = 0; d < plan.designs.size(); ++d) {
        const Outcome& outcome = outcomes[d];
        text.append(plan.designs[d].id);
        append_cells(text, columns, d);
        text.append(",").append(cell(outcome.stop_reason)).append(",");
        text.append(outcome.exit_code ? std::to_string(*outcome.exit_code) : "")
            .append(",")
            .append(cell(outcome.error))
            .append("\n");
    }
    return text;
}

}  // namespace soft::sweep
