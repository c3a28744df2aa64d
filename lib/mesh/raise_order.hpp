#pragma once
/// Conversion between first and second order on the same cells: line2/line3, triangle3/6, quad4/9, tet4/10, hex8/27, wedge6/18.
/// Cells and facets keep their numbers; regions, facet sets and point sets are kept. Points keep their numbers when the order is
/// raised. Tested by mesh/raise_order_test.
#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Adds mid nodes at the mean of the corners of their edge, face or cell (straight edges). Neighbouring cells share them. Their
/// numbers follow those of the first-order points. Cells that already are of second order do not change and share their
/// mid nodes with raised neighbours.
[[nodiscard]] Mesh raise_order(const Mesh& mesh);

/// Removes the mid nodes, and with them curved edges. The remaining points keep their order. Point sets lose all points that are
/// not a corner of a cell.
[[nodiscard]] Mesh lower_order(const Mesh& mesh);

}  // namespace soft::mesh
