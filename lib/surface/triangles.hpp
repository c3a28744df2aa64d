#pragma once
/// Triangulated surfaces for the geometric checks (CGAL). Second-order facets are divided at their own nodes, so the triangulation is
/// conforming without new points. Tested by surface/triangles_test.
#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct Triangles {
    std::vector<mesh::Point> points;  ///< [m], (x, y, z)
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> facets;                ///< of each triangle: index of the facet it was made from; -1 none
    std::vector<mesh::Point> model_points;  ///< points in model coordinates: (x, r, 0) in a section
    /// For a revolved section: the edges in the plane z = 0 (both half-planes), each with one of its triangles. The surface intersects
    /// itself exactly where these edges do, because all planes through the axis are equivalent. Empty for other surfaces.
    struct Edge {
        std::array<int, 2> points;
        int triangle;
    };
    std::vector<Edge> outline;
};

/// Local node indices of the triangles into which a facet of a solid is divided, in the orientation of the facet.
[[nodiscard]] std::vector<std::array<int, 3>> facet_division(mesh::CellType facet);

/// Surface of a cavity of the whole actuator, normals out of the cavity: a section is revolved about x, a solid is mirrored at its
/// symmetry planes, and each declared opening is closed by a flat fan. A hole that is not a declared opening stays open.
/// The radius of a revolved point is enlarged by sqrt((2 pi / n) / sin(2 pi / n)), n sectors: the polygon then has the area of its
/// circle, so that the faceted volume is that of the revolved outline.
[[nodiscard]] Triangles cavity_surface(const model::Case& model, const model::Cavity& cavity);

/// Triangles of the given facets of the model, without mirroring (normals out of the rubber). Edges of a section become strips across
/// z = 0, for rays in the meridian plane.
[[nodiscard]] Triangles facet_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets);

}  // namespace soft::surface
