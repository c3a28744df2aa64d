#pragma once
/// The map from the reference cell to the mesh, X(xi) = sum N_a(xi) X_a, with the Lagrange shape functions of the cell's
/// own nodes. For mesh checks and geometry; the element kernels tabulate the same functions.
/// Tested by mesh/quality_test.
#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace soft::mesh {

struct CellMap {
    Point position;                ///< X [m]
    std::array<double, 9> dX_dxi;  ///< row by row; the unused rows and columns are zero
    double determinant;            ///< of the leading dimension x dimension part; for a line its length per d xi
};

/// `shapes` = shape_values(type of the cell, xi).
[[nodiscard]] CellMap map_cell(const Mesh& mesh, Index cell, const std::vector<ShapeValue>& shapes);

/// Vector area element of a facet per reference area, outward from its cell: t1 x t2 of a solid's facet, the tangent
/// turned clockwise of a section's edge. `shapes` = shape_values(facet_type, xi).
[[nodiscard]] std::array<double, 3> facet_normal(const Mesh& mesh, const Facet& facet,
                                                 const std::vector<ShapeValue>& shapes);

/// Exact for the volume of every second-order cell, and for 2 pi r times the area of second-order section cells.
[[nodiscard]] std::vector<QuadraturePoint> volume_rule(CellType type);

enum class Measure {
    plain,     ///< area of a section, volume of a solid
    revolved,  ///< volume of the section turned about x once: integral of 2 pi r
};

/// [m^2] or [m^3], sums in cell order.
[[nodiscard]] double measure(const Mesh& mesh, Measure kind);
/// The same of each region, in the order of region_names.
[[nodiscard]] std::vector<double> region_measures(const Mesh& mesh, Measure kind);

}  // namespace soft::mesh
