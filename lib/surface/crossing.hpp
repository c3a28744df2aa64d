#pragma once
/// Do two facets cross, and where? Judged on their pieces (surface/divided.hpp) with exact predicates.
/// Private to the module. Tested by surface/contact_test.
#include <optional>

#include "surface/divided.hpp"

namespace soft::surface {

/// Two facets of a set; neighbours have a node in common.
struct FacetPair {
    const DividedFacets* facets;
    std::size_t first, second;

    [[nodiscard]] bool neighbours() const;
};

/// Lengths below this fraction of a facet are none: places are the same, walls touch.
inline constexpr double same_place = 1e-6;

/// Mean of the places where pieces of the two facets cross in `now`, in reference coordinates of the first. Pieces of
/// neighbours that have a point in common, judged by the `undeformed` shape, are passed over.
[[nodiscard]] std::optional<FacetPoint> crossing(const FacetPair& pair, const DividedShape& undeformed,
                                                 const DividedShape& now);

/// Whether they come as near as `same_place` to each other where they are no neighbours.
[[nodiscard]] bool touching(const FacetPair& pair, const DividedShape& undeformed);

/// Whether the normals of both together leave a direction in which the pair is seen from one side only: neighbours then do
/// not cross (P. Volino and N. Magnenat-Thalmann, Efficient self-collision detection, Computer Graphics Forum 13, 1994).
[[nodiscard]] bool seen_from_one_side(const NormalCone& a, const NormalCone& b);

}  // namespace soft::surface
