#pragma once
/// The surface of a body -> second-order tetrahedra inside it (dimension 3). The surface is made anew in the wished sizes
/// (surface/remesh.hpp), gmsh fills it (Delaunay, or HXT where that fails; C. Geuzaine and J.-F. Remacle, Int. J. Numer. Meth. Eng.
/// 79, 2009), and the mid nodes of outer edges move onto the file's surface and its creases where the cells stay sound. One
/// region, "rubber"; facet sets are the faces. The same bytes each time.
/// Error(bad_input) with file and remedy where the sizes ask for too many cells or no sound mesh is found.
/// Tested by geometry/part_test.
#include "mesh/mesh.hpp"
#include "surface/named_faces.hpp"

namespace soft::meshing {

struct MeshedBody {
    const surface::BodySurface& surface;
    const std::vector<surface::NamedFace>& faces;
    const surface::SoupOrigin& origin;
};
[[nodiscard]] mesh::Mesh mesh_inside(const MeshedBody& body, const surface::SizeAt& size_m);

}  // namespace soft::meshing
