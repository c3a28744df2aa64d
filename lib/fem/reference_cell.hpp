#pragma once
/// A cell type with its quadrature tables and its pressure space: all element data that do not depend on the mesh.
///   displacement  every cell, first and second order
///   mixed         second order only, in stable pairs (inf-sup): Q2/P-1 on quadrilaterals and hexahedra, P2/P1
///                 (Taylor-Hood) on triangles and tetrahedra, and its product with a line, 18/6 nodes, on wedges
///   f_bar         first-order quadrilaterals and hexahedra, see fem/f_bar.hpp
///
/// Quadrature points: quad4 2x2, hex8 2x2x2, triangle3 3 (the integrands of bodies of revolution vary over the cell),
/// tet4 1, wedge6 3 x 2; quad9 3x3, hex27 3x3x3, wedge18 7 x 3; triangle6 3 and tet10 4 in displacement form, 7 and
/// 14 in mixed form, where the product of strain and pressure and curved sides require a higher degree. Each rule integrates the
/// stiffness of the undistorted cell exactly (degree 2 (k - 1)) in sections of unit depth and solids; with the factor
/// 2 pi R of bodies of revolution this degree preserves the order of convergence (Ciarlet, The Finite Element Method for
/// Elliptic Problems (1978), 4.1). No rule has zero-energy modes other than the rigid motions: fem/rank_test.
/// Sources: Boffi, Brezzi, Fortin, Mixed Finite Element Methods (2013) 8.6-8.8. Tested by fem/reference_cell_test,
/// fem/solid_kernel_test; orders by fem/manufactured_test, stability by fem/inf_sup_test.
#include <vector>

#include "material/catalogue.hpp"
#include "mesh/cell_type.hpp"

namespace soft::fem {

using material::Form;

/// none: displacements are the only unknowns. discontinuous_linear: {1, X - Xc, ...} of each cell in the coordinates of the undeformed
/// body (not mapped, which preserves the order on distorted cells). continuous_vertex: linear functions of the vertices, shared by cells.
enum class PressureSpace { none, discontinuous_linear, continuous_vertex };

struct ReferenceCell {
    mesh::CellType type;
    Form form = Form::displacement;
    int dimension = 0;
    int nodes = 0;
    int points = 0;  ///< quadrature points
    PressureSpace pressure = PressureSpace::none;
    int pressure_dofs = 0;
    std::vector<double> weight;    ///< [point]
    std::vector<double> N;         ///< [point][node]
    std::vector<double> dN_dxi;    ///< [point][direction][node]
    std::vector<double> vertex_N;  ///< [point][vertex], continuous_vertex only
    std::vector<double>
        by_node;  ///< [node][direction, then N][padded(points)]: dN_dxi and N, padded by repeating the last point

    [[nodiscard]] int displacement_dofs() const noexcept { return dimension * nodes; }
    [[nodiscard]] int dofs() const noexcept { return displacement_dofs() + pressure_dofs; }
};

/// Throws Error(bad_input, location "mesh") for a cell type that the form does not support (model/formulation.hpp).
[[nodiscard]] ReferenceCell make_reference_cell(mesh::CellType type, Form form);

}  // namespace soft::fem
