#pragma once
/// How well the cells are shaped: scaled Jacobian = least over largest det dX/dxi of a cell, over its reference nodes
/// (corners, mid nodes, centres). 1 for a parallelepiped, 0 when a corner is flat, below 0 when the cell is turned
/// inside out somewhere. Tested by mesh/quality_test.
#include "core/error.hpp"
#include "mesh/mesh.hpp"

namespace soft::mesh {

struct Quality {
    double min_scaled_jacobian = 1;
    double mean_scaled_jacobian = 1;
    Index worst_cell = 0;
    Point worst_place_m{};  ///< where in the worst cell the least value stands
};

/// Throws Error(bad_input) that names the worst cell and its place if any det dX/dxi is not positive.
[[nodiscard]] Quality quality(const Mesh& mesh);

}  // namespace soft::mesh
