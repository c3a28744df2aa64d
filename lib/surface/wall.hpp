#pragma once
/// Wall thickness at a cavity: distance from points on the cavity facets, along the normal into the rubber, to the first boundary.
/// In a section the ray stays in the meridian plane. Symmetry planes and the axis reflect the ray, because the wall continues behind
/// them. Both ends lie on the second-order facets. Tested by surface/wall_test.
#include <optional>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct WallThickness {
    double thickness_m;
    mesh::Point location;  ///< on the cavity, model coordinates
};

/// The minimum found with several points per facet, followed by a search within the facet that has the smallest thickness. Thin
/// features smaller than a facet can be missed. nullopt if no ray hits a boundary.
[[nodiscard]] std::optional<WallThickness> min_wall(const model::Case& model, const model::Cavity& cavity);

}  // namespace soft::surface
