#pragma once
/// The holes of a cavity whose wall is a set of outer sides of a mesh: where the wall ends, a plug would sit.
/// Tested by geometry/imported_test.
#include <array>
#include <vector>

#include "model/case.hpp"

namespace soft::geometry {

/// `opening.face` is the one named face around the hole, or empty where there is none; `around` are the sides next to it.
/// Area vector out of the cavity, of a rim run through as the wall runs through it: 1/2 closed integral of x x dx; of a
/// section that ends at radius r: pi r^2 along x. Source: Stokes' theorem.
struct FoundOpening {
    model::Opening opening;
    std::vector<mesh::Facet> around;
};

/// `mirrors`: the mesh is cut at x, y, z = 0; areas are those of the whole body then. In the order of model::rims (section: of the wall's facets). Plane strain has none.
[[nodiscard]] std::vector<FoundOpening> openings_of(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall,
                                                    model::Kinematics kinematics,
                                                    const std::array<bool, 3>& mirrors = {});

}  // namespace soft::geometry
