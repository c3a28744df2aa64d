#pragma once
/// Surfaces as plain triangles: what the geometric checks (CGAL) work on. Second-order facets are divided at their own
/// nodes, so neighbours match without new points. Tested by surface/triangles_test.
#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct Triangles {
    std::vector<mesh::Point> points;  ///< [m], (x, y, z)
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> facets;          ///< of each triangle: which facet of the list it was made from; -1 none
    std::vector<mesh::Point> places;  ///< where each point is in the model's own coordinates: (x, r, 0) of a
                                      ///< section, (x, y, z) of a solid
    /// Of a revolved section: the edges in the plane z = 0, both halves of it, with a triangle of each. The surface crosses itself
    /// exactly where they do, for all its planes through the axis look alike. Empty of others.
    struct Edge {
        std::array<int, 2> points;
        int triangle;
    };
    std::vector<Edge> outline;
};

/// The whole actuator's cavity, normals out of the cavity: a section is revolved about x, the part of a solid mirrored at
/// its symmetry planes, and each declared opening closed by a flat fan. A hole that is no declared opening stays open.
/// A revolved point's radius is enlarged by sqrt((2 pi / n) / sin(2 pi / n)), n sectors: polygons with the area of their
/// circle, so that the faceted volume is that of the revolved outline.
[[nodiscard]] Triangles cavity_surface(const model::Case& model, const model::Cavity& cavity);

/// Triangles of the given facets of the model as they are (normals out of the rubber). A section's edges become ribbons
/// across z = 0, for rays in the meridian plane.
[[nodiscard]] Triangles facet_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets);

}  // namespace soft::surface
