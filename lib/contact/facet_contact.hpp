#pragma once
/// Contact of one facet of the actuator with other facets and obstacles. Private to the module. Tested by contact/potential_test.
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "contact/barrier.hpp"
#include "contact/distance.hpp"
#include "contact/features.hpp"
#include "contact/potential.hpp"

namespace soft::contact {

/// A point behind a facet by less than this fraction of its undeformed distance overlaps with it; by more, rubber is between them.
inline constexpr double overlap_share_of_distance = 0.2;

/// An obstacle with a smooth surface, or a mirror plane (index -1).
struct SmoothObstacle {
    int index = -1;
    std::function<Distance(const mesh::Point&)> distance;
};

/// What all facets of one evaluation share.
struct ContactState {
    const ContactSurface& surface;
    const ContactSurface::Shape& shape;
    std::span<const SmoothObstacle> smooth;
    std::span<const Vector3> shifts;
    Wanted wanted;

    /// A point relative to an obstacle's undisplaced position.
    [[nodiscard]] mesh::Point shifted_back(const mesh::Point& x, int obstacle) const {
        return obstacle < 0 ? x : along(x, -1, shifts[static_cast<std::size_t>(obstacle)]);
    }
};

class FacetContact {
public:
    /// `others`: entries of the surface near this one.
    FacetContact(const ContactState& at, std::size_t facet, std::span<const std::size_t> others, Summary& summary);

    /// Sums over the sample points and passes the blocks on.
    void add(const std::function<void(const Block&)>& to);
    /// A lower bound of the motion towards each other after which a point of this facet may touch; 0 or less in contact.
    [[nodiscard]] double clearance_m() const { return clearance_m_; }

private:
    /// Whether a sample point lies on another facet, at a common corner or edge.
    [[nodiscard]] bool is_at(std::size_t q, const ContactSurface::Entry& other) const;
    void add_features(std::size_t q, const mesh::Point& x);
    void add_feature(std::size_t q, const mesh::Point& x, const Feature& feature);
    void add_smooth(std::size_t q, const mesh::Point& x, const SmoothObstacle& obstacle);
    void note(std::size_t q, int obstacle, double share, const Barrier& b);
    [[nodiscard]] Block& block_of(std::size_t key, int obstacle, std::span<const mesh::Index> others);
    /// Deformed over undeformed area.
    [[nodiscard]] double stretch_at(std::size_t q) const;

    const ContactState& at_;
    const ContactSurface::Entry& entry_;
    const Patch& map_;
    std::span<const std::size_t> others_;
    Summary& summary_;
    std::vector<const SmoothObstacle*> near_;
    std::map<std::size_t, Block> blocks_;
    double clearance_m_ = std::numeric_limits<double>::max();
};

}  // namespace soft::contact
