#pragma once
/// A mesh from a Gmsh file (.msh 2.2 or 4.1, ASCII or binary) -> mesh::Mesh in metres.
/// Cells are the elements of the highest dimension, 2 or 3: triangles, quadrilaterals, tetrahedra, hexahedra and prisms,
/// all of first or all of second order. Incomplete second-order elements (quad8, hex20, wedge15) get the nodes they lack
/// from their own serendipity map, so their shape stays.
/// Physical groups of the cells are regions ("rubber" for cells in none that has a name); physical groups one dimension
/// below are facet sets (`face_<tag>` without a name); lower ones are not read. A character that no name of ours may have
/// becomes '_'. Cells of an entity that is numbered mirrored are renumbered. Nodes without a cell are dropped.
/// Throws Error(cannot_open), and Error(bad_input) that names the element for: a side element that is no outer side of a
/// cell, a cell that is inside out, two cells in one place, a cell in two groups, an unknown node; and for plane meshes
/// that are not at a constant z, mixed orders, and files that are no such mesh.
/// Tested by meshing/import_test.
#include <filesystem>
#include <string>

#include "mesh/mesh.hpp"
#include "meshing/msh_file.hpp"

namespace soft::meshing {

/// `unit_m`: length of the file's unit [m]. Points of a plane mesh get z = 0.
[[nodiscard]] mesh::Mesh import_mesh(const std::filesystem::path& path, double unit_m);
/// The same of what stands in a file called `name`.
[[nodiscard]] mesh::Mesh import_mesh(const MshFile& file, const std::string& name, double unit_m);

}  // namespace soft::meshing
