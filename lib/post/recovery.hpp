#pragma once
/// Recovery within one cell: values at quadrature points to values at nodes, and nodal pressures to the pressure unknowns of the cell.
/// The method is described in post/step_fields.hpp. Tested by post/recovery_test and post/step_fields_test.
#include <span>
#include <vector>

#include "fem/reference_cell.hpp"

namespace soft::post {

/// Matrix [node][point] that maps values at the quadrature points of a cell to its nodes: least-squares fit of a linear function of the
/// reference position X, with the weights of the reference cell; a constant if the rule has one point. `X` [dimension x node],
/// component-major [m].
[[nodiscard]] std::vector<double> extrapolation(const fem::ReferenceCell& cell, std::span<const double> X);

/// Data to which the pressure of a cell is fitted.
struct NodalPressures {
    std::span<const double> X;            ///< [dimension x node], component-major [m]
    std::span<const double> pressure_Pa;  ///< [node]
    std::span<const bool> shared;  ///< [node] shared with another region: its mean value does not represent this cell
};

/// Unknowns (scale 1 Pa) of the cell's pressure space. continuous_vertex: the values at the vertices; at a shared one,
/// extrapolated along the edges to others, exactly, or, where there is none, the mean of the nodes between the vertices that are not.
/// discontinuous_linear: exact at the centre node, which belongs to this cell only; least squares at the nodes that are not
/// shared. The pressure is constant along directions that these nodes do not determine.
[[nodiscard]] std::vector<double> cell_pressure(const fem::ReferenceCell& cell, const NodalPressures& nodal);

}  // namespace soft::post
