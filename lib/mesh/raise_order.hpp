#pragma once
/// First order <-> second order on the same cells: line2/line3, triangle3/6, quad4/9, tet4/10, hex8/27, wedge6/18.
/// Regions, facet sets (a cell keeps its number and its sides theirs) and point sets are carried over; points keep their
/// numbers when the order is raised. Tested by mesh/raise_order_test.
#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Mid nodes at the means of the corners of their edge, side or cell (straight edges); neighbours share them. Their
/// numbers follow those of the first-order points. Cells that are of second order already stay as they are, with their
/// mid nodes shared with raised neighbours.
[[nodiscard]] Mesh raise_order(const Mesh& mesh);

/// Drops the mid nodes, and with them curved edges; the points that remain keep their order. A point set loses the
/// points that are no corner of a cell.
[[nodiscard]] Mesh lower_order(const Mesh& mesh);

}  // namespace soft::mesh
