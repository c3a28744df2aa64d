#pragma once
/// Triangles and quadrilaterals of a section with a curved outline, and their conversion to second-order cells.
/// Tested by meshing/outline_mesher_test.
#include <array>
#include <map>
#include <vector>

#include "mesh/mesh.hpp"
#include "meshing/outline.hpp"

namespace soft::meshing {

struct Polygons {
    /// A piece of an edge of the outline, between two of its shares (point_at).
    struct Side {
        const OutlineEdge* edge;
        double from, to;
    };
    std::vector<PlanePoint> points;
    std::vector<std::vector<int>> cells;          ///< corners, counter-clockwise
    std::map<std::array<int, 2>, Side> boundary;  ///< from corner to corner, the solid on the left
};

/// If a smooth outline passes through a corner that belongs to one cell only, two sides of that cell are collinear there and its
/// Jacobian is zero, whatever its size. Divides such a cell, or its neighbour, so that two or more cells meet in the corner.
/// Quadrilaterals may become triangles, triangles stay triangles.
void divide_flat_corners(Polygons& mesh);

/// Each triangle becomes three quadrilaterals, each quadrilateral four; new boundary points lie on the outline.
[[nodiscard]] Polygons into_quadrilaterals(const Polygons& mesh);

/// Moves inner points around cells whose Jacobian varies more than about threefold, so that the worst cell around each point improves.
/// Good meshes do not change; boundary points do not move.
void smooth(Polygons& mesh);

/// The point of a boundary side at equal distances from its ends, and its share of the edge.
struct BoundaryMiddle {
    double share;
    PlanePoint position;
};
[[nodiscard]] BoundaryMiddle boundary_middle(const Polygons& mesh, const std::array<int, 2>& ends);

/// Cells of one kind, quad9 or triangle6, points (x, r, 0). Mid nodes of boundary sides lie on the outline at equal distances from
/// both ends, inner sides are straight. One region, "rubber"; facet sets are the faces of the edges.
[[nodiscard]] mesh::Mesh second_order(const Polygons& mesh);

}  // namespace soft::meshing
