#pragma once
/// Cycles of a repeated programme (model::PathSettings::cycles). Tested by post/cycles_test.
#include <optional>
#include <span>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::post {

/// Rows first ... last of a cycle; the first one is the end of the cycle before, where the cycle starts. Throws Error (usage, "--cycle") if
/// the path has no such cycle.
struct CycleRows {
    std::size_t first = 0, last = 0;
};
[[nodiscard]] CycleRows rows_of_cycle(const model::Case& model, std::span<const model::Step> steps, int cycle);

/// What the loads do in a cycle, and what it dissipates: in a cycle that ends as it has begun the area of its loop.
struct CycleEnergy {
    int cycle = 1;
    double load_work_J = 0, dissipated_J = 0;  ///< dissipated by inelastic rubber and snaps
    std::optional<double> friction_J = {};     ///< by friction, where there is any
};
/// Of the complete cycles; empty for a path without repetition or energies.
[[nodiscard]] std::vector<CycleEnergy> cycle_energies(const model::Case& model, std::span<const model::Step> steps);

/// Restricts steps and events to the rows of a cycle.
void keep_cycle(const model::Case& model, int cycle, std::vector<model::Step>& steps, model::PathEnd& end);

}  // namespace soft::post
