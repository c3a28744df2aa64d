#pragma once
/// Sharp re-entrant corners: boundary points of a section, or boundary edges of a solid, whose interior angle exceeds
/// 220 degrees. The exact strain is singular there: the maximum stretch grows without bound under mesh refinement, and energies
/// and displacements converge at a lower order than that of the cells. Tested by mesh/reentrant_corners_test.
#include <cstddef>

#include "mesh/mesh.hpp"

namespace soft::mesh {

struct ReentrantCorners {
    std::size_t count = 0;  ///< corners of a section; cell edges of a solid
    double length_m = 0;    ///< total length of the edges of a solid, measured as straight lines; 0 for a section
    double cell_m = 0;      ///< median size of the adjacent boundary facets, measured perpendicular to the corner
};

/// The angle is measured between the normals of the curved facets where they meet, so rounded corners are not counted even if
/// only a few cells resolve the rounding.
[[nodiscard]] ReentrantCorners find_reentrant_corners(const Mesh& mesh);

}  // namespace soft::mesh
