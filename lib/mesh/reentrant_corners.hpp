#pragma once
/// Sharp re-entrant corners of a body: points of a section's boundary, edges of a solid's, where the two sides of the surface
/// enclose more than 220 degrees of the body. There the exact strain is singular: the largest stretch grows without limit on
/// finer meshes, and energies and displacements converge in less than the cells' order. Tested by mesh/inner_corners_test.
#include <cstddef>

#include "mesh/mesh.hpp"

namespace soft::mesh {

struct InnerCorners {
    std::size_t count = 0;  ///< corners of a section; edges of cells of a solid
    double length_m = 0;    ///< of the edges of a solid, as straight lines; 0 of a section
    double cell_m = 0;      ///< median length of the sides of cells that meet there, across the corner
};

/// Normals are those of the curved sides where they meet, so that rounded corners do not count, however few cells they have.
[[nodiscard]] InnerCorners inner_corners(const Mesh& mesh);

}  // namespace soft::mesh
