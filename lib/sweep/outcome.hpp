#pragma once
/// What became of a design of a sweep. Held by sweep/outcome_test.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
    std::string column;  ///< "pressure_kPa@elongation=5mm"
    std::optional<double> value;
};

struct Outcome {
    std::optional<int> exit_code = {};      ///< empty: not computed
    std::string stop_reason = {};           ///< that of the path; else `refused`, `failed` or `not_computed`
    std::string error = {};                 ///< one line
    std::vector<std::string> columns = {};  ///< of its curve; empty where it has none
    std::vector<Cell> outputs = {};
};

/// The columns of the curve that the sweep asks for (all but the number of the step where it names none) at each of its
/// places: at a value that the path crosses several times the first crossing; no value where the path does not come there.
/// Errors (bad_input, with the place in the sweep's file): a quantity or value that the curve cannot have.
[[nodiscard]] std::vector<Cell> outputs_of(const Sweep& sweep, const post::Curve& curve,
                                           std::span<const solution::LimitPoint> limit_points);

}  // namespace soft::sweep
