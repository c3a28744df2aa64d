#pragma once
/// Contact of the actuator with itself, with its mirror images and with rigid obstacles, as a potential of the current positions:
///   E = sum_q w_q psi_q k b(d_q),       k = stiffness_share E_0
/// over the sample points q of all free facets, with w_q their share of the undeformed area (2 pi R included), psi_q a factor that is 1 until the
/// area has grown fourfold (area.hpp), E_0 Young's modulus of the facet's rubber without strain, and b the barrier (barrier.hpp) of the distance
/// d_q to the other facets (features.hpp; w_q/2, because both sides count) or to an obstacle. The contact pressure is k |b'| psi per undeformed
/// area, between two facets the mean of what both act with; the gap left in contact is below the contact distance h.
/// Facets are the curved facets of the mesh, and no term of the second derivatives is omitted.
/// d_q is negative behind the facet, for points that have passed through it (has_passed_through in facet_contact.hpp): only Newton's
/// iterates go there.
/// No force acts without strain: where facets that face each other are closer than h in the undeformed state, at D, the barrier depends on
/// d + h - D. The h of other pairs is at most a tenth of D, which separates points that are close along the material. For an obstacle, D is the
/// distance of the nearest point of the actuator: with that of each point the surface of a ball would have a dent where it touches.
/// A symmetry plane, and the axis r = 0, is an obstacle without friction: a body touches its mirror image at the plane.
/// Friction (friction.hpp) acts where a coefficient is positive. Its forces have no potential: the Hessian of a block is then their derivative,
/// which is not symmetric, and E contains what friction stores.
/// Two sides of one wall or cell, and facets that share a node and are visible from one side (Volino), do not act on each other.
/// Derived here; the idea of the potential: Li et al. 2020 (barrier.hpp), on curved facets as in M. Ferguson et al., High-order
/// incremental potential contact, SIGGRAPH 2023. Tested by contact/potential_test, ridge_test, obstacle_test and the verification suite.
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/block.hpp"
#include "model/case.hpp"

namespace soft::contact {

/// Contact in one configuration, of the facets that the caller asked for.
struct Summary {
    explicit Summary(std::size_t obstacles) : area_m2(obstacles + 1), pressure_Pa(obstacles + 1) {}

    double energy_J = 0;
    std::vector<double> area_m2;  ///< deformed area in contact, by obstacle, then with itself (mirror images included)
    std::vector<double> pressure_Pa;      ///< largest nodal pressure (nodal_pressures_Pa), in the same order
    double max_pressure_Pa = 0;           ///< of all sample points, also beside an edge
    double dissipated_J = 0;              ///< by friction since the first step
    std::optional<mesh::Point> location;  ///< undeformed point where that pressure is
    int touched = -1;                     ///< obstacle there; -1 itself

    [[nodiscard]] bool touches() const { return location.has_value(); }
};

/// What a step of a path with friction starts from.
struct FrictionState {
    struct Slip {
        std::size_t facet = 0, point = 0;
        int obstacle = -1;
        Vector3 elastic_m{};
        double limit_N = 0;  ///< at which it slides
    };
    std::vector<Slip> slips;
    double dissipated_J = 0;  ///< so far, by the facets of the caller
};

class Potential {
public:
    using Take = std::function<bool(mesh::Index)>;

    /// `modulus_Pa`: E_0 by region. Copies what it needs from the case.
    Potential(const model::Case& model, std::span<const double> modulus_Pa);
    ~Potential();
    Potential(Potential&&) noexcept;

    /// True where nothing can ever touch: evaluate() finds no blocks.
    [[nodiscard]] bool is_empty() const;
    [[nodiscard]] double distance_m() const;  ///< the largest h; 0 where nothing can touch
    /// Steps in which the distance of all pairs changes by less than this need no limit.
    [[nodiscard]] double harmless_step_m() const;
    /// Nodes of the free facets and corners of their cells, ascending: the positions that evaluate() reads.
    [[nodiscard]] std::span<const mesh::Index> nodes() const;

    /// `positions`: one per mesh point; `shifts`: displacement of each obstacle; `take(cell)`: whether the points of the facet of a cell
    /// are summed. Blocks come in a fixed order.
    Summary evaluate(std::span<const mesh::Point> positions, std::span<const Vector3> shifts, Wanted wanted,
                     const Take& take, const std::function<void(const Block&)>& add);
    /// evaluate(...).touches(), in a fraction of the time while nothing touches.
    [[nodiscard]] bool touches(std::span<const mesh::Point> positions, std::span<const Vector3> shifts,
                               const Take& take);

    /// Contact pressure at the mesh points, 0 where nothing touches: means over the sample points of a facet, weighted with the square of
    /// the node's shape function, and of them the largest of the facets at the node (at an edge only one of them may touch).
    [[nodiscard]] std::vector<double> nodal_pressures_Pa(std::span<const mesh::Point> positions,
                                                         std::span<const Vector3> shifts);

    [[nodiscard]] bool has_friction() const;
    /// Number of sample points of all facets: slips of another number belong to another mesh or version.
    [[nodiscard]] std::size_t sample_points() const;
    /// Starts a step at this configuration. False if a slip is not that of a sample point.
    [[nodiscard]] bool start_friction(std::span<const mesh::Point> positions, std::span<const Vector3> shifts,
                                      const FrictionState& from, const Take& take);
    /// The state of the configuration that was evaluated last, and of the start of the step.
    [[nodiscard]] FrictionState friction_state(std::span<const mesh::Point> positions,
                                               std::span<const Vector3> shifts) const;
    [[nodiscard]] FrictionState friction_start() const;

    /// The share of the way from one configuration to another, at most 1, up to which no sample point goes deeper behind a facet or obstacle
    /// than evaluate() can see, judged by the distances at the start.
    [[nodiscard]] double share_without_crossing(std::span<const mesh::Point> from, std::span<const Vector3> shifts,
                                                std::span<const mesh::Point> to, std::span<const Vector3> shifts_to);

    /// Whether a sample point, on the straight way from one configuration to the other, passes through an obstacle, to another side of it, or
    /// more than h deep through its edge.
    [[nodiscard]] bool passes_through(std::span<const mesh::Point> from, std::span<const Vector3> shifts,
                                      std::span<const mesh::Point> to, std::span<const Vector3> shifts_to) const;

    /// Pairs of facets of the actuator that are in contact or within `share` of their size of it.
    [[nodiscard]] std::vector<std::array<mesh::Facet, 2>> near_pairs(std::span<const mesh::Point> positions,
                                                                     std::span<const Vector3> shifts, double share);

private:
    class Parts;
    Summary evaluate(std::span<const mesh::Point> positions, std::span<const Vector3> shifts, Wanted wanted,
                     const Take& take, const std::function<void(const Block&)>& add, bool rests);
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::contact
