#pragma once
/// The tables of a sweep as comma-separated text (RFC 4180, lines ended by '\n'), one row a design. Held by
/// sweep/results_test.
///
/// Columns of a factor: its key path with _ for each dot, with the unit behind it (geometry_cap_mm) and numbers below where all its
/// values have the same; else the values as written. Columns of outputs: outcome.hpp, column_at.
#include <span>
#include <string>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"

namespace soft::sweep {

enum class State { waiting, done, refused };

/// The addresses of the designs that wait, each once, in the order of the plan.
[[nodiscard]] std::vector<std::string> waiting_ids(const Plan& plan, std::span<const State> states);

/// id, state, the factors, settings (arguments of mesh-gen), refusal. `states`: one a design.
[[nodiscard]] std::string plan_csv(const Sweep& sweep, const Plan& plan, std::span<const State> states);

/// id, the factors, the outputs (empty where a design has none), stop_reason, exit_code, error. `outcomes`: one a design.
/// Error(bad_input), with the place in the sweep's file: an output that no curve has, though there are curves.
[[nodiscard]] std::string results_csv(const Sweep& sweep, const Plan& plan, std::span<const Outcome> outcomes);

}  // namespace soft::sweep
