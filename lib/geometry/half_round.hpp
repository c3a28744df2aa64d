#pragma once
/// Section of a closed half-round tube: a half ring on a flat wall. Coordinates (y, z). The centre of the ring is the origin. The
/// flat wall spans z = -flat to the floor z = 0 of the cavity and is as wide as the ring. The wall layers surround the cavity:
/// they continue from the ring straight down and cross the flat wall, with the same shares of its thickness. Tested by
/// geometry/fiber_tube_test.
#include <span>

#include "geometry/tube_section.hpp"

namespace soft::geometry {

struct HalfRound {
    double inner_m, outer_m;  ///< radii of the ring
    double flat_m;            ///< thickness of the flat wall
    double strip_m;           ///< thickness of its lowest part, which has another material; 0 = none
};

struct HalfRoundCells {
    int eighth;     ///< cells around an eighth of a turn
    int flat;       ///< cells through the flat wall
    double size_m;  ///< cell length elsewhere
};

enum class Cut { whole, half };

/// Regions: "cavity"; those of the layers, with the suffix "_flat" (except rubber) where they cross the flat wall; those of the
/// strip, named by strip_region. Faces: "bottom", "outer", and "symmetry_y" for the half y >= 0.
[[nodiscard]] meshing::Section half_round_section(const HalfRound& shape, std::span<const WallLayer> layers,
                                                  const HalfRoundCells& cells, Cut cut);

}  // namespace soft::geometry
