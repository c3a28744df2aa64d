#include "contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

#include "contact/closest_point.hpp"
#include "contact/contact_surface.hpp"
#include "contact/crossing.hpp"
#include "contact/hinges.hpp"
#include "contact/inverted_wall.hpp"
#include "contact/prescribed.hpp"
#include "contact/signed_distance.hpp"
#include "mesh/mesh.hpp"
#include "model/location.hpp"
#include "surface/free_facets.hpp"

namespace soft::contact {
namespace {

using mesh::Facet;
using mesh::Point;

/// Of the size of the body: how far points on a symmetry plane are beyond it by rounding.
constexpr double rounding = 1e-12;

enum class Kind { pair, plane, axis, obstacle, wall };

struct Found {
    Kind kind;
    Point location;
    std::array<std::size_t, 2> facets;
    std::size_t obstacle = 0;
    bool is_driven = false;
    bool operator<(const Found& other) const {
        return std::tie(location[0], facets, kind) < std::tie(other.location[0], other.facets, other.kind);
    }
};

/// How far a facet extends beyond a plane or into an obstacle.
struct Depth {
    double depth_m = 0;
    surface::FacetPoint xi{};
};

/// Starts from the deepest point of the subdivision and refines it by a pattern search on the curved facet. `depth_m`: of a point.
template <class F>
Depth deepest(const surface::FacetMap& map, const Division& division, F&& depth_m) {
    const auto depth_at = [&](const surface::FacetPoint& xi) { return depth_m(map(xi).x); };
    Depth best{depth_at(division.xi.front()), division.xi.front()};
    const auto try_point = [&](const surface::FacetPoint& xi) {
        if (const double depth = depth_at(xi); depth > best.depth_m) best = {depth, xi};
    };
    for (const surface::FacetPoint& xi : division.xi) try_point(xi);
    const mesh::Shape shape = mesh::topology(map.type).shape;
    constexpr int halvings = 14;  // final step: 1e-5 of the facet; the error of the depth is of the order of its square
    double step = 0.25;
    for (int round = 0; round < halvings; ++round, step /= 2)
        for (const surface::FacetPoint& move : {surface::FacetPoint{step, 0}, surface::FacetPoint{-step, 0},
                                                surface::FacetPoint{0, step}, surface::FacetPoint{0, -step}})
            if (const surface::FacetPoint next{best.xi[0] + move[0], best.xi[1] + move[1]};
                surface::is_inside(shape, next, 0))
                try_point(next);
    return best;
}

}  // namespace

class ContactFinder::Surface {
public:
    explicit Surface(const model::Case& model)
        : mesh_(model.mesh),
          kinematics_(model.kinematics),
          mirrors_(surface::mirrors(model)),
          free_(surface::free_facets(model)),
          names_(surface::face_names(model)),
          facets_(mesh_, free_),
          undeformed_(facets_.shape(mesh_.points)),
          tolerance_m_(mesh::plane_tolerance * mesh::extent_m(mesh_)),
          rounding_m_(rounding * mesh::extent_m(mesh_)),
          allowed_share_(model.path.contact == model::Contact::solve ? model.contact.distance : 0),
          prescribed_(model) {
        for (std::size_t d = 0; d < 3; ++d) {
            double sum = 0;
            for (const Point& p : mesh_.points) sum += p[d];
            sides_[d] = sum < 0 ? -1 : 1;
        }
        for (const model::Obstacle& obstacle : model.obstacles)
            obstacles_.push_back({obstacle.name, distance_with_gradient(obstacle)});
        exclude_initial_contacts();
    }

    [[nodiscard]] std::vector<Point> current_positions(std::span<const double> displacement_m) const {
        if (displacement_m.size() != 3 * mesh_.points.size())
            throw std::logic_error("ContactFinder: the displacement and the mesh have different numbers of points");
        std::vector<Point> positions = mesh_.points;
        for (std::size_t n = 0; n < positions.size(); ++n)
            for (std::size_t d = 0; d < 3; ++d) positions[n][d] += displacement_m[3 * n + d];
        return positions;
    }

    [[nodiscard]] std::optional<Contact> find(const std::vector<Point>& positions,
                                              std::span<const Vector3> shifts) const {
        if (!shifts.empty() && shifts.size() != obstacles_.size())
            throw std::logic_error("ContactFinder: a displacement for each obstacle, or none");
        std::optional<Found> best;
        const auto keep = [&best](const Found& found) {
            if (!best || found < *best) best = found;
        };
        const DividedShape now = facets_.shape(positions);
        const std::vector<NormalCone> cones = normal_cones(positions);
        for (const auto& [i, j] : surface::overlapping_pairs(now.boxes)) {
            const FacetPair pair{&facets_, static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
            if (pair.are_neighbours() && is_visible_from_one_side(cones[pair.first], cones[pair.second])) continue;
            if (is_initial_contact(i, j) || has_rubber_between(pair)) continue;
            if (const auto xi = crossing(pair, positions, now))
                keep({kind_of(pair, positions), undeformed_location(pair.first, *xi), {pair.first, pair.second}});
        }
        for (const Hinge& hinge : hinges_)
            if (is_closed(hinge, cones, positions)) keep(found_at(hinge));
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (std::size_t d = 0; d < 3; ++d)
                if (mirrors_[d] && initial_depths_m_[d][f] <= tolerance_m_)
                    if (const Depth at = depth(f, d, positions); at.depth_m > rounding_m_ + initial_depths_m_[d][f]) {
                        const bool is_deep = at.depth_m > std::max(tolerance_m_, allowed_depth_m(f));
                        if (is_deep && faces_plane(f, d, at.xi, positions))
                            keep({kind_of(d), undeformed_location(f, at.xi), {f, f}});
                        else if ((is_deep || !begins_at_plane(f, d)) &&
                                 has_inverted_cell(mesh_, std::span{&facets_.facet(f), 1}, positions))
                            keep({Kind::wall, undeformed_location(f, at.xi), {f, f}});
                    }
        for (std::size_t k = 0; allowed_share_ > 0 && k < obstacles_.size(); ++k)
            for (std::size_t f = 0; f < facets_.size(); ++f) {
                const Vector3 shift = shifts.empty() ? Vector3{} : shifts[k];
                const Depth at = depth_in(k, f, positions, now.boxes[f], shift);
                if (at.depth_m > std::max(tolerance_m_, allowed_depth_m(f)))
                    keep({Kind::obstacle,
                          undeformed_location(f, at.xi),
                          {f, f},
                          k,
                          is_driven(k, f, at, shift, positions)});
            }
        return best ? std::optional(contact(*best)) : std::nullopt;
    }

private:
    void exclude_initial_contacts() {
        const std::vector<NormalCone> cones = normal_cones(mesh_.points);
        std::vector<surface::Box> grown = undeformed_.boxes;
        for (surface::Box& box : grown)
            for (std::size_t d = 0; d < 3; ++d) {
                const double margin = coincidence_tolerance * (box.high[d] - box.low[d]) + tolerance_m_;
                box.low[d] -= margin;
                box.high[d] += margin;
            }
        for (const auto& [i, j] : surface::overlapping_pairs(grown)) {
            const FacetPair pair{&facets_, static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
            if (pair.are_neighbours() && is_visible_from_one_side(cones[pair.first], cones[pair.second])) continue;
            if (is_touching(pair, undeformed_)) initial_contacts_.insert({i, j});
        }
        if (allowed_share_ == 0) hinges_ = hinges(mesh_, free_);
        constexpr double closed_slit = 1e-6;  // [rad] below a full turn
        std::erase_if(hinges_, [&](const Hinge& hinge) {
            return filled_angle(mesh_, hinge, mesh_.points) > 2 * std::numbers::pi - closed_slit;
        });
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t f = 0; mirrors_[d] && f < facets_.size(); ++f)
                initial_depths_m_[d].push_back(depth(f, d, mesh_.points).depth_m);
    }

    [[nodiscard]] std::vector<NormalCone> normal_cones(std::span<const Point> positions) const {
        std::vector<NormalCone> cones;
        for (std::size_t f = 0; f < facets_.size(); ++f)
            cones.push_back(
                normals(make_patch(surface::facet_map(mesh_, facets_.facet(f), positions)), facets_.division(f).xi));
        return cones;
    }

    /// Whether the facets are sides of one cell, or of two cells that share a side while the facets share no node: then rubber, not air,
    /// is between them. If such facets intersect, a cell is inverted, which det F <= 0 reports.
    [[nodiscard]] bool has_rubber_between(const FacetPair& pair) const {
        const mesh::Index a = facets_.facet(pair.first).cell, b = facets_.facet(pair.second).cell;
        if (a == b) return true;
        if (pair.are_neighbours()) return false;
        return share_a_side(cell_corners(mesh_, a), cell_corners(mesh_, b), mesh_.dimension);
    }

    /// Where the facets intersect deeper than contact that is solved allows. The fine subdivision separates the two sides of a thin wall.
    /// A fold near the common edge of neighbours is seen in smaller pieces only: of the coarse ones, it closes those that share a point.
    [[nodiscard]] std::optional<surface::FacetPoint> crossing(const FacetPair& pair,
                                                              const std::vector<Point>& positions,
                                                              const DividedShape& now) const {
        const std::array<Facet, 2> both{facets_.facet(pair.first), facets_.facet(pair.second)};
        const auto find_in = [&](Fineness fineness, double least_overlap_m) {
            const DividedFacets divided{mesh_, both, fineness};
            return find_crossing({&divided, 0, 1}, divided.shape(mesh_.points), divided.shape(positions),
                                 least_overlap_m);
        };
        if (find_crossing(pair, undeformed_, now))
            if (const auto xi = find_in(Fineness::fine, 0);
                xi && (kind_of(pair, positions) == Kind::wall || is_deep(pair, positions)))
                return xi;
        if (!pair.are_neighbours()) return std::nullopt;
        const double allowed_m = std::max(allowed_depth_m(pair.first), allowed_depth_m(pair.second));
        return find_in(Fineness::medium, allowed_m) ? find_in(Fineness::fine, 0) : std::nullopt;
    }

    /// A share of the largest distance between nodes of the undeformed facet, which does not depend on its orientation.
    [[nodiscard]] double allowed_depth_m(std::size_t f) const {
        double size_m = 0;
        for (const mesh::Index a : facets_.nodes(f))
            for (const mesh::Index b : facets_.nodes(f))
                size_m = std::max(size_m, norm(difference(mesh_.point(a), mesh_.point(b))));
        return allowed_share_ * size_m;
    }

    /// Whether a point of one facet lies deeper behind the other than contact that is solved allows.
    [[nodiscard]] bool is_deep(const FacetPair& pair, const std::vector<Point>& positions) const {
        if (allowed_share_ == 0) return true;
        const double allowed_m = std::max(allowed_depth_m(pair.first), allowed_depth_m(pair.second));
        const auto reaches_behind = [&](std::size_t a, std::size_t b) {
            const surface::FacetMap map = surface::facet_map(mesh_, facets_.facet(a), positions);
            const Patch other = make_patch(surface::facet_map(mesh_, facets_.facet(b), positions));
            return std::ranges::any_of(divide(map.type, Fineness::fine).xi, [&](const surface::FacetPoint& xi) {
                const Point x = map(xi).x;
                const ClosestPoint closest = closest_point(other, x);
                const auto y = other(closest.xi);
                return closest.is_interior && closest.distance_m > allowed_m &&
                       dot(difference(x, y.x), cross(y.t1, y.t2)) < 0;
            });
        };
        return reaches_behind(pair.first, pair.second) || reaches_behind(pair.second, pair.first);
    }

    [[nodiscard]] Kind kind_of(const FacetPair& pair, const std::vector<Point>& positions) const {
        const std::array<Facet, 2> both{facets_.facet(pair.first), facets_.facet(pair.second)};
        return is_wall_inverted(mesh_, both, positions) ? Kind::wall : Kind::pair;
    }

    /// Whether air is between a facet and the plane that it crosses. If rubber is between them, a cell is inverted. For a facet that
    /// starts at the plane, the normal is evaluated there, because it may reverse further along the facet.
    [[nodiscard]] bool faces_plane(std::size_t f, std::size_t d, const surface::FacetPoint& deepest,
                                   const std::vector<Point>& positions) const {
        const auto distance = [&](const surface::FacetPoint& xi) {
            return std::hypot(xi[0] - deepest[0], xi[1] - deepest[1]);
        };
        const surface::FacetMap before = surface::facet_map(mesh_, facets_.facet(f), mesh_.points);
        std::optional<surface::FacetPoint> begin;
        for (const surface::FacetPoint& xi : facets_.division(f).xi)
            if (std::abs(before(xi).x[d]) <= tolerance_m_ && (!begin || distance(xi) < distance(*begin))) begin = xi;
        const surface::FacetMap::Value at =
            surface::facet_map(mesh_, facets_.facet(f), positions)(begin.value_or(deepest));
        return sides_[d] * cross(at.t1, at.t2)[d] < 0;
    }

    /// A crease closes at the plane with an angle of pi in the corner of its cell, where det F vanishes.
    [[nodiscard]] bool begins_at_plane(std::size_t f, std::size_t d) const {
        return std::ranges::any_of(facets_.nodes(f),
                                   [&](mesh::Index node) { return std::abs(mesh_.point(node)[d]) <= tolerance_m_; });
    }

    [[nodiscard]] bool is_initial_contact(int i, int j) const { return initial_contacts_.contains({i, j}); }

    /// Just past a full turn the walls face each other; for all other hinges the cells need not be evaluated.
    [[nodiscard]] bool is_closed(const Hinge& hinge, const std::vector<NormalCone>& cones,
                                 const std::vector<Point>& positions) const {
        constexpr double facing = -0.5;
        const auto &a = cones[static_cast<std::size_t>(hinge.facets[0])],
                   &b = cones[static_cast<std::size_t>(hinge.facets[1])];
        if (std::cos(std::min(std::acos(std::clamp(dot(a.axis, b.axis), -1.0, 1.0)) + a.angle + b.angle,
                              std::numbers::pi)) > facing)
            return false;
        return filled_angle(mesh_, hinge, positions) > 2 * std::numbers::pi;
    }

    [[nodiscard]] Found found_at(const Hinge& hinge) const {
        Point location{};
        for (const mesh::Index end : hinge.vertices)
            for (std::size_t d = 0; d < 3; ++d) location[d] += mesh_.point(end)[d] / 2;
        return {Kind::pair,
                location,
                {static_cast<std::size_t>(hinge.facets[0]), static_cast<std::size_t>(hinge.facets[1])}};
    }

    /// Skips the search if the nodal positions exclude that the curved facet reaches the plane: a parabola through three values
    /// exceeds their range by at most 1/8 of it, a second-order facet in two directions by less than half.
    [[nodiscard]] Depth depth(std::size_t f, std::size_t d, std::span<const Point> positions) const {
        surface::FacetMap map{facets_.type(f), {}};
        double least = std::numeric_limits<double>::infinity(), largest = -least;
        std::size_t a = 0;
        for (const mesh::Index node : facets_.nodes(f)) {
            map.nodes[a] = positions[static_cast<std::size_t>(node)];
            const double height = sides_[d] * map.nodes[a++][d];
            least = std::min(least, height);
            largest = std::max(largest, height);
        }
        if (least > 0.5 * (largest - least)) return {};
        return deepest(map, facets_.division(f), [&](const Point& x) { return -sides_[d] * x[d]; });
    }

    /// In an obstacle that has moved by `shift`; 0 for a facet that is far outside.
    [[nodiscard]] Depth depth_in(std::size_t k, std::size_t f, std::span<const Point> positions,
                                 const surface::Box& box, const Vector3& shift) const {
        const auto depth_m = [&](const Point& x) { return -obstacles_[k].distance(difference(x, shift)).value_m; };
        Point centre{};
        for (std::size_t d = 0; d < 3; ++d) centre[d] = 0.5 * (box.low[d] + box.high[d]);
        if (-depth_m(centre) > norm(difference(box.high, box.low))) return {};
        return deepest(surface::facet_map(mesh_, facets_.facet(f), positions), facets_.division(f), depth_m);
    }

    [[nodiscard]] bool is_driven(std::size_t k, std::size_t f, const Depth& at, const Vector3& shift,
                                 std::span<const Point> positions) const {
        const Point x = surface::facet_map(mesh_, facets_.facet(f), positions)(at.xi).x;
        return prescribed_.hold(mesh_, facets_.facet(f), at.xi, obstacles_[k].distance(difference(x, shift)).gradient);
    }

    [[nodiscard]] Kind kind_of(std::size_t d) const {
        return kinematics_ == model::Kinematics::axisymmetric && d == 1 ? Kind::axis : Kind::plane;
    }

    [[nodiscard]] Point undeformed_location(std::size_t f, const surface::FacetPoint& xi) const {
        Point location = surface::facet_map(mesh_, facets_.facet(f), mesh_.points)(xi).x;
        for (double& coordinate : location)
            if (std::abs(coordinate) <= tolerance_m_) coordinate = 0;  // on a plane: do not print rounding errors
        return location;
    }

    [[nodiscard]] Contact contact(const Found& found) const {
        Contact result{found.location,
                       {facets_.facet(found.facets[0]), facets_.facet(found.facets[1])},
                       found.kind == Kind::wall,
                       found.is_driven,
                       {}};
        const auto name = [&](int which) {
            const auto at = names_.find(result.facets[static_cast<std::size_t>(which)]);
            return at == names_.end() ? std::string{} : at->second;
        };
        const std::string first = name(0), second = name(1);
        const std::string face = first.empty() ? "an unnamed face" : "the face " + first;
        const std::string other = second.empty() ? "an unnamed face" : "the face " + second;
        if (found.kind == Kind::axis)
            result.text = face + " touches the axis";
        else if (found.kind == Kind::plane)
            result.text = face + " touches its mirror image";
        else if (found.kind == Kind::obstacle)
            result.text = face + (found.is_driven ? ", whose displacement is prescribed, meets" : " touches") +
                          " the obstacle '" + obstacles_[found.obstacle].name + "'";
        else if (found.kind == Kind::wall && found.facets[0] == found.facets[1])
            result.text = "the wall between " + face + " and its mirror image is inverted";
        else if (found.kind == Kind::wall)
            result.text = "the wall between " + face + " and " + other + " is inverted";
        else if (first == second)
            result.text = face + " touches itself";
        else if (first.empty() || second.empty())
            result.text = face + " and " + other + " touch";
        else
            result.text = "the faces " + first + " and " + second + " touch";
        result.text += " at " + model::location_text(kinematics_, found.location) + " of the undeformed part";
        return result;
    }

    mesh::Mesh mesh_;
    model::Kinematics kinematics_;
    std::array<bool, 3> mirrors_;
    std::vector<Facet> free_;
    std::map<Facet, std::string> names_;
    DividedFacets facets_;
    DividedShape undeformed_;
    double tolerance_m_, rounding_m_;
    double allowed_share_;                           ///< of the size of a facet, by which walls may overlap
    std::array<double, 3> sides_{};                  ///< side of each mirror plane on which the body lies, +1 or -1
    std::set<std::array<int, 2>> initial_contacts_;  ///< pairs of facets that touch in the undeformed body
    std::array<std::vector<double>, 3>
        initial_depths_m_;       ///< of each facet beyond each mirror plane in the undeformed body
    std::vector<Hinge> hinges_;  ///< none where contact is solved
    struct Obstacle {
        std::string name;
        std::function<Distance(const Point&)> distance;
    };
    std::vector<Obstacle> obstacles_;
    PrescribedNodes prescribed_;
};

ContactFinder::ContactFinder(const model::Case& model) : surface_(std::make_unique<Surface>(model)) {}
ContactFinder::~ContactFinder() = default;
ContactFinder::ContactFinder(ContactFinder&&) noexcept = default;
ContactFinder& ContactFinder::operator=(ContactFinder&&) noexcept = default;

std::optional<Contact> ContactFinder::find(std::span<const double> displacement_m,
                                           std::span<const Vector3> shifts) const {
    return surface_->find(surface_->current_positions(displacement_m), shifts);
}

}  // namespace soft::contact
