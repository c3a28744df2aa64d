#pragma once
/// A mesh from a Gmsh file (.msh 2.2 or 4.1, ASCII or binary) -> mesh::Mesh in metres.
/// Cells are the elements of the highest dimension, 2 or 3: triangles, quadrilaterals, tetrahedra, hexahedra and prisms,
/// all of first or all of second order. Incomplete second-order elements (quad8, hex20, wedge15) get the nodes they lack
/// from their own serendipity map, so their shape is unchanged.
/// Physical groups of cells are regions ("rubber" for cells without a named group); physical groups one dimension below are facet
/// sets (`face_<tag>` if they have no name); lower ones are ignored. Characters that are not allowed in names become '_'. Cells of
/// an entity with mirrored node numbering are renumbered. Nodes without a cell are dropped.
/// Throws Error(cannot_open), and Error(bad_input) with the element for: a side element that is not a boundary facet, an inverted
/// cell, duplicate cells, a cell in two groups, an unknown node. Throws Error(bad_input) for plane meshes that are not at a constant
/// z, mixed orders, and files that are not such a mesh.
/// Tested by meshing/import_test.
#include <filesystem>
#include <string>

#include "mesh/mesh.hpp"
#include "meshing/msh_file.hpp"

namespace soft::meshing {

/// `unit_m`: length unit of the file [m]. Points of a plane mesh get z = 0.
[[nodiscard]] mesh::Mesh import_mesh(const std::filesystem::path& path, double unit_m);
/// The same for the contents of a file called `name`.
[[nodiscard]] mesh::Mesh import_mesh(const MshFile& file, const std::string& name, double unit_m);

}  // namespace soft::meshing
