#include "contact/reach.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace soft::contact {

Reach Reaches::find(const Feature& facet) const {
    const auto& other = surface_.entries()[facet.facet];
    const double h = entry_.h_m[q_];
    if (other.obstacle >= 0) return {h, surface_.initial_overlap_m(entry_, q_, other.obstacle), 0, 0};
    const double h_other = contact_distance_m(other, facet.closest.xi),
                 near = std::max(h, other.distance_m) / share_of_initial_gap,
                 bound = at_least(other.undeformed, entry_.X[q_]);
    const ClosestPoint before = bound > near ? ClosestPoint{bound} : closest_point(other.undeformed, entry_.X[q_]);
    const double initial = before.distance_m;
    if (initial <= near && are_facing(entry_, q_, other.undeformed, before))
        return {h, surface_.initial_overlap_m(entry_, q_, -1), h_other, std::max(h_other - initial, 0.0)};
    return {std::min(h, share_of_initial_gap * initial), 0, std::min(h_other, share_of_initial_gap * initial), 0};
}

Reach Reaches::of_facet(const Feature& facet) {
    const auto found = known_.find(facet.facet);
    return found != known_.end() ? found->second : known_.emplace(facet.facet, find(facet)).first->second;
}

Reach Reaches::of(const Feature& feature) {
    if (feature.kind == Feature::Kind::facet) return of_facet(feature);
    const auto& with_it = surface_.entries()[feature.facet];
    std::vector<std::size_t> corners{with_it.corners[feature.k]};
    if (feature.kind == Feature::Kind::edge) {
        const auto [first, last] = edge_corners(with_it.undeformed.type, feature.k);
        corners = {with_it.corners[first], with_it.corners[last]};
    }
    std::optional<Reach> least;
    for (const Feature& facet : features_) {
        if (facet.kind != Feature::Kind::facet || facet.group != feature.group) continue;
        const auto& has = surface_.entries()[facet.facet].corners;
        if (!std::ranges::all_of(corners, [&](std::size_t k) { return std::ranges::find(has, k) != has.end(); }))
            continue;
        const Reach reach = of_facet(facet);
        if (!least || std::pair{reach.own_m, reach.offset_m} < std::pair{least->own_m, least->offset_m}) least = reach;
    }
    return *least;
}

}  // namespace soft::contact
