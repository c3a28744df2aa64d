#pragma once
/// Contact of one facet of the actuator with other facets and obstacles. Private to the module. Tested by contact/potential_test and ridge_test.
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "contact/area.hpp"
#include "contact/barrier.hpp"
#include "contact/distance.hpp"
#include "contact/features.hpp"
#include "contact/friction.hpp"
#include "contact/potential.hpp"
#include "contact/reach.hpp"

namespace soft::contact {

/// A sample point and another facet of the actuator.
struct Approach {
    const ContactSurface::Entry& entry;
    std::size_t q;     ///< number of the point
    const Patch& now;  ///< the entry
    const ContactSurface::Entry& other;
    const Patch& patch;  ///< the other facet, deformed
    bool is_revolved;
};

/// Whether the point, which is behind its closest point on the facet, has passed through it. In the undeformed state it was in front of it
/// without rubber between them, and faced it then or does now (two parts of a concave surface do not, and a fold puts one behind the other); or
/// in its plane without rubber between them, and now faces it, with its own cell in front of the facet (beside a ridge the cell is behind it);
/// or it now faces it and is closer than rubber between them can be, which becomes thinner as the area of its sides grows; or it was in front of
/// it and is less than h behind its interior: at an edge of the body, of which another side faces the facet.
[[nodiscard]] bool has_passed_through(const Approach& from, const ClosestPoint& closest, bool faces);

/// An obstacle, or a mirror plane (index -1).
struct ObstacleDistance {
    int index = -1;
    std::function<Distance(const mesh::Point&)> distance;  ///< undisplaced

    /// `shifts`: displacement of each obstacle.
    [[nodiscard]] Distance at(const mesh::Point& x, std::span<const Vector3> shifts) const {
        return distance(seen(x, shifts));
    }
    /// Relative to the obstacle.
    [[nodiscard]] mesh::Point seen(const mesh::Point& x, std::span<const Vector3> shifts) const {
        return index < 0 ? x : along(x, -1, shifts[static_cast<std::size_t>(index)]);
    }
};

/// What all facets of one evaluation share.
struct ContactState {
    const ContactSurface& surface;
    std::span<const Patch> patches;  ///< of all entries of the surface
    std::span<const ObstacleDistance> smooth;
    std::span<const Vector3> shifts;
    Wanted wanted;
    Friction& friction;
    /// Leaves out facets that no point touches first. In contact they count, as the closest one decides what a point has passed through.
    bool rests = false;
};

class FacetContact {
public:
    /// `others`: entries of the surface near this one.
    FacetContact(const ContactState& at, std::size_t facet, std::span<const std::size_t> others, Summary& summary);

    /// Sums over the sample points and passes the blocks on.
    void add(const std::function<void(const Block&)>& to);
    /// By other facet, after add(): the motion towards it after which a point of this facet may touch it or lie behind it.
    [[nodiscard]] std::span<const double> clearances_m() const { return clearances_m_; }
    /// Likewise of the smooth obstacles, the nearest.
    [[nodiscard]] double clearance_of_obstacles_m() const { return clearance_of_obstacles_m_; }
    /// Potential::nodal_pressures_Pa of this facet, after add(); empty where nothing touches.
    [[nodiscard]] std::vector<double> nodal_pressures_Pa() { return std::move(nodal_pressures_Pa_); }

private:
    /// Whether a sample point lies, in the undeformed state, on another facet that it does not face, as at a common corner or edge.
    [[nodiscard]] bool is_at(std::size_t q, const ContactSurface::Entry& other) const;
    void add_features(std::size_t q, const mesh::Point& x);
    void add_features_of(std::size_t q, const mesh::Point& x, std::span<const NearFacet> facets);
    /// Whether the bounding boxes leave it open that the point touches one of the facets or lies behind it.
    [[nodiscard]] bool may_touch(std::size_t q, const mesh::Point& x) const;
    /// Whether the point lies behind a facet, or in its plane, through which it has not passed.
    [[nodiscard]] bool is_beside(std::size_t q, const mesh::Point& x, const Feature& facet) const;
    /// Whether the point has passed through the facet closest to it.
    [[nodiscard]] bool has_passed(std::size_t q, const mesh::Point& x, const Feature& closest) const;
    void add_feature(std::size_t q, const mesh::Point& x, const Feature& feature, const Reach& reach,
                     Nearness nearness);
    void add_smooth(std::size_t q, const mesh::Point& x, const ObstacleDistance& obstacle);
    void add_friction(const Friction::Point& point);
    /// Contact pressure per deformed area that a barrier causes at a sample point, and at a point of another facet of the actuator.
    [[nodiscard]] double pressure_at(std::size_t q, const Barrier& b);
    [[nodiscard]] double pressure_on(const ContactSurface::Entry& entry, const Patch& now,
                                     const surface::FacetPoint& xi, const Barrier& b) const;
    /// `own_Pa`, `other_Pa`: the parts of the pressure by the point and by the other facet.
    void note(std::size_t q, int obstacle, double share, double own_Pa, double other_Pa, const Vector3& away);
    [[nodiscard]] Block& block_of(std::size_t key, int obstacle, std::span<const mesh::Index> others);
    [[nodiscard]] const AreaStretch& stretch_at(std::size_t q);

    const ContactState& at_;
    const ContactSurface::Entry& entry_;
    const Patch& map_;
    std::size_t facet_;
    std::span<const std::size_t> others_;
    Summary& summary_;
    std::vector<const ObstacleDistance*> near_;
    std::map<std::size_t, Block> blocks_;
    std::map<std::size_t, AreaStretch> stretches_;  // of the sample points that touch
    std::vector<double> clearances_m_, nodal_pressures_Pa_;
    std::map<std::size_t, std::vector<double>> pressures_Pa_;  // as in Summary::pressure_Pa, by sample point
    double clearance_of_obstacles_m_ = std::numeric_limits<double>::max();
    std::vector<Touch> touches_;
};

}  // namespace soft::contact
