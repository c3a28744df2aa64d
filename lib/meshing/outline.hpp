#pragma once
/// A section of any shape: closed loops of lines, arcs and splines. Plain data, geometric queries and validity checks;
/// outline_mesher.hpp meshes it. Coordinates [m] as in section.hpp. Tested by meshing/outline_test.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "meshing/section.hpp"

namespace soft::meshing {

/// A line between two points; the circular arc through three points (start, intermediate point, end); or a uniform Catmull-Rom
/// spline through all its points. The tangent of the spline at a point is half the chord between its neighbours; at a free end the
/// missing neighbour is the mirrored one; a closed spline is also smooth at its start.
struct OutlineEdge {
    enum class Shape { line, arc, spline };
    Shape shape = Shape::line;
    std::vector<PlanePoint> points;
    std::vector<std::string> faces;  ///< facet sets of its cells
    std::size_t row = 0;             ///< row of the table, for messages
};

/// Closed: each edge starts at the end of the previous one.
using Loop = std::vector<OutlineEdge>;

/// The solid lies to the left of every loop: the outer loop is counter-clockwise, the loops around holes are clockwise.
struct Outline {
    std::vector<Loop> loops;
    std::function<double(PlanePoint)> size_m = {};  ///< requested cell length at a point
    std::vector<std::string> notes = {};            ///< for the user: curves recognised in the outline
};

struct OutlineArc {
    PlanePoint centre;
    double radius_m, start_rad, turn_rad;  ///< turn > 0: counter-clockwise
    [[nodiscard]] PlanePoint at(double share) const;
};
[[nodiscard]] OutlineArc arc_of(const OutlineEdge& edge);  ///< its three points must not be collinear

/// `span` counts from 0 along the points: 1.5 lies between the second and the third.
[[nodiscard]] PlanePoint spline_at(const std::vector<PlanePoint>& points, double span);

/// `share` runs from 0 at the start to 1 at the end: proportional to the length of a line, the angle of an arc, the span parameter of
/// a spline. Tested by meshing/outline_mesher_test.
[[nodiscard]] PlanePoint point_at(const OutlineEdge& edge, double share);

/// Points along an edge including both ends, at most a few degrees apart on curves.
[[nodiscard]] std::vector<PlanePoint> polyline(const OutlineEdge& edge);

/// Straight pieces of all loops, in order.
struct OutlinePiece {
    PlanePoint start, end;
    std::size_t loop, edge;  ///< indices
    bool first_of_loop, last_of_loop;
};
[[nodiscard]] std::vector<OutlinePiece> pieces_of(const Outline& outline);

/// Area enclosed by the loop, positive if it is counter-clockwise [m^2].
[[nodiscard]] double area_m2(const Loop& loop);

[[nodiscard]] bool is_inside(const std::vector<OutlinePiece>& pieces, PlanePoint point);

/// Sides of the bounding box of its points, and the longer one.
[[nodiscard]] PlanePoint extents_m(const Outline& outline);
[[nodiscard]] double extent_m(const Outline& outline);

/// Lengths below this share of the extent count as zero: points coincide, edges touch.
inline constexpr double outline_tolerance = 1e-7;

/// The first reason why the outline is invalid, with its row; nullopt for a valid outline.
struct OutlineFault {
    std::size_t row;
    std::string problem, remedy;
};
[[nodiscard]] std::optional<OutlineFault> fault_of(const Outline& outline);

}  // namespace soft::meshing
