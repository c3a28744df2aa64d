#pragma once
/// Where two facets of the surface meet, rubber fills an angle about their common edge (their common node, of a section), the air
/// the rest of the turn. A crease closes where no air is left; at a mirror, where none is left between a facet and its image.
/// Curved facets are taken as they are, at several points of each edge: a crease of second-order cells closes between the nodes.
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

    /// Whether a crease that was open at `before` has no air left at `now`: one position a point. A spike of rubber, whose angle
    /// is as small as that of a crease just closed, comes to it from the other side.
    [[nodiscard]] bool close(std::span<const mesh::Point> before, std::span<const mesh::Point> now) const;

private:
    /// One side of a facet, in its reference coordinates.
    struct Border {
        std::size_t facet;
        surface::FacetPoint from, to, inward;
    };
    struct Crease {
        Border one;
        Border other;     ///< the same one at a mirror
        int mirror = -1;  ///< the coordinate that is zero there
    };
    [[nodiscard]] double rubber(const Crease& crease, double along, std::span<const mesh::Point> positions) const;

    const model::Case& model_;
    const std::vector<mesh::Facet>& skin_;
    std::vector<Crease> creases_;
};

}  // namespace soft::campaign
