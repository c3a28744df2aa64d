#pragma once
/// The equilibrium path as a table: one row a converged step, columns with the unit in their name.
/// Columns: step, pressure_kPa, <output>_mm ..., volume_mL, stretch_p99, max_stretch, min_J, stable. What a case does
/// not have (an output, a cavity volume) is left out, never filled with zeros. Held by post/curve_test.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "solution/path.hpp"

namespace soft::post {

/// How a column is carried between two rows of the path.
enum class Role {
    counter,     ///< number of the row; between rows the fraction of the way
    coordinate,  ///< measured state that spans the path (pressure, outputs, volume); has slopes from the solver
    follower,    ///< other values of the state, known at the rows only
    flag,        ///< 0 or 1; between rows 1 only where both rows have 1
};

struct Column {
    std::string name;      ///< "pressure_kPa"
    std::string quantity;  ///< "pressure": how --at calls it
    std::string unit;      ///< "kPa"; empty for pure numbers
    core::Dimension dimension = core::Dimension::ratio;
    double SI_per_unit = 1;  ///< SI value = value in this column x SI_per_unit
    Role role = Role::follower;
    std::vector<double> values;  ///< one a row
    std::vector<double> slopes;  ///< coordinates: derivative along the path, any positive scale a row; 0 in all
                                 ///< coordinates of a row: not known there
};

/// An SI value as it stands in the column. Round values stay round (30000 Pa is 30 kPa, 0.13 m is 130 mm).
[[nodiscard]] double in_column_unit(const Column& column, double value_SI) noexcept;

struct Curve {
    std::vector<Column> columns;

    [[nodiscard]] std::size_t row_count() const noexcept { return columns.empty() ? 0 : columns.front().values.size(); }
    /// nullptr where there is no such column.
    [[nodiscard]] const Column* find(std::string_view quantity) const noexcept;
    /// "pressure, elongation, volume": what --at takes.
    [[nodiscard]] std::string coordinate_names() const;
};

/// `output_names` in the order of Step::outputs_m. Throws Error(bad_input) where a step has another number of outputs
/// or a volume is recorded at some of the steps only.
/// `load` names what the path's load column holds: "pressure", or "traction" of a case without a pressure.
[[nodiscard]] Curve make_curve(std::span<const std::string> output_names, std::span<const solution::Step> steps,
                               std::string_view load = "pressure");

}  // namespace soft::post
