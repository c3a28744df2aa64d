#pragma once
/// Section -> second-order mesh of 9-node quadrilaterals (dimension 2, points (x, r, 0)).
/// Nodes on arcs lie on the exact arcs; inner mid nodes follow the curved grid lines: gmsh meshes each block with linear cells at
/// twice the density, and every 2 x 2 of them become one quadrilateral. Regions are those of the blocks; facet sets are the faces of
/// the curves. Throws std::logic_error for an invalid section, Error(bad_input) for one with an edge shorter than a millionth of its
/// extent, Error(internal) if gmsh fails, Error(cannot_open) if it cannot be loaded.
/// gmsh keeps one state per process: calls from several threads must not overlap.
/// Tested by meshing/section_mesher_test.
#include "mesh/mesh.hpp"
#include "meshing/section.hpp"

namespace soft::meshing {

inline constexpr const char* rubber_region = "rubber";

[[nodiscard]] mesh::Mesh mesh_section(const Section& section);

}  // namespace soft::meshing
