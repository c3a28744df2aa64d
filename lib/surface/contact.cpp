#include "surface/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

#include "model/cavity_surface.hpp"
#include "model/location.hpp"
#include "surface/crossing.hpp"
#include "surface/free_facets.hpp"
#include "surface/hinges.hpp"
#include "surface/inside_out.hpp"

namespace soft::surface {
namespace {

using mesh::Facet;
using mesh::Point;

enum class Kind { pair, plane, axis, wall };

struct Found {
    Kind kind;
    Point place;
    std::array<std::size_t, 2> facets;
    bool operator<(const Found& other) const {
        return std::tie(place[0], facets, kind) < std::tie(other.place[0], other.facets, other.kind);
    }
};

/// Names for messages: a cavity's wall before other faces, these by the alphabet.
std::map<Facet, std::string> face_names(const model::Case& model) {
    std::map<Facet, std::string> names;
    for (const model::Cavity& cavity : model.cavities)
        if (const auto wall = model.mesh.facet_sets.find(cavity.wall); wall != model.mesh.facet_sets.end())
            for (const Facet& facet : wall->second) names.emplace(facet, cavity.wall);
    for (const auto& [name, facets] : model.mesh.facet_sets)
        for (const Facet& facet : facets) names.emplace(facet, name);
    return names;
}

/// How far a facet is beyond the plane where coordinate d is zero; `side`: +1 or -1, where the body is.
struct Depth {
    double depth_m = 0;
    FacetPoint xi{};
};

/// The deepest of the division's points, then shrinking steps on the curved facet.
Depth deepest(const FacetMap& map, const Division& division, std::size_t d, double side) {
    const auto depth_at = [&](const FacetPoint& xi) { return -side * map(xi).x[d]; };
    Depth best{depth_at(division.xi.front()), division.xi.front()};
    const auto try_point = [&](const FacetPoint& xi) {
        if (const double depth = depth_at(xi); depth > best.depth_m) best = {depth, xi};
    };
    for (const FacetPoint& xi : division.xi) try_point(xi);
    const mesh::Shape shape = mesh::topology(map.type).shape;
    constexpr int halvings = 14;  // a step of 1e-5 of the facet, whose depth differs by its square
    double step = 0.25;
    for (int round = 0; round < halvings; ++round, step /= 2)
        for (const FacetPoint& move :
             {FacetPoint{step, 0}, FacetPoint{-step, 0}, FacetPoint{0, step}, FacetPoint{0, -step}})
            if (const FacetPoint next{best.xi[0] + move[0], best.xi[1] + move[1]}; inside(shape, next, 0))
                try_point(next);
    return best;
}

}  // namespace

class ContactFinder::Surface {
public:
    explicit Surface(const model::Case& model)
        : mesh_(model.mesh),
          kinematics_(model.kinematics),
          mirrors_(mirrors(model)),
          free_(free_facets(model)),
          names_(face_names(model)),
          facets_(mesh_, free_),
          undeformed_(facets_.shape(mesh_.points)),
          tolerance_m_(model::plane_tolerance * model::extent_m(mesh_)) {
        for (std::size_t d = 0; d < 3; ++d) {
            double sum = 0;
            for (const Point& p : mesh_.points) sum += p[d];
            sides_[d] = sum < 0 ? -1 : 1;
        }
        leave_out_what_touches();
    }

    [[nodiscard]] std::vector<Point> moved(std::span<const double> displacement_m) const {
        if (displacement_m.size() != 3 * mesh_.points.size())
            throw std::logic_error("ContactFinder: the displacement has another number of points than the mesh");
        std::vector<Point> positions = mesh_.points;
        for (std::size_t n = 0; n < positions.size(); ++n)
            for (std::size_t d = 0; d < 3; ++d) positions[n][d] += displacement_m[3 * n + d];
        return positions;
    }

    [[nodiscard]] std::optional<Contact> find(const std::vector<Point>& positions) const {
        std::optional<Found> best;
        const auto keep = [&best](const Found& found) {
            if (!best || found < *best) best = found;
        };
        const DividedShape now = facets_.shape(positions);
        const std::vector<NormalCone> cones = normal_cones(now);
        for (const auto& [i, j] : overlapping(now.boxes)) {
            const FacetPair pair{&facets_, static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
            if (pair.neighbours() && seen_from_one_side(cones[pair.first], cones[pair.second])) continue;
            if (left_out(i, j) || rubber_between(pair)) continue;
            const auto xi = crossing(pair, undeformed_, now);
            if (xi && stays(pair, positions))
                keep({kind_of(pair, positions), undeformed_place(pair.first, *xi), {pair.first, pair.second}});
        }
        for (const Hinge& hinge : hinges_)
            if (closed(hinge, cones, positions)) keep(found_at(hinge));
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (std::size_t d = 0; d < 3; ++d)
                if (mirrors_[d] && !passes_[d].contains(f))
                    if (const Depth at = depth(f, d, positions);
                        at.depth_m > tolerance_m_ && faces_plane(f, d, at.xi, positions))
                        keep({kind_of(d), undeformed_place(f, at.xi), {f, f}});
        return best ? std::optional(contact(*best)) : std::nullopt;
    }

private:
    void leave_out_what_touches() {
        const std::vector<NormalCone> cones = normal_cones(undeformed_);
        std::vector<Box> grown = undeformed_.boxes;
        for (Box& box : grown)
            for (std::size_t d = 0; d < 3; ++d) {
                const double margin = same_place * (box.high[d] - box.low[d]) + tolerance_m_;
                box.low[d] -= margin;
                box.high[d] += margin;
            }
        for (const auto& [i, j] : overlapping(grown)) {
            const FacetPair pair{&facets_, static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
            if (pair.neighbours() && seen_from_one_side(cones[pair.first], cones[pair.second])) continue;
            if (touching(pair, undeformed_)) left_out_.insert({i, j});
        }
        hinges_ = hinges(mesh_, free_);
        constexpr double closed_slit = 1e-6;  // [rad] from a full turn
        std::erase_if(hinges_, [&](const Hinge& hinge) {
            return filled_angle(mesh_, hinge, mesh_.points) > 2 * std::numbers::pi - closed_slit;
        });
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (std::size_t d = 0; d < 3; ++d)
                if (mirrors_[d] && depth(f, d, mesh_.points).depth_m > tolerance_m_) passes_[d].insert(f);
    }

    [[nodiscard]] std::vector<NormalCone> normal_cones(const DividedShape& shape) const {
        std::vector<NormalCone> cones;
        for (std::size_t f = 0; f < facets_.size(); ++f) cones.push_back(facets_.normals(shape, f));
        return cones;
    }

    /// Sides of one cell, or of two that hang together by a side while the facets have no node in common: between them is rubber,
    /// not air. Where they cross, a cell is inside out, which det F tells.
    [[nodiscard]] bool rubber_between(const FacetPair& pair) const {
        const mesh::Index a = facets_.facet(pair.first).cell, b = facets_.facet(pair.second).cell;
        if (a == b) return true;
        if (pair.neighbours()) return false;
        const auto corners = [&](mesh::Index cell) {
            return mesh_.cell_nodes(cell).first(
                static_cast<std::size_t>(mesh::topology(mesh_.cell_type(cell)).vertex_count));
        };
        const auto theirs = corners(b);
        return std::ranges::count_if(corners(a), [&](mesh::Index node) {
                   return std::ranges::find(theirs, node) != theirs.end();
               }) >= mesh_.dimension;
    }

    /// Whether the facets cross as well where their pieces are so fine that the two sides of a thin wall keep apart.
    [[nodiscard]] bool stays(const FacetPair& pair, const std::vector<Point>& positions) const {
        const std::array<Facet, 2> both{facets_.facet(pair.first), facets_.facet(pair.second)};
        const DividedFacets fine{mesh_, both, Fineness::fine};
        return crossing({&fine, 0, 1}, fine.shape(mesh_.points), fine.shape(positions)).has_value();
    }

    [[nodiscard]] Kind kind_of(const FacetPair& pair, const std::vector<Point>& positions) const {
        const std::array<Facet, 2> both{facets_.facet(pair.first), facets_.facet(pair.second)};
        return wall_is_inside_out(mesh_, both, positions) ? Kind::wall : Kind::pair;
    }

    /// Whether the air is between a facet and the plane that it passes. Where it is the rubber, a cell is inside out. A facet that
    /// begins at the plane is looked at there: further on it may have turned round.
    [[nodiscard]] bool faces_plane(std::size_t f, std::size_t d, const FacetPoint& deepest,
                                   const std::vector<Point>& positions) const {
        const auto distance = [&](const FacetPoint& xi) { return std::hypot(xi[0] - deepest[0], xi[1] - deepest[1]); };
        const FacetMap before = facet_map(mesh_, facets_.facet(f), mesh_.points);
        std::optional<FacetPoint> begin;
        for (const FacetPoint& xi : facets_.division(f).xi)
            if (std::abs(before(xi).x[d]) <= tolerance_m_ && (!begin || distance(xi) < distance(*begin))) begin = xi;
        const FacetMap::Value at = facet_map(mesh_, facets_.facet(f), positions)(begin.value_or(deepest));
        return sides_[d] * cross(at.t1, at.t2)[d] < 0;
    }

    [[nodiscard]] bool left_out(int i, int j) const { return left_out_.contains({i, j}); }

    /// Just past a full turn the walls face each other; all other hinges are spared the look at their cells.
    [[nodiscard]] bool closed(const Hinge& hinge, const std::vector<NormalCone>& cones,
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
        Point place{};
        for (const mesh::Index end : hinge.vertices)
            for (std::size_t d = 0; d < 3; ++d) place[d] += mesh_.point(end)[d] / 2;
        return {
            Kind::pair, place, {static_cast<std::size_t>(hinge.facets[0]), static_cast<std::size_t>(hinge.facets[1])}};
    }

    /// Not looked at closely where the nodes say that the curved facet cannot reach the plane: a parabola through three values
    /// goes beyond them by at most 1/8 of their range, a side (both ways, or a triangle's) by less than half.
    [[nodiscard]] Depth depth(std::size_t f, std::size_t d, std::span<const Point> positions) const {
        FacetMap map{facets_.type(f), {}};
        double least = std::numeric_limits<double>::infinity(), largest = -least;
        std::size_t a = 0;
        for (const mesh::Index node : facets_.nodes(f)) {
            map.nodes[a] = positions[static_cast<std::size_t>(node)];
            const double height = sides_[d] * map.nodes[a++][d];
            least = std::min(least, height);
            largest = std::max(largest, height);
        }
        if (least > 0.5 * (largest - least)) return {};
        return deepest(map, facets_.division(f), d, sides_[d]);
    }

    [[nodiscard]] Kind kind_of(std::size_t d) const {
        return kinematics_ == model::Kinematics::axisymmetric && d == 1 ? Kind::axis : Kind::plane;
    }

    [[nodiscard]] Point undeformed_place(std::size_t f, const FacetPoint& xi) const {
        Point place = facet_map(mesh_, facets_.facet(f), mesh_.points)(xi).x;
        for (double& coordinate : place)
            if (std::abs(coordinate) <= tolerance_m_) coordinate = 0;  // on a plane: rounding is no news
        return place;
    }

    [[nodiscard]] Contact contact(const Found& found) const {
        Contact result{found.place,
                       {facets_.facet(found.facets[0]), facets_.facet(found.facets[1])},
                       found.kind == Kind::wall,
                       {}};
        const auto name = [&](int which) {
            const auto at = names_.find(result.facets[static_cast<std::size_t>(which)]);
            return at == names_.end() ? std::string{} : at->second;
        };
        const std::string first = name(0), second = name(1);
        const std::string face = first.empty() ? "a face without name" : "the face " + first;
        const std::string other = second.empty() ? "a face without name" : "the face " + second;
        if (found.kind == Kind::axis)
            result.text = face + " touches the axis";
        else if (found.kind == Kind::plane)
            result.text = face + " touches its mirror image";
        else if (found.kind == Kind::wall)
            result.text = "the wall between " + face + " and " + other + " is inside out";
        else if (first == second)
            result.text = face + " touches itself";
        else if (first.empty() || second.empty())
            result.text = face + " and " + other + " touch";
        else
            result.text = "the faces " + first + " and " + second + " touch";
        result.text += " at " + model::location_text(kinematics_, found.place) + " of the undeformed part";
        return result;
    }

    mesh::Mesh mesh_;
    model::Kinematics kinematics_;
    std::array<bool, 3> mirrors_;
    std::vector<Facet> free_;
    std::map<Facet, std::string> names_;
    DividedFacets facets_;
    DividedShape undeformed_;
    double tolerance_m_;
    std::array<double, 3> sides_{};                ///< of the mirrors
    std::set<std::array<int, 2>> left_out_;        ///< pairs of facets that touch in the undeformed body
    std::array<std::set<std::size_t>, 3> passes_;  ///< facets beyond each mirror in the undeformed body
    std::vector<Hinge> hinges_;
};

ContactFinder::ContactFinder(const model::Case& model) : surface_(std::make_unique<Surface>(model)) {}
ContactFinder::~ContactFinder() = default;
ContactFinder::ContactFinder(ContactFinder&&) noexcept = default;
ContactFinder& ContactFinder::operator=(ContactFinder&&) noexcept = default;

std::optional<Contact> ContactFinder::find(std::span<const double> displacement_m) const {
    return surface_->find(surface_->moved(displacement_m));
}

}  // namespace soft::surface
