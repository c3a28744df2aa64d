#pragma once
/// Cell and facet types: node order, facets, reference coordinates. The node order is that of VTK (meshes are stored as VTKHDF).
/// Reference cells: lines, quadrilaterals and hexahedra [-1, 1]^d; triangles and tetrahedra the unit simplex;
/// wedges unit triangle x [-1, 1], all with positive orientation (det dX/dxi > 0 in a valid mesh).
/// Source of the order: VTK 9 cell headers (vtkBiQuadraticQuad, vtkTriQuadraticHexahedron, vtkBiQuadraticQuadraticWedge).
/// Tested by mesh/cell_type_test.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace soft::mesh {

enum class CellType : std::uint8_t {  // values are VTK's
    line2 = 3,
    line3 = 21,
    triangle3 = 5,
    triangle6 = 22,
    quad4 = 9,
    quad9 = 28,
    tet4 = 10,
    tet10 = 24,
    hex8 = 12,
    hex27 = 29,
    wedge6 = 13,
    wedge18 = 32,
};

enum class Shape : std::uint8_t { line, triangle, quadrilateral, tetrahedron, hexahedron, wedge };

/// One facet of a cell: its type and the cell's local node numbers in the node order of that type. They are oriented so that
/// the facet's normal (t1 x t2 in 3D; the tangent rotated clockwise, (t_y, -t_x), in 2D) points OUT of the cell.
struct FacetTopology {
    CellType type;
    std::array<int, 9> nodes;  ///< first node_count(type) entries are used
};

struct CellTopology {
    CellType type;
    Shape shape;
    std::string_view name;
    int dimension;
    int order;  ///< 1 or 2
    int node_count;
    int vertex_count;                              ///< the first vertex_count nodes are the corners
    std::span<const std::array<double, 3>> nodes;  ///< reference coordinates
    std::span<const FacetTopology> facets;         ///< empty for lines
};

/// Table lookup; the reference has static lifetime.
[[nodiscard]] const CellTopology& topology(CellType type) noexcept;

/// nullopt for a number that is not a supported VTK cell type.
[[nodiscard]] std::optional<CellType> cell_type_from_vtk(int vtk) noexcept;

/// The type of the same shape with the given order (1 or 2).
[[nodiscard]] CellType with_order(CellType type, int order) noexcept;

/// Mean of the corners of the reference cell.
[[nodiscard]] std::array<double, 3> reference_centre(CellType type) noexcept;

[[nodiscard]] inline int node_count(CellType type) noexcept { return topology(type).node_count; }
[[nodiscard]] inline int dimension(CellType type) noexcept { return topology(type).dimension; }

}  // namespace soft::mesh
