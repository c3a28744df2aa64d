#pragma once
/// Coulomb friction at the sample points of the contact potential (potential.hpp), as elastic-plastic slip in the tangent plane:
///   e = e_0 + g(x),   t = k_t e where |k_t e| <= mu f, else t = mu f e/|e|,   k_t = w k / h
/// with the elastic slip e_0 and the state x_0 at the start of the step, the tangential motion g(x) since then of the point relative to
/// the obstacle or to the point of the other facet, the force f of the normal contact, and the share w of the undeformed area.
/// The derivative of t contains that of f by the gap and by the area, which is not symmetric, and the rotation of the tangent plane on a smooth obstacle.
/// It omits that rotation on facets and the motion of the closest point along the other facet, both of the order of mu f over the
/// stiffness of the surface.
/// The slip e is at most mu f h/(w k) in rest, which is below h: the larger h, the more a surface creeps before it slides.
/// Source: Simo and Laursen, An augmented Lagrangian treatment of contact problems involving friction, Comput. Struct. 42 (1992) 97 (return
/// mapping).
/// Private to the module. Tested by contact/potential_test and the verification suite (group Contact).
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_surface.hpp"
#include "contact/potential.hpp"

namespace soft::contact {

/// Force of the normal contact on a sample point.
struct Touch {
    std::size_t point = 0;
    int obstacle = -1;
    Vector3 gradient{};  ///< of the energy by the position of the sample point
    double force_by_gap_N_m = 0;
    std::optional<std::size_t> other = {};  ///< entry of the surface that touches; none for a smooth obstacle
    surface::FacetPoint xi{};
    bool is_closest = true;
    double depth_m = 0;  ///< below the contact distance
    std::array<Vector3, 3> normal_by_position_1_m{};
};

class Friction {
public:
    /// `coefficients`: by obstacle, then of the actuator with itself.
    Friction(const ContactSurface& surface, std::vector<double> coefficients);

    [[nodiscard]] bool is_empty() const { return is_empty_; }

    /// Starts a step with these elastic slips and the energy dissipated so far; no point touches until set().
    void start(std::vector<Patch> patches, std::span<const Vector3> shifts, const FrictionState& from);
    [[nodiscard]] FrictionState start_state() const;
    /// Sets the points of a facet that touch.
    void set(std::size_t facet, std::span<const Touch> touches, std::span<const Patch> patches,
             std::span<const Vector3> shifts);

    struct Point {
        std::size_t point = 0;
        int obstacle = -1;
        std::optional<std::size_t> other;  ///< facet of the actuator
        surface::FacetPoint xi{};
        Vector3 normal{}, elastic_m{},
            start_m{};  ///< e = start + share P x, x relative to the obstacle or the other facet
        double limit_N = 0, limit_by_gap_N_m = 0, stiffness_N_m = 0;
        double limit_before_N = 0;  ///< at the start of the step
        double share = 1;           ///< of the motion of the step that is in contact
        std::array<Vector3, 3> normal_by_position_1_m{};
    };
    [[nodiscard]] std::span<const Point> points(std::size_t facet) const;

    /// A point at the present position.
    struct Value {
        double stored_J = 0, dissipated_J = 0;  ///< since the start of the step
        Vector3 elastic_m{}, force_N{};         ///< the force against the motion
        std::array<Vector3, 3> by_position{};
        bool slides = false;  ///< the force is in proportion to the limit
    };
    [[nodiscard]] static Value value(const Point& point, const Vector3& relative);
    /// Position relative to the obstacle or the other facet.
    [[nodiscard]] Vector3 relative(std::size_t facet, const Point& point, std::span<const Patch> patches,
                                   std::span<const Vector3> shifts) const;

    /// Dissipated before the step, and by points that no longer touch.
    [[nodiscard]] double dissipated_before_J() const;
    [[nodiscard]] FrictionState state(std::span<const Patch> patches, std::span<const Vector3> shifts) const;

private:
    using Key = std::tuple<std::size_t, std::size_t, int>;  // facet, point, obstacle
    [[nodiscard]] double stiffness_N_m(std::size_t facet, std::size_t point, int obstacle) const;

    const ContactSurface& surface_;
    std::vector<double> coefficients_;
    bool is_empty_;
    std::vector<Patch> patches_;  // at the start of the step
    std::vector<Vector3> shifts_;
    struct Start {
        Vector3 elastic_m{};
        double limit_N = 0;
    };
    std::map<Key, Start> slips_;
    std::vector<std::vector<Point>> points_;  // by facet
    double dissipated_J_ = 0;
};

}  // namespace soft::contact
