#pragma once
/// Rows of a drawn outline, and curves that are drawn as many short straight edges. Tested by geometry/profile_test.
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
    bool may_curve = false;    ///< a straight edge only because the table states no curve
    bool begins_edge = false;  ///< not joined with the row before, even of the same tag and curve
};

/// Straight edges that were recognised as points of curves.
struct FoundCurves {
    std::size_t edges = 0, curves = 0;
    std::size_t first_line = 0;
    std::size_t coarse_edges = 0, coarse_line = 0;  ///< those that may be one, and are left straight
    double deviation_m = 0;                         ///< largest distance of a curve from its edges
};

/// A curve drawn as many short straight edges would require cells as short. Six or more edges of one tag that follow each other, that
/// state no curve, turn by at most 15 degrees at each point and are at most four times as long as their neighbours become one
/// spline through the same points, if it differs from the edges by at most 1/100 of its length. `rows` is one closed loop, which may
/// then start at another row.
void recognise_curves(std::vector<ProfileRow>& rows, FoundCurves& found);

/// For the user: how many edges, the largest deviation, and how to keep them straight; what else may be a curve.
[[nodiscard]] std::vector<std::string> notes_of(const FoundCurves& found, std::string_view source);

}  // namespace soft::geometry
