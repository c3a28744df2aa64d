#pragma once
/// The parts of a surface that are close to a point, with coefficients that count each part of the surface once:
///   sum over facets of b(d) - sum over edges between two facets of b(d) + sum over inner corners of b(d)
/// equals b of the closest point where one facet is near and on smooth or convex surfaces, and is smooth where the closest point jumps
/// from one facet to another in a re-entrant edge, as the distance itself is not. In general an edge of n facets has the coefficient
/// 1 - n, and a corner of n facets with m edges between them 1 - n + m, so that all terms of a common closest point add up to one.
/// Source: Li et al., Convergent Incremental Potential Contact, arXiv 2307.15908 (2023), section 3. Private to the module.
/// Tested by contact/potential_test.
#include <vector>

#include "contact/contact_surface.hpp"

namespace soft::contact {

struct Feature {
    enum class Kind { facet, edge, corner };
    Kind kind = Kind::facet;
    std::size_t facet = 0;  ///< one that has it
    std::size_t k = 0;      ///< number of the edge or corner in that facet
    ClosestPoint closest;
    double coefficient = 1;
    Vector3 normal{};  ///< sum of the unit normals at the closest point: on which side of the surface the point lies
    bool is_closest = false;  ///< of all facets
    std::size_t group = 0;    ///< features of facets that share corners, directly or through others, have the same
};

/// An entry of the surface, and its point closest to x.
struct NearFacet {
    std::size_t facet = 0;
    ClosestPoint closest;
};

[[nodiscard]] std::vector<Feature> features_near(const ContactSurface& surface, std::span<const Patch> patches,
                                                 std::span<const NearFacet> facets, const mesh::Point& x);

}  // namespace soft::contact
