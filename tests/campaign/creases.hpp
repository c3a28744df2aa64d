#pragma once
/// At the common edge of two facets of the surface (the common node in a section), rubber fills an angle and air the rest of a full turn.
/// A crease closes when no air is left; at a symmetry plane, when none is left between a facet and its mirror image. Curved facets are
/// evaluated exactly at several points of each edge, because a crease of second-order cells closes between the nodes.
/// Tested by campaign/shape_checks_test.
#include <span>
#include <vector>

#include "model/case.hpp"
#include "surface/facet_map.hpp"

namespace soft::campaign {

class Creases {
public:
    /// `model` and `skin` must outlive it.
    Creases(const model::Case& model, const std::vector<mesh::Facet>& skin);

    /// True if a crease that was open at `before` has closed at `now` (one position per point). A thin spike of rubber, whose angle is as
    /// small as that of a crease just closed, reaches this angle from the other side and does not count.
    [[nodiscard]] bool has_closed(std::span<const mesh::Point> before, std::span<const mesh::Point> now) const;

private:
    /// One edge of a facet, in reference coordinates.
    struct EdgeSide {
        std::size_t facet;
        surface::FacetPoint from, to, inward;
    };
    struct Crease {
        EdgeSide one;
        EdgeSide other;   ///< equal to `one` at a symmetry plane
        int mirror = -1;  ///< index of the coordinate that is zero on the symmetry plane; -1: none
    };
    [[nodiscard]] double rubber_angle(const Crease& crease, double along, std::span<const mesh::Point> positions) const;

    const model::Case& model_;
    const std::vector<mesh::Facet>& skin_;
    std::vector<Crease> creases_;
};

}  // namespace soft::campaign
