#pragma once
/// A side of a cell, or a cell of a section, cut into flat pieces by its own shape functions. For view/skin.hpp, whose
/// tests hold it.
#include <array>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::view {

struct Patch {
    int nodes = 0;
    std::vector<double> N;                   ///< [point][node]
    std::vector<std::array<int, 4>> pieces;  ///< points; a triangle repeats its last, of a line the first two count;
                                             ///< oriented as the side
};

/// `segments` along each edge of a second-order side, one along that of a first-order side. Lines, triangles,
/// quadrilaterals.
[[nodiscard]] Patch make_patch(mesh::CellType type, int segments);

}  // namespace soft::view
