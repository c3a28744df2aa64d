#pragma once
/// A path with its discretisation error: the rows are solved again on meshes with every cell halved (refined_path.hpp) until
/// the bars (error_bar.hpp) of the last but one are within a tolerance.
///   level 0: the mesh that was given; level k + 1: that of level k with every cell halved, new nodes of bent edges on the
///   circle through the old ones (mesh::Curve::circle).
/// The rows of level k are reported, with bars by level k + 1 and, where there are, k - 1 and k - 2. Level 0 is reported only
/// where the bound on the unknowns leaves no third mesh: two meshes may hide what is not in its rate yet. Where the differences of
/// three meshes are at no rate yet (ErrorBar::settled), only bars within half of the tolerance end the refinement; else a fourth
/// mesh is solved, if it fits; not of solids, where it has 512 times the unknowns. The bar of the load is that at equal value of
/// the first output, of the volume where the case has no output. What is held to the
/// tolerance is the largest of  bar of the load / max(|load|, a tenth of the path's largest |load|).
/// Held by solver/accuracy_test and the verification suite (group Error bars).
#include <cstdint>
#include <string>
#include <vector>

#include "solver/path.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

struct AccuracyTarget {
    double tolerance = 1e-3;
    std::int64_t largest_unknowns_2d = 1'500'000, largest_unknowns_3d = 400'000;  ///< of the finest mesh
};

struct Accuracy {
    std::vector<RowState> rows;  ///< of the reported level, bars in their steps; fields [point of that level] on rank 0
    int level = 0;               ///< that is reported; the one behind it has been solved too where there are bars
    bool has_bars = false;
    double reached = 0;         ///< what is held to the tolerance, where there are bars
    std::string obstacle;       ///< why there is no finer level, one clause; empty where the tolerance is met
    std::int64_t unknowns = 0;  ///< of the finest level that was solved
    int newton_iterations = 0, factorizations = 0;  ///< of all levels after the first
};

/// `rows`: the whole path of `given` (Listeners::row); `end`: how it ended. Limit points and bifurcations of `end` are moved
/// to the reported level: they stay at their rows, and where a row's slope of the load against volume (else first output)
/// is not quite zero a limit point gets what the parabola through it and its neighbour has at its top.
/// Collective. Throws Error (bad_input) for cells of first order, whose straight edges never meet a bent body, and for a
/// case without output or volume. A row that does not converge ends the refinement (obstacle).
[[nodiscard]] Accuracy refine_path(assembly::System& given, std::vector<RowState> rows, solution::PathEnd& end,
                                   const AccuracyTarget& target, const Log& log);

}  // namespace soft::solver
