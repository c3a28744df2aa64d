#pragma once
/// Outline -> second-order mesh of its section (dimension 2, points (x, r, 0)), without a grid: quad9 cells alone, or
/// triangle6 alone. Mid nodes of boundary edges lie on the true arcs and splines. One region, "rubber"; facet sets are the edges'
/// faces. gmsh's frontal Delaunay triangles (J.-F. Remacle et al., Int. J. Numer. Meth. Eng. 94, 2013, for the pairs that are
/// joined) at twice the requested length; each then becomes three or four quadrilaterals, so that no triangle is left. No cell is
/// flat in a corner on a smooth outline, and inner points move where that improves the worst cells (polygons.hpp).
/// Where cells are still poor, they are made shorter and the mesh is generated again.
/// The outline must be sound (fault_of). Error(bad_input) with the place where no mesh without inverted cells is found. Error(internal) when gmsh fails, Error(cannot_open) when it cannot be loaded.
/// gmsh keeps one state per process: calls from several threads must not overlap.
/// Tested by meshing/outline_mesher_test.
#include "mesh/mesh.hpp"
#include "meshing/outline.hpp"

namespace soft::meshing {

enum class FreeCells { quadrilaterals, triangles };

[[nodiscard]] mesh::Mesh mesh_outline(const Outline& outline, FreeCells cells);

}  // namespace soft::meshing
