#pragma once
/// Intersection of two facets, tested on their pieces (contact/divided.hpp) with exact predicates.
/// Private to the module. Tested by contact/contact_test.
#include <optional>

#include "contact/divided.hpp"

namespace soft::contact {

/// Two facets of a set; neighbours share a node.
struct FacetPair {
    const DividedFacets* facets;
    std::size_t first, second;

    [[nodiscard]] bool are_neighbours() const;
};

/// Fraction of the size of a facet below which points coincide and walls touch.
inline constexpr double coincidence_tolerance = 1e-6;

/// Mean of the points where pieces of the two facets intersect in `now`, in reference coordinates of the first facet. Pieces of
/// neighbours that share a point in the `undeformed` shape are ignored, as are those of which one reaches less than `least_overlap_m`
/// beyond the plane of the other.
[[nodiscard]] std::optional<surface::FacetPoint> find_crossing(const FacetPair& pair, const DividedShape& undeformed,
                                                               const DividedShape& now, double least_overlap_m = 0);

/// Whether the distance of two pieces without a common point is within `coincidence_tolerance`.
[[nodiscard]] bool is_touching(const FacetPair& pair, const DividedShape& undeformed);

/// Whether there is a direction from which only one side of both facets is visible. Neighbouring facets then do not intersect
/// (P. Volino and N. Magnenat-Thalmann, Efficient self-collision detection, Computer Graphics Forum 13, 1994).
[[nodiscard]] bool is_visible_from_one_side(const NormalCone& a, const NormalCone& b);

}  // namespace soft::contact
