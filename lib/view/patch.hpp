#pragma once
/// Subdivision of a facet of a solid, or of a cell of a section, into flat pieces by its own shape functions. Used by view/skin.hpp.
/// Tested by view/skin_test.
#include <array>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::view {

struct Patch {
    int nodes = 0;
    std::vector<double> N;                   ///< [point][node]
    std::vector<std::array<int, 4>> pieces;  ///< points; a triangle repeats its last, a line uses the first two;
                                             ///< oriented as the facet
};

/// `segments` pieces along each edge of a second-order facet, one for a first-order facet. Supports lines, triangles and
/// quadrilaterals.
[[nodiscard]] Patch make_patch(mesh::CellType type, int segments);

}  // namespace soft::view
