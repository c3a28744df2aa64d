#pragma once
/// How far the parts of a surface act on a sample point. Private to the module. Tested by contact/parts_test.
#include <map>
#include <span>

#include "contact/features.hpp"

namespace soft::contact {

/// Of the distance in the undeformed state: within it a point acts on a facet that it does not face there.
inline constexpr double share_of_initial_gap = 0.1;

/// A sample point and a facet act on each other where the distance plus the offset is below the reach; once with the contact distance h of
/// the point, and once with that of the facet.
struct Reach {
    double own_m;              ///< h; less where they do not face each other in the undeformed state
    double offset_m;           ///< h minus the distance there, at least 0; 0 where they do not face each other
    double other_m;            ///< likewise of the facet; 0 for an obstacle
    double offset_of_other_m;  ///< likewise
};

class Reaches {
public:
    /// `features`: of one call of features_near; must outlive this, as the others.
    Reaches(const ContactSurface& surface, const ContactSurface::Entry& entry, std::size_t q,
            std::span<const Feature> features)
        : surface_(surface), entry_(entry), q_(q), features_(features) {}

    /// Of an edge or corner: the least of its facets, of whose terms it cancels all but one.
    [[nodiscard]] Reach of(const Feature& feature);

private:
    [[nodiscard]] Reach of_facet(const Feature& facet);
    [[nodiscard]] Reach find(const Feature& facet) const;

    const ContactSurface& surface_;
    const ContactSurface::Entry& entry_;
    std::size_t q_;
    std::span<const Feature> features_;
    std::map<std::size_t, Reach> known_;  // by facet
};

}  // namespace soft::contact
