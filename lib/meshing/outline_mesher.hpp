#pragma once
/// Outline -> second-order mesh of its section (dimension 2, points (x, r, 0)), without a grid: quad9 cells alone, or
/// triangle6 alone. Mid nodes of boundary edges lie on the exact arcs and splines. One region, "rubber"; facet sets are the edges'
/// faces. gmsh's frontal Delaunay triangles (J.-F. Remacle et al., Int. J. Numer. Meth. Eng. 94, 2013, for the pairs that are
/// joined) at twice the requested length; each then becomes three or four quadrilaterals, so that no triangle is left. Corners on a
/// smooth outline belong to two or more cells, and inner points move where that improves the worst cells (polygons.hpp).
/// Where cells are still poor, the requested length is reduced and the mesh is generated again.
/// The outline must be valid (fault_of). Throws Error(bad_input) with the location if no mesh without inverted cells is found,
/// Error(cannot_open) if gmsh cannot be loaded.
/// gmsh keeps one state per process: calls from several threads must not overlap.
/// Tested by meshing/outline_mesher_test.
#include "mesh/mesh.hpp"
#include "meshing/outline.hpp"

namespace soft::meshing {

enum class FreeCells { quadrilaterals, triangles };

[[nodiscard]] mesh::Mesh mesh_outline(const Outline& outline, FreeCells cells);

}  // namespace soft::meshing
