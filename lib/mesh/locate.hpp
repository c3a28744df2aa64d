#pragma once
/// The cell that holds a point of the reference configuration, and what the nodes of that cell weigh there.
/// Tested by mesh/locate_test.
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// A point may lie this far outside its cell, in reference coordinates (a cell is 1 to 2 long): the sides of a mesh are within this of
/// the curved boundary that they follow.
inline constexpr double locate_tolerance = 0.02;

struct Location {
    Index cell;
    std::vector<double> weights;  ///< shape functions N_a at the point, one a node of the cell; their sum is 1
};

/// Solves sum N_a(xi) X_a = point for xi by Newton's method in each cell whose bounding box holds the point; the cell in which the point
/// lies deepest, the first of equals. nullopt where the point is outside the mesh.
[[nodiscard]] std::optional<Location> locate(const Mesh& mesh, const Point& point);

/// The node nearest to a point, the first of equals; the mesh has at least one.
[[nodiscard]] Index nearest_node(const Mesh& mesh, const Point& point);

}  // namespace soft::mesh
