#pragma once
/// The outcome of one design of a sweep. Tested by sweep/outcome_test.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"
#include "post/curve.hpp"
#include "sweep/sweep.hpp"
#include "sweep/trace.hpp"

namespace soft::sweep {

/// The file `status` in the folder of a design: lines "key value". It is written after all other files of the folder.
struct Status {
    int exit_code = 0;       ///< of the first program that failed; 0 if none failed
    std::string error = {};  ///< last line of that program on stderr
};

/// Parses a status file; nullopt for a text without a line "exit_code N".
[[nodiscard]] std::optional<Status> read_status(std::string_view text);

/// Whether running the same programs again would give the same result. False after a kill, or after a file or disk error.
[[nodiscard]] bool is_final(int exit_code) noexcept;

struct Cell {
    std::string column;  ///< "pressure_kPa_at_elongation_5mm"
    std::optional<double> value;
    std::string label = {}, unit = {};  ///< "pressure at elongation=5mm", "kPa"
};

/// The name of the results column for a column of the curve at a point of the path. It consists of letters, digits and _, so that
/// scripts can use it without quoting. Examples: "elongation_mm_at_20kPa" for `at: pressure=20kPa` (the quantity is omitted if it is
/// the load of the curve), "pressure_kPa_at_elongation_2p5mm", "pressure_kPa_at_limit", "pressure_kPa_at_end". A decimal point
/// becomes p, a sign minus, % percent and / per.
[[nodiscard]] std::string column_at(const std::string& column, const std::string& point, const post::Curve& curve);

/// The requested columns of a curve at the requested points.
struct Outputs {
    std::vector<Cell> cells;
    std::vector<std::string> missing;  ///< a reason for each point that the path does not reach
};

struct Outcome {
    std::optional<int> exit_code = {};  ///< nullopt: not computed
    std::string stop_reason = {};       ///< stop reason of the path; otherwise `refused`, `failed` or `not_computed`
    std::string error = {};             ///< one line
    std::vector<std::string> columns = {};  ///< columns of its curve; empty without a curve
    std::vector<Cell> outputs = {};
    Trace trace = {};  ///< if requested
};

/// Evaluates the columns of the curve that the sweep requests (all except the step number if it names none) at each of its points.
/// If the path crosses a value several times, the first crossing is used. A point that the path does not reach has no value but a
/// reason. Errors (bad_input, with the location in the sweep file): a quantity or value that the curve cannot have.
[[nodiscard]] Outputs outputs_of(const Sweep& sweep, const post::Curve& curve,
                                 std::span<const model::LimitPoint> limit_points);

/// A curve for a case that is not solved yet: one row of zeros with all possible columns.
[[nodiscard]] post::Curve unsolved_curve(const model::Case& model);

/// Checks that a curve has each requested output; `known` are the columns of all curves. Error(bad_input), with the location in the sweep
/// file.
void check_outputs(const Sweep& sweep, std::span<const std::string> known);

/// Checks that curves with these columns have the requested points and outputs. Errors (bad_input, with the location in the sweep
/// file) as in outputs_of and results_csv.
void check_requests(const Sweep& sweep, const post::Curve& curve);

}  // namespace soft::sweep
