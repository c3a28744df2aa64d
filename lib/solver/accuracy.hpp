#pragma once
/// A path with its discretisation error: the rows are solved again on meshes with every cell halved (refined_path.hpp) until
/// the error bars (error_bar.hpp) of the last mesh but one are within a tolerance.
///   level 0: the given mesh; level k + 1: the mesh of level k with every cell halved; new nodes of curved edges lie on the
///   circle through the old ones (mesh::Curve::circle).
/// The rows of level k are reported, with error bars from level k + 1 and, where they exist, k - 1 and k - 2. The refinement ends as
/// soon as the bars are within the tolerance. Two meshes can be enough: their bars are wide enough for that (error_bar.hpp).
/// The tolerance bounds the largest bar of the load relative to it (row_bars.hpp).
/// Tested by solver/accuracy_test, verification/coverage_test and the verification suite (group Error bars).
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "solver/path.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

struct AccuracyTarget {
    double tolerance = 1e-3;
    std::int64_t max_unknowns_2d = 1'500'000, max_unknowns_3d = 400'000;  ///< of the finest mesh
};

struct Accuracy {
    std::vector<RowState> rows;  ///< of the reported level, bars in their steps; fields [point of that level] on rank 0
    /// The same rows on the next finer level, where there are bars; on the last level their values alone (RefinedPath::Keep).
    std::vector<model::Step> finer;
    int level = 0;  ///< the reported level; the next finer one is solved too where there are bars
    bool has_bars = false;
    double reached = 0;      ///< the value that the tolerance bounds, where there are bars
    std::string end_reason;  ///< why there is no finer level, one clause; empty where the tolerance is met
    std::vector<std::string>
        doubts;  ///< why the bars are less reliable than those of meshes that converge at one order
    bool interrupted = false;
    std::int64_t unknowns = 0;                      ///< of the finest level that was solved
    int newton_iterations = 0, factorizations = 0;  ///< of all levels after the first
};

/// The mesh that is solved next.
struct NextMesh {
    int level;
    std::int64_t unknowns, unknowns_before;  ///< unknowns_before: of the mesh solved last
    std::size_t rows;                        ///< of the path; each is solved independently
    std::string reason;                      ///< one clause
};

/// Called by refine_path, on all ranks.
struct RefinementListeners {
    std::function<void(const NextMesh&)> next = {};
    /// The curve so far, with how its path ended: first the curve of the given mesh, which has no bars, then each curve with bars.
    std::function<void(const Accuracy&, const model::PathEnd&)> curve = {};
    /// Called before each row of a finer mesh, with its index; true ends the refinement. All ranks must return the same value.
    std::function<bool(std::size_t row)> is_interrupted = {};
};

/// `rows`: the whole path of `given` (Listeners::row); `end`: how it ended. Limit points and bifurcations of `end` are moved
/// to the reported level and stay at their rows. Where a row's slope of the load against the volume (else the first output) is not
/// exactly zero, a limit point gets the values at the vertex of the parabola through it and its neighbour.
/// Collective. Throws Error (bad_input) for first-order cells, whose straight edges do not approach a curved boundary, and for a
/// case without output or volume. A row that does not converge ends the refinement (end_reason).
[[nodiscard]] Accuracy refine_path(fem::System& given, std::vector<RowState> rows, model::PathEnd& end,
                                   const AccuracyTarget& target, const RefinementListeners& listeners = {});

}  // namespace soft::solver
