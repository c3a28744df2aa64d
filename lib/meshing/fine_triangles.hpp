#pragma once
/// Triangulation of curved facets for file export. Edges are bisected until their chords are within `deviation_m` of the curved edge
/// and the angle per chord is at most about 15 degrees (so that programs that detect sharp edges do not mistake a fillet for one).
/// The triangulation is conforming. Tested by meshing/fine_triangles_test.
#include <vector>

#include "mesh/mesh.hpp"
#include "surface/triangles.hpp"

namespace soft::meshing {

/// `facets` belong to a solid mesh; the normals of the triangles point out of the rubber.
[[nodiscard]] surface::Triangles fine_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets,
                                                double deviation_m);

}  // namespace soft::meshing
