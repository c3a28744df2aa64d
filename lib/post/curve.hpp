#pragma once
/// The equilibrium path as a table: one row per converged step, columns with the unit in their name. The columns are:
///   step; time_s (dynamic cases); stage (1, 2 ..., cases with several stages);
///   pressure_kPa (or traction_kPa, load_N, load_factor: the leading load, model::leading_load);
///   <output>_mm (_deg, _per_m, _N, _Nmm by its measure) ...; volume_mL;
///   pressure_<load>_kPa ... and volume_<cavity>_mL ... (cases with several loads or cavities);
///   pressure_error_kPa (traction_, load_factor_) and <output>_error_mm or _deg ...: half widths of the errors after `solve --tolerance`;
///   frequency_1_Hz ... (model::PathSettings::frequencies);
///   kinetic_energy_mJ, stored_energy_mJ, load_work_mJ, damping_work_mJ (dynamic cases);
///   stretch_p99, max_stretch, min_J, stable; stable_under_control (static paths).
/// On demand: stored_energy_mJ and load_work_mJ (static cases), dissipated_energy_mJ (in contact), friction_work_mJ (with friction), max_stretch_x_mm ... (undeformed position of max_stretch),
/// max_energy_density_kJ_m3, stiffness_kPa_per_mm and pressure_by_<number of the design> (sensitivity.hpp). Quantities that a case does not have (an output, a cavity volume) are omitted, never filled with zeros.
/// Tested by post/curve_test.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::post {

/// Whether a column is always part of the table, or only on request (--also).
enum class Shown { always, on_demand };

/// How a column is interpolated between two rows of the path.
enum class Role {
    counter,     ///< number of the row; linear between rows
    coordinate,  ///< quantity that parametrises the path (pressure, outputs, volume); the solver provides slopes
    dependent,   ///< other quantity of the state; the solver provides slopes of some
    flag,        ///< 0 or 1; between rows 1 only if both rows have 1
    stage,       ///< number of the stage; points between two rows belong to the stage of the second row
};

/// The member of a step, limit point or bifurcation that a column shows.
enum class Source { time, load, output, volume, other };

struct Column {
    std::string name;          ///< "pressure_kPa"
    std::string quantity;      ///< "pressure": the name used by --at
    std::string unit;          ///< "kPa"; empty for pure numbers
    std::string meaning = {};  ///< one clause, no full stop
    Shown shown = Shown::always;
    core::Dimension dimension = core::Dimension::ratio;
    double SI_per_unit = 1;  ///< SI value = value in this column x SI_per_unit
    Role role = Role::dependent;
    Source source = Source::other;
    std::size_t index = 0;       ///< index of the output, if the source is an output
    std::vector<double> values;  ///< one per row
    bool bends = true;           ///< at Curve::kinks; false: its slope is continuous there
    /// Where a stage begins, whose row has the value before, and at kinks, whose rows have the values after.
    bool jumps = false;
    /// Derivative along the path, with an arbitrary positive scale per row that all columns share; 0 in all coordinates of a row: unknown.
    /// Dependent columns: one per row, or empty.
    std::vector<double> slopes;
};

/// Converts an SI value to the unit of the column. Round values stay round (30000 Pa is 30 kPa, 0.13 m is 130 mm).
[[nodiscard]] double in_column_unit(const Column& column, double value_SI) noexcept;

/// "3.2 kPa": a value in the unit of the column, for messages.
[[nodiscard]] std::string value_text(const Column& column, double value, int digits = 4);

struct Curve {
    std::vector<Column> columns;
    std::vector<std::size_t>
        kinks;  ///< rows at which the direction changes, ascending; their slopes are those after it

    [[nodiscard]] std::size_t row_count() const noexcept { return columns.empty() ? 0 : columns.front().values.size(); }
    /// The first such column; nullptr if there is none.
    [[nodiscard]] const Column* find(std::string_view quantity) const noexcept;
    [[nodiscard]] const Column* find(Source source) const noexcept;
    [[nodiscard]] std::size_t index_of(const Column& column) const noexcept {
        return static_cast<std::size_t>(&column - columns.data());
    }
    /// "pressure, elongation, volume": the quantities that --at accepts.
    [[nodiscard]] std::string coordinate_names() const;
};

/// `model` is the case as it was solved. Static paths have kinks at the first contacts of `end`, motions where the rate of a load jumps. Throws Error(bad_input) if a step does not have one value for each output (and for each load
/// and cavity, if there are several), or if a volume or a time is recorded at some steps only.
[[nodiscard]] Curve make_curve(const model::Case& model, std::span<const model::Step> steps,
                               const model::PathEnd& end = {});

/// All possible columns, each once, with name, unit and meaning but no rows. Names chosen in a design appear in angle brackets; outputs
/// appear by their measure: <displacement>_mm.
[[nodiscard]] std::vector<Column> all_columns();

/// One line per column: name, unit, meaning, and the option that enables columns on demand.
[[nodiscard]] std::string column_text(std::span<const Column> columns);

/// The columns that are part of the table.
[[nodiscard]] std::vector<const Column*> shown_columns(const Curve& curve);

/// Enables these columns ("stored_energy", or "all"). Throws Error(usage, "--also") for an unknown column.
void show_also(Curve& curve, std::span<const std::string> quantities);

/// Value of this column at a limit point or bifurcation, in its unit; nullopt if it is not recorded.
[[nodiscard]] std::optional<double> value_at(const Column& column, const model::LimitPoint& point);

}  // namespace soft::post
