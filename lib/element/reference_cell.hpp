#pragma once
/// A cell type with its quadrature tables and its pressure space: everything about an element that does not depend on
/// the mesh. Stable pairs (inf-sup): Q2/P-1 on quadrilaterals and hexahedra, P2/P1 (Taylor-Hood) on triangles and
/// tetrahedra, and its product with a line, 18/6 nodes, on wedges.
/// Sources: Boffi, Brezzi, Fortin, Mixed Finite Element Methods (2013) 8.6-8.8. Held by element/solid_kernel_test.
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::element {

/// none: displacement formulation. discontinuous_linear: {1, X - Xc, ...} of each cell in reference coordinates
/// (not mapped, so the order survives on distorted cells). continuous_vertex: linear in the vertices, shared by cells.
enum class PressureSpace { none, discontinuous_linear, continuous_vertex };

struct ReferenceCell {
    mesh::CellType type;
    int dimension = 0;
    int nodes = 0;
    int points = 0;                     ///< quadrature points
    PressureSpace pressure = PressureSpace::none;
    int pressure_dofs = 0;
    std::vector<double> weight;         ///< [point]
    std::vector<double> N;              ///< [point][node]
    std::vector<double> dN_dxi;         ///< [point][direction][node]
    std::vector<double> vertex_N;       ///< [point][vertex], continuous_vertex only

    [[nodiscard]] int displacement_dofs() const noexcept { return dimension * nodes; }
    [[nodiscard]] int dofs() const noexcept { return displacement_dofs() + pressure_dofs; }
};

enum class PressureChoice { displacement_only, mixed };

/// Throws Error (bad_input) for a pair that is not inf-sup stable or a type that is no solid cell.
[[nodiscard]] ReferenceCell make_reference_cell(mesh::CellType type, PressureChoice choice);

}  // namespace soft::element
