#pragma once
/// Creases: at an edge shared by two facets of the surface, the rubber of the cells between them fills an angle. If it exceeds a full
/// turn, the crease is closed and the two walls have passed through each other, although they intersect nowhere else nearby.
/// Private to the module. Tested by contact/hinges_test and contact/contact_test.
#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::contact {

/// A corner of a section or an edge of a solid that exactly two facets of the surface share.
struct Hinge {
    std::array<int, 2> facets;            ///< indices into the list of facets
    std::array<mesh::Index, 2> vertices;  ///< ends of the edge; equal in a section
    std::vector<mesh::Index> cells;       ///< all cells that have both vertices
};

/// Hinges between facets of the list; edges with collapsed cells are omitted.
[[nodiscard]] std::vector<Hinge> hinges(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets);

/// Angle filled by the rubber at the middle of the edge, summed over the cells [rad]. The angle of each cell is below pi while its
/// det F is positive, so the sum is not limited to a full turn. `positions`: one per mesh point.
[[nodiscard]] double filled_angle(const mesh::Mesh& mesh, const Hinge& hinge, std::span<const mesh::Point> positions);

}  // namespace soft::contact
