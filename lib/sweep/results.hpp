#pragma once
/// The tables of a sweep as comma-separated text (RFC 4180, lines end with '\n'), one row per design. Tested by
/// sweep/results_test.
///
/// Column of a factor: its key path with _ for each dot, and the unit (geometry_cap_mm; factor_columns in table.hpp). Columns of
/// outputs: column_at in outcome.hpp.
#include <span>
#include <string>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace soft::sweep {

enum class State { waiting, done, refused };

/// The identifiers of the waiting designs, without duplicates, in the order of the plan.
[[nodiscard]] std::vector<std::string> waiting_ids(const Plan& plan, std::span<const State> states);

/// Columns: id, state, the factors, settings (arguments of mesh-gen), refusal. `states` has one entry per design.
[[nodiscard]] std::string plan_csv(const Sweep& sweep, const Plan& plan, std::span<const State> states);

/// Columns: id, the factors, the outputs (empty for a design without them), stop_reason, exit_code, error. `outcomes` has one entry
/// per design. Error(bad_input), with the location in the sweep file: there are curves, but none has a requested output.
[[nodiscard]] std::string results_csv(const Sweep& sweep, const Plan& plan, std::span<const Outcome> outcomes);

}  // namespace soft::sweep
