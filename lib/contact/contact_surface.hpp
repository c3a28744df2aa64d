#pragma once
/// The facets that may touch: the free facets of the actuator with their sample points, and the facets of faceted obstacles.
/// Private to the module. Tested by contact/potential_test.
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "contact/closest_point.hpp"
#include "contact/divided.hpp"
#include "model/case.hpp"

namespace soft::contact {

/// Points and weights on a reference facet. Corners and edges are among the points, so that a corner does not slip through between them.
///   line: 65 points at equal distances, by Gregory's rule (exact to degree 5); quadrilateral: Simpson's rule in each third of both directions;
///   triangle: four times the rule with corners (1/20), middles of edges (2/15) and centroid (9/20), exact to degree 3.
struct SampleRule {
    std::vector<surface::FacetPoint> xi;
    std::vector<double> weights;
    std::vector<double> N;                ///< [point][node]
    std::vector<surface::FacetPoint> dN;  ///< derivatives of the shape functions [point][node]
};
[[nodiscard]] SampleRule sample_rule(mesh::CellType facet);

/// A point behind a facet by less than this fraction of its own facet's size overlaps with it.
inline constexpr double overlap_share_of_size = 0.2;

/// Of a facet's size: closer, surfaces touch, as the direction of the gap is lost in rounding.
inline constexpr double touching_share_of_size = 1e-6;

/// Whether a point at this radius lies on the axis of revolution, on a facet of this size.
[[nodiscard]] inline bool is_on_axis(double radius_m, double size_m) {
    return radius_m <= touching_share_of_size * size_m;
}

/// How two facets of the actuator lie to each other in the undeformed state. Sides of a groove are neighbours with air between them; between
/// the sides of a wall, or of one cell, is rubber.
enum class Adjacency { apart, neighbours, sides_of_a_groove, sides_of_a_wall };

/// Whether facets of the actuator act on each other.
[[nodiscard]] inline bool has_self_contact(const model::Case& model) {
    return model.contact.self && model.path.contact == model::Contact::solve;
}

class ContactSurface {
public:
    ContactSurface(const model::Case& model, std::span<const double> modulus_Pa);

    struct Entry {
        mesh::Facet facet{};  ///< of the actuator
        std::vector<mesh::Index> cell_corners;
        std::vector<mesh::Index> nodes;
        std::vector<std::size_t> corners;  ///< numbers of the corners, equal for corners that facets share
        int obstacle = -1;                 ///< of a facet of an obstacle
        Patch undeformed{};
        double size_m = 0;
        const SampleRule* rule = nullptr;
        std::vector<mesh::Point> X;      ///< undeformed sample points
        std::vector<double> weight_m2;   ///< undeformed area of the sample points, 2 pi R included
        double stiffness_Pa = 0;         ///< k
        std::vector<double> corner_h_m;  ///< contact distance of the corners, linear between them
        std::vector<double> h_m;         ///< of the sample points
        double distance_m = 0;           ///< the largest of them
        double range_m = 0;              ///< facets farther than this do not act on its points
    };
    [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
    [[nodiscard]] std::size_t free_count() const {
        return free_count_;
    }  ///< the first entries are those of the actuator
    [[nodiscard]] std::span<const mesh::Index> nodes() const { return nodes_; }
    [[nodiscard]] double distance_m() const { return distance_m_; }  ///< the largest h
    [[nodiscard]] std::size_t dimension() const { return dimension_; }

    [[nodiscard]] bool is_revolved() const { return is_revolved_; }

    /// h - D, at least 0: of a sample point with D to the nearest facet of the actuator that faces it (-1), and for an obstacle with D of the
    /// sample point nearest to it.
    [[nodiscard]] double initial_overlap_m(const Entry& entry, std::size_t q, int obstacle) const;

    [[nodiscard]] Adjacency adjacency(std::size_t i, std::size_t j);

    /// The entries at current positions.
    [[nodiscard]] std::vector<Patch> patches(std::span<const mesh::Point> positions,
                                             std::span<const Vector3> shifts) const;

private:
    void set_contact_distances(double share);
    void add_obstacles(const model::Case& model);
    void find_initial_overlaps();
    void add_overlaps(const Entry& entry, const Entry& other);
    [[nodiscard]] Adjacency find_adjacency(const Entry& a, const Entry& b) const;

    std::map<mesh::CellType, SampleRule> rules_;
    std::vector<Entry> entries_;
    std::vector<mesh::Index> nodes_;
    std::unordered_map<std::uint64_t, Adjacency> adjacency_;                   // of the pairs met so far
    std::map<std::pair<mesh::Facet, std::size_t>, double> initial_overlap_m_;  // of the actuator with itself
    std::vector<double> nearest_m_;  // of each obstacle, infinite beyond the largest h of a faceted one
    std::size_t free_count_ = 0, dimension_ = 3;
    double distance_m_ = 0;
    bool is_revolved_;
};

[[nodiscard]] std::vector<mesh::Index> cell_corners(const mesh::Mesh& mesh, mesh::Index cell);
/// Whether two cells with these corners have a common side: between their facets without a common node lies rubber.
[[nodiscard]] bool share_a_side(std::span<const mesh::Index> corners, std::span<const mesh::Index> others,
                                int dimension);

/// Contact distance of a facet of the actuator.
[[nodiscard]] double contact_distance_m(const ContactSurface::Entry& entry, const surface::FacetPoint& xi);

/// Whether air, not rubber, lies between a sample point and the closest point of another facet in the undeformed state, or they touch there.
[[nodiscard]] bool are_facing(const ContactSurface::Entry& entry, std::size_t q, const Patch& other,
                              const ClosestPoint& closest);

/// Cosine of the angle between the outer normal of the facet, in a given shape, and the opposite of that of another surface; 0 beyond 90 degrees.
[[nodiscard]] double facing_of(const Patch& patch, const ContactSurface::Entry& entry, std::size_t q,
                               const Vector3& normal);
/// Whether the facet, in a given shape, faces a surface with this normal.
[[nodiscard]] bool is_facing(const Patch& patch, const ContactSurface::Entry& entry, std::size_t q,
                             const Vector3& normal);

/// Cone of the normals at the nodes.
[[nodiscard]] NormalCone normals(const Patch& facet);
/// Of the normals at these points, at most `max_normals`.
inline constexpr std::size_t max_normals = 25;
[[nodiscard]] NormalCone normals(const Patch& facet, std::span<const surface::FacetPoint> at);

}  // namespace soft::contact
