#pragma once
/// Cell quality: scaled Jacobian = minimum over maximum of det dX/dxi at the reference nodes of a cell (corners, mid nodes,
/// centres). 1 for a parallelepiped, 0 if a corner is flat, negative if the cell is inverted at a node.
/// Tested by mesh/quality_test.
#include "core/error.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"

namespace soft::mesh {

/// Shape functions at the reference nodes, one entry per node.
using NodeShapes = std::vector<std::vector<ShapeValue>>;
[[nodiscard]] NodeShapes node_shapes(CellType type);

struct ScaledJacobian {
    double value = -1;   ///< -1 for a cell that is inverted everywhere: its quotient would be positive and look valid
    Point position_m{};  ///< of the smallest determinant
};
/// `shapes` = node_shapes(type of the cell).
[[nodiscard]] ScaledJacobian scaled_jacobian(const Mesh& mesh, Index cell, const NodeShapes& shapes);

struct Quality {
    double min_scaled_jacobian = 1;
    double mean_scaled_jacobian = 1;
    Index worst_cell = 0;
    Point worst_position_m{};  ///< position of the smallest determinant in the worst cell
};

/// Throws Error(bad_input) with the number and position of the worst cell if any det dX/dxi is not positive.
[[nodiscard]] Quality quality(const Mesh& mesh);

}  // namespace soft::mesh
