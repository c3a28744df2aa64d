#pragma once
/// Creases: where two facets of the surface meet, the rubber of the cells between them fills an angle. Beyond a full turn the
/// crease is closed and the two walls have passed through each other, although they cross nowhere else near by.
/// Private to the module. Tested by surface/hinges_test and surface/contact_test.
#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::surface {

/// A corner of a section or an edge of a solid that exactly two facets of the surface share.
struct Hinge {
    std::array<int, 2> facets;            ///< numbers in the list given
    std::array<mesh::Index, 2> vertices;  ///< ends of the edge; equal in a section
    std::vector<mesh::Index> cells;       ///< all that have both vertices
};

/// Hinges between facets of the list; none where cells are collapsed.
[[nodiscard]] std::vector<Hinge> hinges(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets);

/// Angle that the rubber fills, summed over the cells, at the middle of the edge [rad]. Each cell's is below pi while its
/// det F is positive, so the sum knows full turns. `positions`: one a mesh point.
[[nodiscard]] double filled_angle(const mesh::Mesh& mesh, const Hinge& hinge, std::span<const mesh::Point> positions);

}  // namespace soft::surface
