#pragma once
/// Rows of a tabulated outline, and detection of curves that are given as many short straight edges. Tested by geometry/profile_test.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/outline.hpp"

namespace soft::geometry {

/// A row of the table.
struct ProfileRow {
    std::size_t line;
    meshing::PlanePoint point;
    std::string tag, loop;
    meshing::OutlineEdge::Shape shape;
    std::optional<meshing::PlanePoint> via;
    bool may_curve = false;    ///< the table states no curve, so the edge may be part of a detected one
    bool begins_edge = false;  ///< not joined with the previous row, even if tag and curve are the same
};

/// Straight edges that were recognised as polylines of smooth curves.
struct FoundCurves {
    std::size_t edges = 0, curves = 0;
    std::size_t first_line = 0;
    std::size_t coarse_edges = 0, coarse_line = 0;  ///< edges that may belong to a curve but stay straight
    double deviation_m = 0;                         ///< largest distance between a curve and its edges
};

/// A curve given as many short straight edges would require equally short cells. Six or more consecutive edges of one tag become one
/// spline through the same points if they state no curve, turn by at most 15 degrees at each point, are at most four times as long
/// as their neighbours, and if the spline deviates from them by at most 1/100 of its length. `rows` is one closed loop; it may start
/// at another row afterwards.
void recognise_curves(std::vector<ProfileRow>& rows, FoundCurves& found);

/// Notes for the user: number of edges, largest deviation, how to keep them straight, and other edges that may be a curve.
[[nodiscard]] std::vector<std::string> notes_of(const FoundCurves& found, std::string_view source);

}  // namespace soft::geometry
