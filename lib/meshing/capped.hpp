#pragma once
/// A section drawn out along x with a cap at both ends: what it calls a chamber is hollow between the caps.
/// Tested by geometry/segment_test and geometry/fiber_tube_test (volumes in closed form).
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "meshing/section.hpp"

namespace soft::meshing {

struct Capped {
    double length_m, cap_m;                      ///< caps included; of each cap
    int cap_cells, along_cells;                  ///< along x: of each cap, and between them
    std::string low_face, high_face;             ///< at x = 0 and x = length
    std::vector<std::string> between_caps = {};  ///< regions that end at the caps, which are rubber there
};

/// The section holds (y, z); its regions whose names begin with `chamber` become rooms, with faces of the same names, and are
/// rubber within the caps.
[[nodiscard]] mesh::Mesh capped(const Section& section, const Capped& shape, const std::string& chamber);

}  // namespace soft::meshing
