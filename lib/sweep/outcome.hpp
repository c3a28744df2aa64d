#pragma once
/// What became of a design of a sweep. Tested by sweep/outcome_test.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.hpp"
#include "post/curve.hpp"
#include "solution/path.hpp"
#include "sweep/sweep.hpp"

namespace soft::sweep {

/// The file `status` in the folder of a design, written when all else in it is: lines "key value".
struct Status {
    int exit_code = 0;       ///< of the first program that did not end with 0
    std::string error = {};  ///< its last line on stderr
};

/// nullopt for a text without a line "exit_code N".
[[nodiscard]] std::optional<Status> read_status(std::string_view text);

/// Whether the same programs would say the same again. Not so where they were killed, or files or the disk failed them.
[[nodiscard]] bool is_final(int exit_code) noexcept;

struct Cell {
    std::string column;  ///< "pressure_kPa_at_elongation_5mm"
    std::optional<double> value;
};

/// The column of the results for a column of the curve at a place: letters, digits and _ alone, so that scripts can use the name
/// as it is. "elongation_mm_at_20kPa" for `at: pressure=20kPa`, where the pressure is the load of the curve (its quantity is not
/// repeated), "pressure_kPa_at_elongation_2p5mm", "pressure_kPa_at_limit", "pressure_kPa_at_end"; p stands for a decimal point,
/// minus for the sign, percent for %, per for /.
[[nodiscard]] std::string column_at(const std::string& column, const std::string& place, const post::Curve& curve);

/// What a curve has of the columns that are asked for.
struct Outputs {
    std::vector<Cell> cells;
    std::vector<std::string> missing;  ///< a reason for each place that the path does not reach
};

struct Outcome {
    std::optional<int> exit_code = {};      ///< empty: not computed
    std::string stop_reason = {};           ///< that of the path; else `refused`, `failed` or `not_computed`
    std::string error = {};                 ///< one line
    std::vector<std::string> columns = {};  ///< of its curve; empty where it has none
    std::vector<Cell> outputs = {};
};

/// The columns of the curve that the sweep asks for (all but the number of the step where it names none) at each of its
/// places: at a value that the path crosses several times the first crossing; no value, but a reason, where the path does not reach it.
/// Errors (bad_input, with the place in the sweep's file): a quantity or value that the curve cannot have.
[[nodiscard]] Outputs outputs_of(const Sweep& sweep, const post::Curve& curve,
                                 std::span<const solution::LimitPoint> limit_points);

/// The curve of a case before it is solved: one row of zeros, with all the columns that there can be.
[[nodiscard]] post::Curve unsolved_curve(const model::Case& model);

/// Whether curves with these columns have what the sweep asks for; Errors (bad_input, with the place in the sweep's file)
/// as outputs_of and results_csv.
void check_requests(const Sweep& sweep, const post::Curve& curve);

}  // namespace soft::sweep
