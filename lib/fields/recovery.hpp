#pragma once
/// Within one cell: from integration points to nodes, and from nodal pressures to the cell's own pressure unknowns.
/// For fields/step_fields.hpp, which says what is done; its tests hold it.
#include <span>
#include <vector>

#include "element/reference_cell.hpp"

namespace soft::fields {

/// The matrix [node][point] that takes values at the points of a cell to its nodes: the function linear in the
/// reference position X that is nearest at the points, weighted as in the reference cell; the constant where the rule
/// has one point. `X` [dimension x node], component-major [m].
[[nodiscard]] std::vector<double> extrapolation(const element::ReferenceCell& cell, std::span<const double> X);

/// What the cell's pressure is fitted to.
struct NodalPressures {
    std::span<const double> X;            ///< [dimension x node], component-major [m]
    std::span<const double> pressure_Pa;  ///< [node]
    std::span<const bool> shared;         ///< [node] with cells of another region: its mean says little of this cell
};

/// Unknowns (scale 1 Pa) of the cell's pressure space. continuous_vertex: the vertices' own values.
/// discontinuous_linear: exact at the centre node, which no other cell has; least squares at the nodes that are not
/// shared. Directions that these do not determine stay constant.
[[nodiscard]] std::vector<double> cell_pressure(const element::ReferenceCell& cell, const NodalPressures& nodal);

}  // namespace soft::fields
