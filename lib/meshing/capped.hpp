#pragma once
/// A section extruded along x with a cap at both ends; its chamber regions are hollow between the caps.
/// Tested by geometry/segment_test and geometry/fiber_tube_test (volumes in closed form).
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "meshing/section.hpp"

namespace soft::meshing {

struct Capped {
    double length_m, cap_m;                      ///< total length including caps; length of each cap
    int cap_cells;                               ///< along x, in each cap
    std::vector<double> shares;                  ///< cell lengths between the caps over their distance; the sum is 1
    std::string low_face, high_face;             ///< at x = 0 and x = length
    std::vector<std::string> between_caps = {};  ///< regions that end at the caps, which are rubber there

    [[nodiscard]] int layers() const { return 2 * cap_cells + static_cast<int>(shares.size()); }  ///< cells along x
};

/// The section is in (y, z). Its regions whose names begin with `chamber` become cavities with faces of the same names; within the
/// caps they are rubber.
[[nodiscard]] mesh::Mesh capped(const Section& section, const Capped& shape, const std::string& chamber);

/// `block` without some of its cells. `cavity` maps a cell to the face of the cavity that replaces it, or to an empty string for a
/// cell that remains. Facet sets keep the facets of remaining cells. Regions and points without a cell are removed.
[[nodiscard]] mesh::Mesh hollowed(const mesh::Mesh& block, const std::function<std::string(mesh::Index cell)>& cavity);

}  // namespace soft::meshing
