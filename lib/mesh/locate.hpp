#pragma once
/// Finds the cell that contains a point of the reference configuration, and the shape function values at that point.
/// Tested by mesh/locate_test.
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// A point may lie this far outside its cell, in reference coordinates (a reference cell has length 1 or 2). The tolerance covers
/// the distance between the mesh boundary and the curved boundary that it approximates.
inline constexpr double locate_tolerance = 0.02;

struct Location {
    Index cell;
    std::vector<double> weights;  ///< shape functions N_a at the point, one per node of the cell; their sum is 1
};

/// Solves sum N_a(xi) X_a = point for xi by Newton's method in each cell whose bounding box contains the point. Returns the cell in
/// which the point is farthest inside, the first one of several. nullopt if the point is outside the mesh.
[[nodiscard]] std::optional<Location> locate(const Mesh& mesh, const Point& point);

/// The node nearest to a point, the first one of several. The mesh must have at least one node.
[[nodiscard]] Index nearest_node(const Mesh& mesh, const Point& point);

}  // namespace soft::mesh
