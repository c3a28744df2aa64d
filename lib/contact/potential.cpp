#include "contact/potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/crossing.hpp"
#include "contact/facet_contact.hpp"
#include "surface/free_facets.hpp"

namespace soft::contact {

namespace {

using mesh::Point;

/// An iterate may go this deep behind a facet (fraction of its size).
constexpr double deepest_in_sizes = 0.15, least_step_in_sizes = 0.03;

}  // namespace

namespace {

/// A configuration in which nothing touches, nor in any other one whose points have moved by less than half the clearance.
struct Apart {
    std::vector<Point> positions;  // of the nodes of the surface
    std::vector<Vector3> shifts;
    double clearance_m;
};

/// Neighbouring facets whose normal cones are this far from facing each other do not fold while they move by a fraction of their size.
constexpr double safe_angle = 1.0;

}  // namespace

class Potential::Parts {
public:
    Parts(const model::Case& model, std::span<const double> modulus_Pa)
        : surface(model, modulus_Pa),
          self(model.contact.self && model.path.contact == model::Contact::solve),
          obstacles(model.obstacles.size()) {
        for (std::size_t k = 0; k < obstacles; ++k)
            std::visit(
                [&](const auto& shape) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(shape)>, model::FacetedSurface>)
                        smooth.push_back({static_cast<int>(k), [shape](const Point& x) { return distance(shape, x); }});
                },
                model.obstacles[k].shape);
        const auto mirrors = surface::mirrors(model);
        for (std::size_t d = 0; self && d < 3; ++d) {
            if (!mirrors[d]) continue;
            double sum = 0;
            for (const Point& p : model.mesh.points) sum += p[d];
            model::Plane plane;
            plane.normal[d] = sum < 0 ? -1 : 1;
            smooth.push_back({-1, [plane](const Point& x) { return distance(plane, x); }});
        }
    }

    /// `fold`: set where two neighbours are close to folding onto each other.
    [[nodiscard]] std::vector<std::vector<std::size_t>> find_others(const ContactSurface::Shape& shape,
                                                                    bool* fold = nullptr) {
        std::vector<std::vector<std::size_t>> others(surface.free_count());
        std::map<std::size_t, NormalCone> cones;
        const auto cone = [&](std::size_t i) {
            auto known = cones.find(i);
            if (known == cones.end()) known = cones.emplace(i, normals(shape.patches[i])).first;
            return known->second;
        };
        for (const auto& [first, second] : surface::overlapping_pairs(shape.boxes)) {
            const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
            if (i >= surface.free_count()) continue;
            if (j < surface.free_count()) {
                if (!self) continue;
                const Adjacency kind = surface.adjacency(i, j);
                if (kind == Adjacency::sides_of_a_wall) continue;
                if (kind == Adjacency::neighbours) {
                    NormalCone wider = cone(i);
                    if (is_visible_from_one_side(wider, cone(j))) {
                        wider.angle += safe_angle;
                        if (fold != nullptr && !is_visible_from_one_side(wider, cone(j))) *fold = true;
                        continue;
                    }
                    if (fold != nullptr) *fold = true;
                }
                others[j].push_back(i);
            }
            others[i].push_back(j);
        }
        return others;
    }

    [[nodiscard]] double share_without_crossing(ContactSurface::Shape from, std::span<const Vector3> shifts,
                                                const ContactSurface::Shape& to, std::span<const Vector3> shifts_to);

    /// The largest distance by which a node or obstacle has moved since a configuration.
    [[nodiscard]] double moved_m(const Apart& since, std::span<const Point> positions,
                                 std::span<const Vector3> shifts) const {
        double largest = 0;
        for (std::size_t k = 0; k < surface.nodes().size(); ++k)
            largest = std::max(
                largest, norm(difference(positions[static_cast<std::size_t>(surface.nodes()[k])], since.positions[k])));
        for (std::size_t k = 0; k < shifts.size(); ++k)
            largest = std::max(largest, norm(difference(shifts[k], since.shifts[k])));
        return largest;
    }

    ContactSurface surface;
    std::optional<Apart> apart;  ///< the last evaluation, if nothing touched
    bool self;
    std::size_t obstacles;
    std::vector<SmoothObstacle> smooth;
};

double Potential::Parts::share_without_crossing(ContactSurface::Shape from, std::span<const Vector3> shifts,
                                                const ContactSurface::Shape& to, std::span<const Vector3> shifts_to) {
    for (std::size_t i = 0; i < from.boxes.size(); ++i)
        for (std::size_t d = 0; d < 3; ++d) {
            from.boxes[i].low[d] = std::min(from.boxes[i].low[d], to.boxes[i].low[d]);
            from.boxes[i].high[d] = std::max(from.boxes[i].high[d], to.boxes[i].high[d]);
        }
    const auto others = find_others(from);
    double share = 1;
    const auto limit = [&](double distance, double approach, double size) {
        if (approach > distance + deepest_in_sizes * size)
            share =
                std::min(share, std::max(distance + deepest_in_sizes * size, least_step_in_sizes * size) / approach);
    };
    std::vector<double> deformation;  // largest motion of a node relative to the facet's centre
    for (std::size_t i = 0; i < from.patches.size(); ++i) {
        const Patch &before = from.patches[i], &after = to.patches[i];
        deformation.push_back(0);
        for (std::size_t a = 0; a < surface.entries()[i].nodes.size(); ++a)
            deformation.back() = std::max(
                deformation.back(),
                norm(difference(difference(after.nodes[a], before.nodes[a]), difference(after.centre, before.centre))));
    }
    const auto size_of = [&](std::size_t i, std::size_t j) {
        const auto &entry = surface.entries()[i], &other = surface.entries()[j];
        return other.obstacle < 0 ? std::min(other.size_m, entry.size_m) : entry.size_m;
    };
    /// Whether no point of one facet can go deep behind the other.
    const auto stay_apart = [&](std::size_t i, std::size_t j) {
        const Patch &a = from.patches[i], &b = from.patches[j];
        const Vector3 moved =
            difference(difference(to.patches[i].centre, a.centre), difference(to.patches[j].centre, b.centre));
        const double gap = norm(difference(a.centre, b.centre)) - a.radius_m - b.radius_m, size = size_of(i, j);
        return norm(moved) + deformation[i] + deformation[j] < std::max(gap, 0.0) + deepest_in_sizes * size;
    };
    for (std::size_t i = 0; i < surface.free_count(); ++i) {
        const auto& entry = surface.entries()[i];
        std::vector<std::size_t> near;
        for (const std::size_t j : others[i])
            if (!stay_apart(i, j)) near.push_back(j);
        if (near.empty() && smooth.empty()) continue;
        for (std::size_t q = 0; q < entry.X.size(); ++q) {
            const Point x = from.patches[i](entry.rule->xi[q]).x, next = to.patches[i](entry.rule->xi[q]).x;
            for (const std::size_t j : near) {
                const auto& other = surface.entries()[j];
                const Vector3 moved = difference(to.patches[j].centre, from.patches[j].centre);
                if (at_least(from.patches[j], x) >
                    norm(difference(difference(next, x), moved)) + from.patches[j].radius_m)
                    continue;
                const ClosestPoint closest = closest_point(from.patches[j], x);
                const auto y = from.patches[j](closest.xi);
                const Vector3 r = difference(x, y.x), n = cross(y.t1, y.t2);
                if (dot(r, n) < 0 && !closest.is_interior) continue;
                const double behind = dot(r, n) < 0 ? -1 : 1;
                if (closest.distance_m == 0) continue;
                if (behind < 0) {
                    const ClosestPoint before = closest_point(other.undeformed, entry.X[q]);
                    const bool overlaps = closest.distance_m < overlap_share_of_distance * before.distance_m &&
                                          is_facing(from.patches[i], entry, q, n);
                    if (!overlaps && !are_facing(entry, q, other.undeformed, before)) continue;
                }
                const Vector3 relative = difference(difference(next, x), difference(to.patches[j](closest.xi).x, y.x));
                limit(behind * closest.distance_m, -behind * dot(relative, r) / closest.distance_m, size_of(i, j));
            }
            for (const SmoothObstacle& obstacle : smooth) {
                const bool mirror = obstacle.index < 0;
                const auto k = static_cast<std::size_t>(std::max(obstacle.index, 0));
                const double before = obstacle.distance(mirror ? x : along(x, -1, shifts[k])).value_m,
                             after = obstacle.distance(mirror ? next : along(next, -1, shifts_to[k])).value_m;
                if (after < 0) limit(before, before - after, entry.size_m);
            }
        }
    }
    return share;
}

Potential::Potential(const model::Case& model, std::span<const double> modulus_Pa)
    : parts_(std::make_unique<Parts>(model, modulus_Pa)) {}
Potential::~Potential() = default;
Potential::Potential(Potential&&) noexcept = default;

bool Potential::is_empty() const {
    return parts_->surface.free_count() == 0 || (!parts_->self && parts_->obstacles == 0);
}
double Potential::distance_m() const { return parts_->surface.distance_m(); }
double Potential::harmless_step_m() const {
    double smallest = std::numeric_limits<double>::max();
    for (const auto& entry : parts_->surface.entries().first(parts_->surface.free_count()))
        smallest = std::min(smallest, entry.size_m);
    return deepest_in_sizes * smallest;
}
std::span<const mesh::Index> Potential::nodes() const { return parts_->surface.nodes(); }

Summary Potential::evaluate(std::span<const Point> positions, std::span<const Vector3> shifts, Wanted wanted,
                            const std::function<bool(mesh::Index)>& take,
                            const std::function<void(const Block&)>& add) {
    Summary summary;
    summary.area_m2.assign(parts_->obstacles + 1, 0);
    summary.pressure_Pa.assign(parts_->obstacles + 1, 0);
    if (is_empty()) return summary;
    if (parts_->apart && 2 * parts_->moved_m(*parts_->apart, positions, shifts) < parts_->apart->clearance_m)
        return summary;
    parts_->apart.reset();
    const auto shape = parts_->surface.shape(positions, shifts);
    bool fold = false;
    const auto others = parts_->find_others(shape, &fold);
    const ContactState at{parts_->surface, shape, parts_->smooth, shifts, wanted};
    double clearance_m = shape.margin_m;
    for (std::size_t i = 0; i < parts_->surface.free_count(); ++i) {
        if (!take(parts_->surface.entries()[i].facet.cell)) continue;
        FacetContact facet(at, i, others[i], summary);
        facet.add(add);
        clearance_m = std::min(clearance_m, facet.clearance_m());
    }
    if (fold || clearance_m <= 0) return summary;
    parts_->apart = Apart{{}, {shifts.begin(), shifts.end()}, clearance_m};
    for (const auto node : parts_->surface.nodes())
        parts_->apart->positions.push_back(positions[static_cast<std::size_t>(node)]);
    return summary;
}

double Potential::share_without_crossing(std::span<const Point> from, std::span<const Vector3> shifts,
                                         std::span<const Point> to, std::span<const Vector3> shifts_to) {
    const auto& apart = parts_->apart;
    if (apart && 2 * std::max(parts_->moved_m(*apart, from, shifts), parts_->moved_m(*apart, to, shifts_to)) <
                     apart->clearance_m)
        return 1;
    return parts_->share_without_crossing(parts_->surface.shape(from, shifts), shifts,
                                          parts_->surface.shape(to, shifts_to), shifts_to);
}

std::vector<std::array<mesh::Facet, 2>> Potential::near_pairs(std::span<const Point> positions, double share) {
    std::vector<std::array<mesh::Facet, 2>> pairs;
    if (!parts_->self) return pairs;
    const std::vector<Vector3> shifts(parts_->obstacles);
    auto shape = parts_->surface.shape(positions, shifts);
    const auto entries = parts_->surface.entries();
    const std::size_t count = parts_->surface.free_count();
    shape.boxes.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t d = 0; d < 3; ++d) {
            shape.boxes[i].low[d] -= share * entries[i].size_m;
            shape.boxes[i].high[d] += share * entries[i].size_m;
        }
    const auto is_close = [&](std::size_t i, std::size_t j) {
        const double within_m =
            std::max(entries[i].distance_m, share * std::max(entries[i].size_m, entries[j].size_m));
        return std::ranges::any_of(entries[i].rule->xi, [&](const surface::FacetPoint& xi) {
            const Point x = shape.patches[i](xi).x;
            return at_least(shape.patches[j], x) < within_m && closest_point(shape.patches[j], x).distance_m < within_m;
        });
    };
    const auto others = parts_->find_others(shape);
    for (std::size_t i = 0; i < count; ++i)
        for (const std::size_t j : others[i])
            if (i < j && (is_close(i, j) || is_close(j, i))) pairs.push_back({entries[i].facet, entries[j].facet});
    return pairs;
}

}  // namespace soft::contact
