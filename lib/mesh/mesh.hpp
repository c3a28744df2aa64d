#pragma once
/// An unstructured mesh in the reference configuration with named regions, facets and points. Plain data.
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::mesh {

using Index = std::int64_t;
using Point = std::array<double, 3>;  ///< reference position [m]: (x, y, z); (x, r, 0) in a section

/// A facet of a cell: cell number and the cell's local facet number (topology(type).facets).
struct Facet {
    Index cell;
    int local;
    friend auto operator<=>(const Facet&, const Facet&) = default;
};

struct Mesh {
    int dimension = 3;  ///< of the cells: 2 (section) or 3 (solid)
    std::vector<Point> points;
    std::vector<CellType> cell_types;  ///< one per cell
    std::vector<Index> offsets{0};     ///< cell c has nodes connectivity[offsets[c] .. offsets[c+1])
    std::vector<Index> connectivity;
    std::vector<std::int32_t> cell_regions;  ///< index into region_names, one per cell
    std::vector<std::string> region_names;
    std::map<std::string, std::vector<Facet>> facet_sets;  ///< named faces; sets may overlap
    std::map<std::string, std::vector<Index>> point_sets;

    [[nodiscard]] Index cell_count() const noexcept { return static_cast<Index>(cell_types.size()); }
    [[nodiscard]] std::span<const Index> cell_nodes(Index cell) const {
        const auto c = static_cast<std::size_t>(cell);
        return {connectivity.data() + offsets[c], static_cast<std::size_t>(offsets[c + 1] - offsets[c])};
    }
    [[nodiscard]] CellType cell_type(Index cell) const { return cell_types[static_cast<std::size_t>(cell)]; }
    [[nodiscard]] const Point& point(Index node) const { return points[static_cast<std::size_t>(node)]; }
};

/// Node numbers of a facet in the node order of its type (outward orientation, see FacetTopology).
[[nodiscard]] std::vector<Index> facet_nodes(const Mesh& mesh, const Facet& facet);
[[nodiscard]] CellType facet_type(const Mesh& mesh, const Facet& facet);

/// Index of the region of this name in region_names, which gets the name if it lacks it.
[[nodiscard]] std::int32_t region_number(Mesh& mesh, const std::string& name);
[[nodiscard]] const std::string& region_name(const Mesh& mesh, Index cell);

/// Removes the points without a cell, also from the point sets; the others keep their order. Returns the new number of each point, or -1.
std::vector<Index> drop_unused_points(Mesh& mesh);

/// Corner nodes of a facet, in its orientation.
[[nodiscard]] std::vector<Index> facet_corners(const Mesh& mesh, const Facet& facet);

/// All facets that belong to exactly one cell, in cell order.
[[nodiscard]] std::vector<Facet> boundary_facets(const Mesh& mesh);

/// Longest side of the bounding box of all points.
[[nodiscard]] double extent_m(const Mesh& mesh);

/// Nodes within this distance of a symmetry plane or the axis lie on it. The value is a fraction of the mesh's extent: far above
/// rounding errors and far below any cell size.
inline constexpr double plane_tolerance = 1e-9;

/// Positions of some nodes, component by component ([component][node], `dimension` components): the order of the element kernels.
[[nodiscard]] std::vector<double> by_component(std::span<const Point> points, std::span<const Index> nodes,
                                               int dimension);

/// Appends a cell; nodes in VTK order.
void add_cell(Mesh& mesh, CellType type, std::span<const Index> nodes, std::int32_t region);

}  // namespace soft::mesh
