#pragma once
/// Openings of a cavity whose wall is a set of boundary facets: the rims of the wall, which a plug would close.
/// Tested by geometry/imported_test.
#include <array>
#include <vector>

#include "model/case.hpp"

namespace soft::geometry {

/// `opening.face` is the named face that contains all of `around`, or empty if there is none. `around` are the boundary facets
/// next to the opening. Area vector, pointing out of the cavity: 1/2 (closed integral of x x dx) along the rim in the orientation
/// of the wall; for a section that ends at radius r: pi r^2 along x. Source: Stokes' theorem.
struct FoundOpening {
    model::Opening opening;
    std::vector<mesh::Facet> around;
};

/// `mirrors`: whether the mesh is cut at x, y, z = 0; areas are then those of the whole body. Ordered as model::rims (solid) or by node
/// number (section). Empty in plane strain.
[[nodiscard]] std::vector<FoundOpening> openings_of(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall,
                                                    model::Kinematics kinematics,
                                                    const std::array<bool, 3>& mirrors = {});

}  // namespace soft::geometry
