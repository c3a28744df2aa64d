#pragma once
/// Volume enclosed by cavity facets with their second-order shape, in any configuration.
///     axisymmetric   V = pi int r^2 dx along the wall; flat plugs across an opening add nothing
///     plane strain   V = -1/2 int x.n ds per unit depth; the wall must be closed
///     solid          V = -1/3 int x.n da + caps; n out of the rubber, so into the cavity
/// In a solid each rim (free edges of the facet set that do not lie on a symmetry plane) is closed by a cone with its
/// apex c at the mean of the rim's nodes, on the symmetry planes that cut it: cap = 1/6 int c.(y x dy), exact for a flat
/// opening of any outline. The sum is divided by the model fraction and gives the volume of the whole actuator.
/// Source: divergence theorem. Tested by surface/volume_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"
#include "model/cavity_surface.hpp"

namespace soft::surface {

/// [m^3], positive for a correctly oriented cavity. `positions`: one per mesh point (mesh.points, or points + displacement).
[[nodiscard]] double enclosed_volume_m3(const model::Case& model, std::span<const mesh::Facet> facets,
                                        std::span<const mesh::Point> positions);

}  // namespace soft::surface
