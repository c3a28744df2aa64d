#pragma once
/// Isoparametric map from the reference cell to the mesh, X(xi) = sum N_a(xi) X_a, where N_a are the cell's Lagrange shape
/// functions. For mesh checks and geometry; the element kernels tabulate the same functions.
/// Tested by mesh/quality_test.
#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace soft::mesh {

struct CellMap {
    Point position;                ///< X [m]
    std::array<double, 9> dX_dxi;  ///< row-major; unused rows and columns are zero
    double determinant;            ///< of the leading dimension x dimension block; for a line |dX/dxi|
};

/// `shapes` = shape_values(type of the cell, xi).
[[nodiscard]] CellMap map_cell(const Mesh& mesh, Index cell, const std::vector<ShapeValue>& shapes);

/// Vector area element of a facet per reference area, pointing out of its cell: t1 x t2 for a facet of a solid, the tangent
/// rotated clockwise for an edge of a section. `shapes` = shape_values(facet_type, xi).
[[nodiscard]] std::array<double, 3> facet_normal(const Mesh& mesh, const Facet& facet,
                                                 const std::vector<ShapeValue>& shapes);

/// Quadrature rule that is exact for the volume of second-order cells and for the integral of 2 pi r over second-order cells of
/// a section.
[[nodiscard]] std::vector<QuadraturePoint> volume_rule(CellType type);

enum class Measure {
    plain,     ///< area of a section, volume of a solid
    revolved,  ///< volume of the section revolved about x: integral of 2 pi r
};

/// Area [m^2] or volume [m^3] of the mesh, summed in cell order.
[[nodiscard]] double measure(const Mesh& mesh, Measure kind);
/// The same for each region, in the order of region_names.
[[nodiscard]] std::vector<double> region_measures(const Mesh& mesh, Measure kind);

}  // namespace soft::mesh
