#pragma once
/// The surface of a body -> second-order tetrahedra inside it (dimension 3). The surface is remeshed to the requested sizes
/// (meshing/remesh.hpp). gmsh fills it with tetrahedra (Delaunay, or HXT if that fails; C. Geuzaine and J.-F. Remacle, Int. J.
/// Numer. Meth. Eng. 79, 2009). Mid nodes of boundary edges move onto the surface of the file and its creases as far as the cells
/// stay valid. One region, "rubber"; facet sets are the faces. The result is reproducible bit by bit.
/// Throws Error(bad_input) with file and remedy if the sizes require too many cells or no valid mesh is found.
/// Tested by geometry/part_test.
#include "mesh/mesh.hpp"
#include "meshing/named_faces.hpp"

namespace soft::meshing {

struct MeshedBody {
    const BodySurface& surface;
    const std::vector<NamedFace>& faces;
    const SoupOrigin& origin;
};
[[nodiscard]] mesh::Mesh mesh_inside(const MeshedBody& body, const SizeAt& size_m);

}  // namespace soft::meshing
