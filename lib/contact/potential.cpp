#include "contact/potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/candidates.hpp"
#include "contact/facet_contact.hpp"
#include "contact/friction.hpp"
#include "contact/rest.hpp"
#include "contact/separation.hpp"
#include "contact/signed_distance.hpp"
#include "contact/sweep.hpp"
#include "surface/free_facets.hpp"

namespace soft::contact {

namespace {

using mesh::Point;

/// An iterate may go this deep behind a facet (fraction of its size).
constexpr double deepest_in_sizes = 0.15, least_step_in_sizes = 0.03;
/// And to the middle of a thin obstacle; but always by this fraction of the contact distance.
constexpr double least_step_in_distances = 0.05;

/// The share of an approach to a surface that leaves an iterate at most so deep behind it.
double share_of_approach(double distance_m, double approach_m, double size_m) {
    const double far_m = distance_m + deepest_in_sizes * size_m;
    return approach_m > far_m ? std::max(far_m, least_step_in_sizes * size_m) / approach_m : 1;
}

/// The same of the way of a sample point past an obstacle, relative to which it moves. Where it would leave the obstacle again, or end on
/// another side of it: up to the entry, or half of the depth that it would reach.
double share_outside(const ObstacleDistance& obstacle, const ContactSurface::Entry& entry, std::size_t q,
                     const Point& from, const Point& to) {
    const double before = obstacle.distance(from).value_m, after = obstacle.distance(to).value_m,
                 way = norm(difference(to, from));
    if (before + after >= way) return 1;
    const Sweep past =
        obstacle.index < 0 ? Sweep{} : sweep(obstacle.distance, from, to);  // a mirror plane has one side
    const double share = after < 0 && !past.to_other_side ? share_of_approach(before, before - after, entry.size_m) : 1;
    const double least = least_step_in_distances * entry.h_m[q];
    const bool passes = past.leaves && before > 0 && past.deepest_m > least;
    if (!passes && !past.to_other_side) return share;
    const double into_it = std::min(least_step_in_sizes * entry.size_m, 0.5 * (past.deepest_m + std::min(before, 0.0)));
    return std::min(share, past.entry + std::max(into_it, least) / way);
}

/// Largest motion of a point of a facet relative to its centre.
double turning_m(const Patch& from, const Patch& to) {
    const Vector3 moved = difference(to.centre, from.centre);
    double largest = 0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(mesh::node_count(from.type)); ++a)
        largest = std::max(largest, norm(difference(difference(to.nodes[a], from.nodes[a]), moved)));
    return of_nodal_motion * largest;
}

}  // namespace

class Potential::Parts {
public:
    Parts(const model::Case& model, std::span<const double> modulus_Pa)
        : surface(model, modulus_Pa),
          self(has_self_contact(model)),
          candidates(surface, self),
          separations(surface.entries().size()),
          separations_at_rest(surface.entries().size()),
          obstacles(model.obstacles.size()),
          friction(surface, coefficients(model, self)) {
        for (std::size_t k = 0; k < obstacles; ++k) {
            const bool is_faceted = std::holds_alternative<model::FacetedSurface>(model.obstacles[k].shape);
            has_thin_obstacles =
                has_thin_obstacles || is_faceted || std::holds_alternative<model::Box>(model.obstacles[k].shape);
            (is_faceted ? faceted : smooth)
                .push_back({static_cast<int>(k), distance_with_gradient(model.obstacles[k])});
        }
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

    static std::vector<double> coefficients(const model::Case& model, bool self) {
        std::vector<double> all;
        for (const auto& obstacle : model.obstacles) all.push_back(obstacle.friction);
        all.push_back(self ? model.contact.friction : 0);
        return all;
    }

    /// Contact of one facet, whose near facets are among `others`. Returns the pressures of its sample points, none if nothing is near.
    std::vector<double> add(const ContactState& at, std::size_t i, std::span<const std::size_t> others,
                            Summary& summary, const std::function<void(const Block&)>& to) {
        Separations& apart = at.rests ? separations_at_rest : separations;
        std::vector<std::size_t> near;
        const auto is_apart_by = [this](double clearance) {
            if (clearance > 0) clearance_m = std::min(clearance_m, clearance);
            return clearance > 0;
        };
        for (const std::size_t j : others)
            if (!is_apart_by(at_least(at.patches[i], at.patches[j]) - surface.entries()[i].range_m) &&
                !is_apart_by(apart.clearance_m(i, j, at.patches)))
                near.push_back(j);
        FacetContact facet(at, i, near, summary);
        facet.add(to);
        clearance_m = std::min(clearance_m, facet.clearance_of_obstacles_m());
        for (std::size_t k = 0; k < near.size(); ++k) {
            apart.set(i, near[k], facet.clearances_m()[k], at.patches);
            clearance_m = std::min(clearance_m, facet.clearances_m()[k]);
        }
        return facet.nodal_pressures_Pa();
    }

    /// Two configurations.
    struct Motion {
        std::span<const Patch> from;
        std::span<const Vector3> shifts;
        std::span<const Patch> to;
        std::span<const Vector3> shifts_to;
    };
    [[nodiscard]] double share_without_crossing(const Motion& motion);
    [[nodiscard]] bool passes_through(const Motion& motion) const;
    /// The obstacles that a facet may meet on its way.
    [[nodiscard]] std::vector<const ObstacleDistance*> obstacles_near(std::size_t facet, const Motion& motion) const;

    ContactSurface surface;
    bool self;
    Candidates candidates;
    Separations separations, separations_at_rest;
    std::size_t obstacles;
    bool has_thin_obstacles = false;                // maybe
    std::vector<ObstacleDistance> smooth, faceted;  // the mirror planes are smooth
    Friction friction;
    double clearance_m = 0;    // the least of the pairs and obstacles of an evaluation
    std::optional<Rest> rest;  // what touches() knows
};

std::vector<const ObstacleDistance*> Potential::Parts::obstacles_near(std::size_t facet, const Motion& motion) const {
    const Patch &from = motion.from[facet], &to = motion.to[facet];
    std::vector<const ObstacleDistance*> near;
    for (const auto* list : {&smooth, &faceted})
        for (const ObstacleDistance& obstacle : *list) {
            const Point before = obstacle.seen(from.centre, motion.shifts),
                        after = obstacle.seen(to.centre, motion.shifts_to);
            const double least = 0.5 * (obstacle.distance(before).value_m + obstacle.distance(after).value_m -
                                        norm(difference(after, before)));
            if (least < std::max(from.radius_m, to.radius_m)) near.push_back(&obstacle);
        }
    return near;
}

double Potential::Parts::share_without_crossing(const Motion& motion) {
    const auto& [from, shifts, to, shifts_to] = motion;
    const auto others = candidates.between(from, to);
    double share = 1;
    const auto size_of = [&](std::size_t i, std::size_t j) {
        const auto &entry = surface.entries()[i], &other = surface.entries()[j];
        return other.obstacle < 0 ? std::min(other.size_m, entry.size_m) : entry.size_m;
    };
    for (std::size_t i = 0; i < surface.free_count(); ++i) {
        const auto& entry = surface.entries()[i];
        std::vector<std::size_t> near;
        for (const std::size_t j : others[i])
            if (separations.clearance_m(i, j, to) <= 0) near.push_back(j);
        std::vector<double> turning;
        for (const std::size_t j : near) turning.push_back(turning_m(from[j], to[j]));
        const auto near_obstacles = obstacles_near(i, motion);
        if (near.empty() && near_obstacles.empty()) continue;
        for (std::size_t q = 0; q < entry.X.size(); ++q) {
            const Point x = from[i](entry.rule->xi[q]).x, next = to[i](entry.rule->xi[q]).x;
            for (std::size_t k = 0; k < near.size(); ++k) {
                const std::size_t j = near[k];
                const auto& other = surface.entries()[j];
                const double approach = norm(difference(difference(next, x), difference(to[j].centre, from[j].centre)));
                const double apart = at_least(from[j], x);
                if (apart > approach + from[j].radius_m) continue;
                if (apart > approach + turning[k] && height_above(from[j], x) > 0) continue;
                const ClosestPoint closest = closest_point(from[j], x);
                const auto y = from[j](closest.xi);
                const Vector3 r = difference(x, y.x), n = cross(y.t1, y.t2);
                if (dot(r, n) < 0 && !closest.is_interior) continue;
                const double behind = dot(r, n) < 0 ? -1 : 1;
                if (closest.distance_m == 0) continue;
                if (behind < 0 && !has_passed_through({entry, q, from[i], other, from[j], surface.is_revolved()},
                                                      closest, is_facing(from[i], entry, q, n)))
                    continue;
                const Vector3 relative = difference(difference(next, x), difference(to[j](closest.xi).x, y.x));
                share =
                    std::min(share, share_of_approach(behind * closest.distance_m,
                                                      -behind * dot(relative, r) / closest.distance_m, size_of(i, j)));
            }
            for (const ObstacleDistance* obstacle : near_obstacles)
                share = std::min(share, share_outside(*obstacle, entry, q, obstacle->seen(x, shifts),
                                                      obstacle->seen(next, shifts_to)));
        }
    }
    return share;
}

bool Potential::Parts::passes_through(const Motion& motion) const {
    const auto passes = [&](std::size_t i, std::size_t q, const ObstacleDistance& obstacle) {
        const ContactSurface::Entry& entry = surface.entries()[i];
        const Point from = obstacle.seen(motion.from[i](entry.rule->xi[q]).x, motion.shifts),
                    to = obstacle.seen(motion.to[i](entry.rule->xi[q]).x, motion.shifts_to);
        const Distance before = obstacle.distance(from), after = obstacle.distance(to);
        if (before.value_m + after.value_m >= norm(difference(to, from)) ||
            !are_opposite(before.gradient, after.gradient))
            return false;
        const Sweep past = sweep(obstacle.distance, from, to);
        return past.to_other_side || (past.leaves && past.deepest_m > entry.h_m[q]);  // also off the centre of a post
    };
    for (std::size_t i = 0; i < surface.free_count(); ++i)
        for (const ObstacleDistance* obstacle : obstacles_near(i, motion))
            if (obstacle->index >= 0)  // a mirror plane has one side
                for (std::size_t q = 0; q < surface.entries()[i].X.size(); ++q)
                    if (passes(i, q, *obstacle)) return true;
    return false;
}

Potential::Potential(const model::Case& model, std::span<const double> modulus_Pa)
    : parts_(std::make_unique<Parts>(model, modulus_Pa)) {
    if (parts_->friction.is_empty()) return;
    const std::vector<Vector3> unmoved(model.obstacles.size());
    parts_->friction.start(parts_->surface.patches(model.mesh.points, unmoved), unmoved, {});
}
Potential::~Potential() = default;
Potential::Potential(Potential&&) noexcept = default;

bool Potential::is_empty() const {
    return parts_->surface.free_count() == 0 || (!parts_->self && parts_->obstacles == 0);
}
double Potential::distance_m() const { return parts_->surface.distance_m(); }
double Potential::harmless_step_m() const {
    double smallest = std::numeric_limits<double>::max();
    for (const auto& entry : parts_->surface.entries().first(parts_->surface.free_count()))
        smallest = std::min(
            {smallest, deepest_in_sizes * entry.size_m,
             parts_->has_thin_obstacles ? *std::ranges::min_element(entry.h_m) : std::numeric_limits<double>::max()});
    return smallest;
}
std::span<const mesh::Index> Potential::nodes() const { return parts_->surface.nodes(); }

Summary Potential::evaluate(std::span<const Point> positions, std::span<const Vector3> shifts, Wanted wanted,
                            const Take& take, const std::function<void(const Block&)>& add) {
    return evaluate(positions, shifts, wanted, take, add, false);
}

bool Potential::touches(std::span<const Point> positions, std::span<const Vector3> shifts, const Take& take) {
    const auto touches_if = [&](bool rests) {
        return evaluate(
                   positions, shifts, Wanted::gradient, take, [](const Block&) {}, rests)
            .touches();
    };
    // The distance of two points changes by at most twice their motion; the radius about a facet grows by three times that of its nodes.
    constexpr double of_clearance = 0.2, of_harmless_step = 0.3;  // facets that are no candidates are farther apart
    if (parts_->rest && parts_->rest->holds(nodes(), positions, shifts)) return false;
    parts_->rest.reset();
    parts_->clearance_m = std::numeric_limits<double>::max();
    if (touches_if(true)) return touches_if(false);
    const double motion_m = std::min(of_clearance * parts_->clearance_m, of_harmless_step * harmless_step_m());
    if (motion_m <= 0) return false;
    parts_->rest = Rest{{}, {shifts.begin(), shifts.end()}, motion_m};
    for (const mesh::Index node : nodes()) parts_->rest->positions.push_back(positions[static_cast<std::size_t>(node)]);
    return false;
}

Summary Potential::evaluate(std::span<const Point> positions, std::span<const Vector3> shifts, Wanted wanted,
                            const Take& take, const std::function<void(const Block&)>& add, bool rests) {
    Summary summary(parts_->obstacles);
    if (is_empty()) return summary;
    const auto patches = parts_->surface.patches(positions, shifts);
    const auto others = parts_->candidates.between(patches, patches);
    const ContactState at{parts_->surface, patches, parts_->smooth, shifts, wanted, parts_->friction, rests};
    for (std::size_t i = 0; i < parts_->surface.free_count(); ++i)
        if (take(parts_->surface.entries()[i].facet.cell))
            static_cast<void>(parts_->add(at, i, others[i], summary, add));
    summary.dissipated_J += parts_->friction.dissipated_before_J();
    return summary;
}

std::vector<double> Potential::nodal_pressures_Pa(std::span<const Point> positions, std::span<const Vector3> shifts) {
    std::vector<double> nodal_Pa(positions.size());
    if (is_empty()) return nodal_Pa;
    const auto patches = parts_->surface.patches(positions, shifts);
    const auto others = parts_->candidates.between(patches, patches);
    const ContactState at{parts_->surface, patches, parts_->smooth, shifts, Wanted::gradient, parts_->friction};
    Summary summary(parts_->obstacles);
    for (std::size_t i = 0; i < parts_->surface.free_count(); ++i) {
        const auto& entry = parts_->surface.entries()[i];
        const auto pressures_Pa = parts_->add(at, i, others[i], summary, [](const Block&) {});
        for (std::size_t a = 0; a < pressures_Pa.size(); ++a) {
            double& value_Pa = nodal_Pa[static_cast<std::size_t>(entry.nodes[a])];
            value_Pa = std::max(value_Pa, pressures_Pa[a]);
        }
    }
    return nodal_Pa;
}

std::size_t Potential::sample_points() const {
    std::size_t points = 0;
    for (const auto& entry : parts_->surface.entries().first(parts_->surface.free_count())) points += entry.X.size();
    return points;
}
bool Potential::has_friction() const { return !is_empty() && !parts_->friction.is_empty(); }

bool Potential::start_friction(std::span<const Point> positions, std::span<const Vector3> shifts,
                               const FrictionState& from, const Take& take) {
    FrictionState own{{}, from.dissipated_J};
    const auto entries = parts_->surface.entries().first(parts_->surface.free_count());
    for (const auto& slip : from.slips) {
        if (slip.facet >= entries.size() || slip.point >= entries[slip.facet].X.size() || slip.obstacle < -1 ||
            slip.obstacle >= static_cast<int>(parts_->obstacles))
            return false;
        if (take(entries[slip.facet].facet.cell)) own.slips.push_back(slip);
    }
    parts_->friction.start(parts_->surface.patches(positions, shifts), shifts, own);
    return true;
}

FrictionState Potential::friction_start() const { return parts_->friction.start_state(); }

FrictionState Potential::friction_state(std::span<const Point> positions, std::span<const Vector3> shifts) const {
    return parts_->friction.state(parts_->surface.patches(positions, shifts), shifts);
}

double Potential::share_without_crossing(std::span<const Point> from, std::span<const Vector3> shifts,
                                         std::span<const Point> to, std::span<const Vector3> shifts_to) {
    return parts_->share_without_crossing(
        {parts_->surface.patches(from, shifts), shifts, parts_->surface.patches(to, shifts_to), shifts_to});
}

bool Potential::passes_through(std::span<const Point> from, std::span<const Vector3> shifts, std::span<const Point> to,
                               std::span<const Vector3> shifts_to) const {
    return parts_->passes_through(
        {parts_->surface.patches(from, shifts), shifts, parts_->surface.patches(to, shifts_to), shifts_to});
}

std::vector<std::array<mesh::Facet, 2>> Potential::near_pairs(std::span<const Point> positions,
                                                              std::span<const Vector3> shifts, double share) {
    std::vector<std::array<mesh::Facet, 2>> pairs;
    if (!parts_->self) return pairs;
    const auto patches = parts_->surface.patches(positions, shifts);
    const auto entries = parts_->surface.entries();
    const std::size_t count = parts_->surface.free_count();
    const auto is_close = [&](std::size_t i, std::size_t j) {
        const double within_m = std::max(entries[i].distance_m, share * std::max(entries[i].size_m, entries[j].size_m));
        return std::ranges::any_of(entries[i].rule->xi, [&](const surface::FacetPoint& xi) {
            const Point x = patches[i](xi).x;
            return at_least(patches[j], x) < within_m && closest_point(patches[j], x).distance_m < within_m;
        });
    };
    const auto others = parts_->candidates.between(patches, patches);
    for (std::size_t i = 0; i < count; ++i)
        for (const std::size_t j : others[i])
            if (i < j && j < count && (is_close(i, j) || is_close(j, i)))
                pairs.push_back({entries[i].facet, entries[j].facet});
    return pairs;
}

}  // namespace soft::contact
