#pragma once
/// A section of any shape: closed loops of lines, arcs and splines. Plain data, its geometry and what makes it unsound; no
/// mesher in it (outline_mesher.hpp). Coordinates [m] as in section.hpp. Tested by meshing/outline_test.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "meshing/section.hpp"

namespace soft::meshing {

/// A line through its two ends; the circular arc through three points (start, one on the way, end); or a uniform
/// Catmull-Rom spline through all its points, whose tangent at a point is half the chord between its neighbours (at a free
/// end the missing neighbour is the mirrored one; a spline that ends where it starts is smooth there too).
struct OutlineEdge {
    enum class Shape { line, arc, spline };
    Shape shape = Shape::line;
    std::vector<PlanePoint> points;
    std::vector<std::string> faces;  ///< facet sets its cells belong to
    std::size_t row = 0;             ///< where it is written, for messages
};

/// Closed: an edge starts where the one before ends.
using Loop = std::vector<OutlineEdge>;

/// The solid lies to the left of every loop: one runs round it counter-clockwise, the others round its holes, clockwise.
struct Outline {
    std::vector<Loop> loops;
    std::function<double(PlanePoint)> size_m = {};  ///< wished length of a cell there
    std::vector<std::string> notes = {};            ///< what was recognised in the drawing, for the user
};

struct OutlineArc {
    PlanePoint centre;
    double radius_m, start_rad, turn_rad;  ///< turn > 0: counter-clockwise
    [[nodiscard]] PlanePoint at(double share) const;
};
[[nodiscard]] OutlineArc arc_of(const OutlineEdge& edge);  ///< of an arc whose three points are not in line

/// `span` counts from 0 along the points: 1.5 lies between the second and the third.
[[nodiscard]] PlanePoint spline_at(const std::vector<PlanePoint>& points, double span);

/// `share` runs from 0 at the start to 1 at the end, of a line by its length, of an arc by its angle, of a spline evenly over its
/// spans. Tested by meshing/outline_mesher_test.
[[nodiscard]] PlanePoint point_at(const OutlineEdge& edge, double share);

/// Points along an edge, both ends included, a few degrees apart where it bends.
[[nodiscard]] std::vector<PlanePoint> polyline(const OutlineEdge& edge);

/// Straight pieces of all loops, in order.
struct OutlinePiece {
    PlanePoint start, end;
    std::size_t loop, edge;  ///< numbers
    bool first_of_loop, last_of_loop;
};
[[nodiscard]] std::vector<OutlinePiece> pieces_of(const Outline& outline);

/// Enclosed by the loop, positive if it runs counter-clockwise [m^2].
[[nodiscard]] double area_m2(const Loop& loop);

[[nodiscard]] bool is_inside(const std::vector<OutlinePiece>& pieces, PlanePoint point);

[[nodiscard]] double extent_m(const Outline& outline);

/// Lengths below this part of the extent are none: points coincide, edges touch.
inline constexpr double outline_tolerance = 1e-7;

/// Why the outline is no section, and in which row; nullopt for a sound one.
struct OutlineFault {
    std::size_t row;
    std::string problem, remedy;
};
[[nodiscard]] std::optional<OutlineFault> fault_of(const Outline& outline);

}  // namespace soft::meshing
