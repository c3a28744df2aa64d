#include "sweep/table.hpp"

#include <algorithm>
#include <map>

#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::sweep {
namespace {

std::optional<double> number_of(const std::string& text) {
    const auto parsed = core::parse_quantity(text, core::Dimension::ratio);
    const auto* number = std::get_if<double>(&parsed);
    return number == nullptr || text.ends_with('%') ? std::nullopt : std::optional{*number};
}

/// The common unit of all values of a factor; empty if there is none.
std::string common_unit(const Plan& plan, std::size_t factor) {
    std::string unit;
    for (const PlannedDesign& design : plan.designs) {
        const core::QuantityParts quantity = core::quantity_parts(design.values[factor]);
        if (!number_of(quantity.number) || quantity.unit.empty() || (!unit.empty() && quantity.unit != unit)) return "";
        unit = quantity.unit;
    }
    return unit;
}

}  // namespace

std::string unit_name(const std::string& unit) {
    std::string name;
    for (const char c : unit) {
        if (c == '/') name += "_per_";
        if (c == '%') name += "percent";
        if (std::string_view{"/%^. *()"}.find(c) == std::string_view::npos) name += c;
    }
    return name;
}

std::vector<std::optional<double>> TableColumn::numbers() const {
    std::vector<std::optional<double>> values;
    for (const std::string& cell : cells) {
        values.push_back(number_of(cell));
        if (!cell.empty() && !values.back()) return {};
    }
    return values;
}

std::vector<TableColumn> factor_columns(const Sweep& sweep, const Plan& plan) {
    std::vector<TableColumn> columns;
    for (std::size_t f = 0; f < sweep.factors.size(); ++f) {
        const std::string& path = sweep.factors[f].path;
        TableColumn& column = columns.emplace_back(TableColumn{path, path, common_unit(plan, f), {}});
        std::ranges::replace(column.name, '.', '_');
        if (!column.unit.empty()) column.name.append("_").append(unit_name(column.unit));
        for (const PlannedDesign& design : plan.designs)
            column.cells.push_back(column.unit.empty() ? design.values[f]
                                                       : core::quantity_parts(design.values[f]).number);
    }
    return columns;
}

std::vector<TableColumn> output_columns(std::span<const Outcome> outcomes) {
    std::vector<TableColumn> columns;
    std::map<std::string, std::size_t> indices;
    for (std::size_t d = 0; d < outcomes.size(); ++d)
        for (const Cell& output : outcomes[d].outputs) {
            const auto [found, is_new] = indices.try_emplace(output.column, columns.size());
            if (is_new)
                columns.push_back(
                    {output.column, output.label, output.unit, std::vector<std::string>(outcomes.size())});
            columns[found->second].cells[d] = output.value ? core::number_text(*output.value) : "";
        }
    return columns;
}

const TableColumn* find_column(std::span<const TableColumn> columns, const std::string& name) {
    const auto found = std::ranges::find_if(
        columns, [&](const TableColumn& column) { return column.name == name || column.label == name; });
    return found == columns.end() ? nullptr : &*found;
}

}  // namespace soft::sweep
