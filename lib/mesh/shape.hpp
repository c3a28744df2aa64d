#pragma once
/// Lagrange shape functions of every cell and facet type on its reference cell (mesh/cell_type.hpp has the coordinates):
/// N_a(node b) = delta_ab. Elements, mesh checks and surfaces all use these functions.
/// Tested by mesh/shape_test (nodal values, reproduction of polynomials, gradients).
#include <array>
#include <span>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::mesh {

struct ShapeValue {
    double value;
    std::array<double, 3> gradient;  ///< dN/dxi; unused directions are zero
};

/// One entry per node.
[[nodiscard]] std::vector<ShapeValue> shape_values(CellType type, const std::array<double, 3>& xi);

/// The same without allocation, for loops over many points; `out` has node_count(type) entries.
void shape_values(CellType type, const std::array<double, 3>& xi, std::span<ShapeValue> out);

/// The first-order shape functions of the cell's vertices (continuous pressure of Taylor-Hood elements), one entry per vertex.
[[nodiscard]] std::vector<double> vertex_values(CellType type, const std::array<double, 3>& xi);

}  // namespace soft::mesh
