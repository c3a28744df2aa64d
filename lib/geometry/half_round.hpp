#pragma once
/// The section of a closed half tube: a half ring over a flat wall. Coordinates (y, z); the ring's centre lies at the origin, the
/// flat wall from z = -flat up to the floor z = 0 of the cavity, as wide as the ring. The wall's layers run all round: from the
/// ring straight down its sides and, in the same shares of the flat wall's thickness, across it. Tested by geometry/fiber_tube_test.
#include <span>

#include "geometry/tube_section.hpp"

namespace soft::geometry {

struct HalfRound {
    double inner_m, outer_m;  ///< radii of the ring
    double flat_m;            ///< thickness of the flat wall
    double strip_m;           ///< of its lowest part, which is of another material; 0 = none
};

struct HalfRoundCells {
    int eighth;     ///< around an eighth of a turn
    int flat;       ///< through the flat wall
    double size_m;  ///< elsewhere
};

enum class Cut { whole, half };

/// Regions: "cavity"; those of the layers, with "_flat" after a name other than rubber where they run across the flat wall; the
/// strip's by strip_region. Faces "bottom", "outer", and "symmetry_y" of the half y >= 0.
[[nodiscard]] meshing::Section half_round_section(const HalfRound& shape, std::span<const WallLayer> layers,
                                                  const HalfRoundCells& cells, Cut cut);

}  // namespace soft::geometry
