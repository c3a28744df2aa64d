#pragma once
/// Thickness of the rubber behind a cavity: from points on the cavity's facets, along the normal into the rubber, to the
/// first boundary on the way. In a section the ray stays in the meridian plane. Symmetry planes and the axis mirror the
/// ray: the wall goes on behind them. Both ends lie on the true second-order facets. Tested by surface/wall_test.
#include <optional>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct WallThickness {
    double thickness_m;
    mesh::Point place;  ///< on the cavity, model coordinates
};

/// The smallest one found. Several points a facet, then a search within the facet that has the smallest; two neighbouring
/// features thinner than a facet is long can be missed. nullopt where no ray meets a boundary.
[[nodiscard]] std::optional<WallThickness> min_wall(const model::Case& model, const model::Cavity& cavity);

}  // namespace soft::surface
