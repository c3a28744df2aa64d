#pragma once
/// The equilibrium path as a table: one row a converged step, columns with the unit in their name.
/// Columns: step, time_s (of a dynamic case), stage (1, 2 ..., of a case with several), pressure_kPa (traction_kPa, load_N, load_factor: what leads the case,
/// model::leading_load), <output>_mm (by its measure _deg, _per_m, _N, _Nmm) ..., volume_mL, then of a case with several loads or
/// cavities pressure_<load>_kPa ... and volume_<cavity>_mL ..., after `solve --tolerance` the half widths of the errors
/// pressure_error_kPa (traction_, load_factor_) and <output>_error_mm or _deg ..., of a dynamic case kinetic_energy_mJ,
/// stored_energy_mJ, load_work_mJ and damping_work_mJ, then stretch_p99, max_stretch, min_J, stable, of a static path stable_under_control. On demand: of a static case
/// stored_energy_mJ and load_work_mJ, and max_stretch_x_mm ... (the undeformed place of max_stretch), max_energy_density_kJ_m3.
/// What a case does not have (an output, a cavity volume) is left out, never filled with zeros. Tested by post/curve_test.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::post {

/// Whether a column stands in the table without being asked for.
enum class Shown { always, on_demand };

/// How a column is carried between two rows of the path.
enum class Role {
    counter,     ///< number of the row; between rows the fraction of the way
    coordinate,  ///< measured state that spans the path (pressure, outputs, volume); has slopes from the solver
    follower,    ///< other values of the state; of few the solver gives slopes
    flag,        ///< 0 or 1; between rows 1 only where both rows have 1
    stage,       ///< number of the stage; what lies between two rows belongs to that of the second
};

/// Which number of a step, limit point or bifurcation a column shows.
enum class Source { time, load, output, volume, other };

struct Column {
    std::string name;          ///< "pressure_kPa"
    std::string quantity;      ///< "pressure": how --at calls it
    std::string unit;          ///< "kPa"; empty for pure numbers
    std::string meaning = {};  ///< one clause, no full stop
    Shown shown = Shown::always;
    core::Dimension dimension = core::Dimension::ratio;
    double SI_per_unit = 1;  ///< SI value = value in this column x SI_per_unit
    Role role = Role::follower;
    Source source = Source::other;
    std::size_t index = 0;       ///< of the output, where the source is one
    std::vector<double> values;  ///< one a row
    std::vector<double> slopes;  ///< derivative along the path, any positive scale a row, the same in all columns;
                                 ///< 0 in all coordinates of a row: not known there. Of followers one a row, or none
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

/// `model` is the case as it was solved. Throws Error(bad_input) where a step does not have one value for each output (and
/// for each load and cavity where there are several) or a volume or a time is recorded at some of the steps only.
[[nodiscard]] Curve make_curve(const model::Case& model, std::span<const solution::Step> steps);

/// Every column there can be, each once, with its name, unit and meaning but no rows; what a design names stands in angle
/// brackets, and of outputs the measure: <displacement>_mm.
[[nodiscard]] std::vector<Column> all_columns();

/// A line a column: name, unit, meaning, and how to ask for those on demand.
[[nodiscard]] std::string column_text(std::span<const Column> columns);

/// Those of the table.
[[nodiscard]] std::vector<const Column*> shown_columns(const Curve& curve);

/// Shows these columns too ("stored_energy", or "all"). Error(usage, place --also): no such column.
void show_also(Curve& curve, std::span<const std::string> quantities);

/// What a limit point or bifurcation has to say in this column, in its unit; nullopt where it says nothing.
[[nodiscard]] std::optional<double> value_at(const Column& column, const solution::LimitPoint& point);

}  // namespace soft::post
