#pragma once
/// Quadrature on the reference cells. Weights sum to the cell's reference volume.
/// Tested by mesh/shape_test (monomials up to the stated degree against their exact integrals).
#include <array>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::mesh {

struct QuadraturePoint {
    std::array<double, 3> xi;
    double weight;
};

/// Rule that is exact for polynomials of total degree `degree` (tensor cells: of that degree in each direction).
/// Simplices and wedges have rules up to degree 5, tensor cells up to 7. Throws std::logic_error for a higher degree.
/// Sources: Gauss-Legendre; triangles Radon (1948, degree 5, 7 points); tetrahedra Walkington (2000, degree 5, 14
/// points), both with positive weights.
[[nodiscard]] std::vector<QuadraturePoint> quadrature(Shape shape, int degree);

}  // namespace soft::mesh
