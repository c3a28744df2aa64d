#pragma once
/// Curved facets as plain triangles that stay near them: for files. Edges are halved until their chords are within
/// `deviation_m` of the facet's true edge and turn by no more than about 15 degrees each (so that a reader who looks for sharp
/// edges does not take a fillet for one); neighbours match. Tested by surface/fine_triangles_test.
#include <vector>

#include "mesh/mesh.hpp"
#include "surface/triangles.hpp"

namespace soft::surface {

/// Of a solid; normals out of the rubber.
[[nodiscard]] Triangles fine_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets,
                                       double deviation_m);

}  // namespace soft::surface
