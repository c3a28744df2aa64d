#include "optimize_report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft {
namespace {

using optimize::Condition;

std::string value_text(const Condition& condition, double value_SI) {
    std::string text = core::rounded_text(value_SI / condition.SI_per_unit, 5);
    if (!condition.unit.empty()) text.append(" ").append(condition.unit);
    return text;
}

std::string relation_text(const Condition& condition) {
    switch (condition.relation) {
        case Condition::Relation::equal: return "wanted " + condition.value_text;
        case Condition::Relation::below: return "below " + condition.value_text;
        case Condition::Relation::above: break;
    }
    return "above " + condition.value_text;
}

std::string condition_text(const Condition& condition, double value_SI) {
    std::string text =
        condition.measure.text + ": " + value_text(condition, value_SI) + ", " + relation_text(condition);
    if (optimize::violation_of(condition, value_SI) > 0) return text + ": not met";
    if (optimize::is_active(condition, value_SI)) text += ": active";
    return text;
}

/// The differences from one quantity of a measured curve.
struct CurveErrors {
    const Condition* row;  ///< the first one
    std::size_t rows = 0;
    double rms_SI = 0, largest_SI = 0;  ///< the largest with its sign
    std::size_t line = 0;               ///< of the largest
};

std::vector<CurveErrors> curve_errors(const optimize::Goal& goal, const optimize::Trial& trial) {
    std::vector<CurveErrors> all;
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        const Condition& condition = goal.conditions[i];
        if (!condition.curve) continue;
        if (all.empty() || all.back().row->curve != condition.curve ||
            all.back().row->measure.quantity != condition.measure.quantity)
            all.push_back({&condition});
        CurveErrors& errors = all.back();
        const double off = trial.conditions[i].value_SI - condition.value_SI;
        errors.rms_SI += off * off;
        if (errors.rows++ == 0 || std::abs(off) > std::abs(errors.largest_SI))
            errors.largest_SI = off, errors.line = condition.line;
    }
    for (CurveErrors& errors : all) errors.rms_SI = std::sqrt(errors.rms_SI / static_cast<double>(errors.rows));
    return all;
}

std::string curve_text(const optimize::Goal& goal, const CurveErrors& errors) {
    const Condition& row = *errors.row;
    const optimize::MeasuredCurve& curve = goal.curves[*row.curve];
    return curve.file + ", " + row.measure.quantity + " at equal " + row.measure.at +
           ": root mean square of the differences " + value_text(row, errors.rms_SI) + " (" +
           core::rounded_text(100 * errors.rms_SI / row.scale_SI, 3) + " % of the largest value), largest " +
           value_text(row, errors.largest_SI) + " in line " + std::to_string(errors.line) + "; " +
           core::counted(errors.rows, "row") +
           (curve.left_out > 0 ? ", " + std::to_string(curve.left_out) + " left out" : "");
}

/// "material.mu +1 % with geometry.wall -0.62 %"
std::string combination_text(const optimize::Goal& goal, const optimize::Statistics& statistics) {
    constexpr double least = 0.05;
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < statistics.weakest.size(); ++k) {
        const double change = statistics.weakest[k];
        if (std::abs(change) >= least)
            parts.push_back(goal.variables[statistics.variables[k]].key + (change > 0 ? " +" : " ") +
                            core::rounded_text(change, 2) + " %");
    }
    return core::join(parts, " with ");
}

void add_statistics(const optimize::Goal& goal, const optimize::Statistics& statistics,
                    std::vector<std::string>& lines) {
    if (statistics.condition > optimize::Statistics::max_condition)
        lines.push_back("the data hardly tell apart: " + combination_text(goal, statistics) +
                        "; the amount of this combination is known to +- " +
                        core::rounded_text(100 * statistics.weakest_error, 2) + " %");
    for (const std::size_t i : statistics.undetermined)
        lines.push_back("the data do not determine " + goal.variables[i].key + ": it does not change them");
    for (std::size_t k = 0; k < statistics.variables.size(); ++k) {
        const optimize::Variable& variable = goal.variables[statistics.variables[k]];
        if (statistics.standard_errors[k] > 0.5 * variable.range())
            lines.push_back("the data do not determine " + variable.key +
                            ": its standard error exceeds half its range");
    }
}

}  // namespace

std::string progress_text(const optimize::Goal& goal, const optimize::Found& found) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < goal.conditions.size(); ++i)
        if (!goal.conditions[i].is_data)
            parts.push_back(condition_text(goal.conditions[i], found.trial.conditions[i].value_SI));
    for (const CurveErrors& errors : curve_errors(goal, found.trial))
        parts.push_back(goal.curves[*errors.row->curve].file + ": " + errors.row->measure.quantity + " +- " +
                        value_text(*errors.row, errors.rms_SI));
    return core::join(parts, "; ");
}

std::vector<std::string> report_lines(const optimize::Goal& goal, const optimize::Found& found) {
    const auto statistics = optimize::statistics_of(goal, found);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < goal.variables.size(); ++i) {
        const optimize::Variable& variable = goal.variables[i];
        std::string line = variable.key + ": " + variable.text_of(found.values[i]);
        if (optimize::is_at_end(variable, found.values[i])) line += ", at the end of its range";
        if (statistics)
            for (std::size_t k = 0; k < statistics->variables.size(); ++k)
                if (statistics->variables[k] == i)
                    line += " +- " + core::rounded_text(statistics->standard_errors[k] / variable.SI_per_unit, 2);
        lines.push_back(std::move(line));
    }
    for (std::size_t i = 0; i < goal.conditions.size(); ++i)
        if (!goal.conditions[i].curve)
            lines.push_back(condition_text(goal.conditions[i], found.trial.conditions[i].value_SI));
    for (const CurveErrors& errors : curve_errors(goal, found.trial)) lines.push_back(curve_text(goal, errors));
    if (statistics)
        add_statistics(goal, *statistics, lines);
    else if (goal.has_data())
        lines.emplace_back("no standard errors: a bound is active, or there are not more data than numbers");
    if (goal.stable) lines.emplace_back(found.trial.is_stable ? "stable" : "stable: not met");
    if (goal.minimize) lines.push_back(goal.minimize->text + ": " + found.trial.objective_text + ", minimized");
    return lines;
}

nlohmann::ordered_json report_json(const optimize::Goal& goal, const optimize::Found& found) {
    nlohmann::ordered_json json = cli::summary_head("optimize");
    json["met"] = found.violation <= 0;
    json["violation"] = found.violation;
    json["trials"] = found.trials;
    const auto gradient_json = [&](const std::vector<double>& gradient) {
        nlohmann::ordered_json by_variable;
        for (std::size_t k = 0; k < gradient.size(); ++k)
            if (!goal.variables[k].is_whole) by_variable[goal.variables[k].key] = gradient[k];
        return by_variable;
    };
    for (std::size_t i = 0; i < goal.variables.size(); ++i)
        json["values"][goal.variables[i].key] = goal.variables[i].text_of(found.values[i]);
    for (const CurveErrors& errors : curve_errors(goal, found.trial))
        json["curves"].push_back({{"file", goal.curves[*errors.row->curve].file},
                                  {"quantity", errors.row->measure.quantity},
                                  {"at", errors.row->measure.at},
                                  {"rows", errors.rows},
                                  {"rows_left_out", goal.curves[*errors.row->curve].left_out},
                                  {"rms_SI", errors.rms_SI},
                                  {"largest_SI", errors.largest_SI},
                                  {"line_of_largest", errors.line}});
    if (const auto statistics = optimize::statistics_of(goal, found)) {
        const std::size_t count = statistics->variables.size();
        for (std::size_t k = 0; k < count; ++k) {
            const std::string& key = goal.variables[statistics->variables[k]].key;
            json["standard_errors_SI"][key] = statistics->standard_errors[k];
            json["weakest_combination"][key] = statistics->weakest[k];
            for (std::size_t j = 0; j < count; ++j)
                json["correlations"][key][goal.variables[statistics->variables[j]].key] =
                    statistics->correlations[k * count + j];
        }
        json["weakest_combination_error"] = statistics->weakest_error;
        json["condition"] = statistics->condition;
        json["scatter"] = statistics->scatter;
        json["degrees_of_freedom"] = statistics->degrees_of_freedom;
    }
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        const auto& value = found.trial.conditions[i];
        json["conditions"].push_back({{"text", condition_text(goal.conditions[i], value.value_SI)},
                                      {"value_SI", value.value_SI},
                                      {"violation", optimize::violation_of(goal.conditions[i], value.value_SI)},
                                      {"derivatives_SI", gradient_json(value.gradient)}});
    }
    if (goal.minimize)
        json["objective"] = {{"text", goal.minimize->text},
                             {"value_SI", found.trial.objective.value_SI},
                             {"derivatives_SI", gradient_json(found.trial.objective.gradient)}};
    return json;
}

}  // namespace soft
