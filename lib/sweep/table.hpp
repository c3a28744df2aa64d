#pragma once
/// The parameters and outputs of all designs as columns, for results.csv, plots and the report. Tested by sweep/table_test.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace soft::sweep {

struct TableColumn {
    std::string name;                ///< in results.csv: "geometry_wall_mm", "pressure_kPa_at_end"
    std::string label;               ///< "geometry.wall", "pressure at end"
    std::string unit;                ///< empty for pure numbers and for words
    std::vector<std::string> cells;  ///< one per design; empty without a value

    /// The cells as numbers (nullopt without a value); empty if a cell is not a number.
    [[nodiscard]] std::vector<std::optional<double>> numbers() const;
};

/// One column per factor. If all its values have the same unit, the name ends with it and the cells are numbers; otherwise the cells are
/// the values as written.
[[nodiscard]] std::vector<TableColumn> factor_columns(const Sweep& sweep, const Plan& plan);

/// The outputs of all outcomes in order of first appearance; columns that only later designs have come last.
[[nodiscard]] std::vector<TableColumn> output_columns(std::span<const Outcome> outcomes);

/// A unit as part of a column name: "kg_per_m3" for "kg/m^3".
[[nodiscard]] std::string unit_name(const std::string& unit);

/// The column with this name or label; nullptr if there is none.
[[nodiscard]] const TableColumn* find_column(std::span<const TableColumn> columns, const std::string& name);

}  // namespace soft::sweep
