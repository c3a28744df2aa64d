#pragma once
/// Lagrange shape functions of every cell and facet type on its reference cell (mesh/cell_type.hpp has the coordinates).
/// N_a(node b) = delta_ab. Held by element/shape_test (partition of unity, nodal values, reproduction of polynomials).
#include <array>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::element {

using ReferencePoint = std::array<double, 3>;

/// Values and reference gradients of all functions at one point.
struct ShapeValues {
    std::vector<double> N;                       ///< [node]
    std::vector<std::array<double, 3>> dN_dxi;   ///< [node][direction]; unused directions are zero
};

[[nodiscard]] ShapeValues shape_functions(mesh::CellType type, const ReferencePoint& xi);

/// The linear functions of the cell's vertices (continuous pressure of Taylor-Hood pairs), [vertex].
[[nodiscard]] std::vector<double> vertex_functions(mesh::CellType type, const ReferencePoint& xi);

}  // namespace soft::element
