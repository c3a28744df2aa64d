#include "contact/facet_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <set>

namespace soft::contact {

namespace {

using mesh::Point;

/// Rubber between two surfaces is rarely compressed to less than this fraction of its thickness, except where its surface grows.
constexpr double least_compression = 0.2;
/// Cosine of the angle to the normal of a facet beyond which a point is neither in its plane nor rounding decides the side.
constexpr double off_the_plane = 0.1;
/// Cosine below which a point behind a facet that is closest to its boundary lies beside it.
constexpr double beside = 0.5;
/// Fraction of h: below it the curvature of the distance is lost in rounding, and a reach below it does not act.
constexpr double no_gap = 1e-6;
/// Keys of the blocks of smooth obstacles and of friction with obstacles, after those of facets and faceted obstacles.
constexpr std::size_t smooth_keys = std::size_t{1} << 60, friction_keys = std::size_t{1} << 61;

bool is_behind(const Feature& feature, std::span<const Patch> patches, const Point& x) {
    return dot(difference(x, patches[feature.facet](feature.closest.xi).x), feature.normal) < 0;
}

}  // namespace

bool has_passed_through(const Approach& from, const ClosestPoint& closest, bool faces) {
    const auto& [entry, q, now, other, patch, is_revolved] = from;
    const Patch& undeformed = other.undeformed;
    const ClosestPoint before = closest_point(undeformed, entry.X[q]);
    const auto at = undeformed(before.xi);
    const Vector3 n = cross(at.t1, at.t2), arm = difference(entry.X[q], at.x);
    const double height = dot(arm, n) / norm(n), off_m = off_the_plane * before.distance_m;
    const auto own = entry.undeformed(entry.rule->xi[q]);
    const Vector3 outward = cross(own.t1, own.t2);
    const bool through_rubber = dot(arm, outward) > off_m * norm(outward);
    const bool was_in_front = height > off_m;
    if (was_in_front && !through_rubber && (faces || dot(n, outward) < 0)) return true;
    if (!faces) return was_in_front && closest.is_interior && closest.distance_m < entry.h_m[q];
    const double stretch = std::max(area_stretch(entry.undeformed, now, entry.rule->xi[q], is_revolved),
                                    area_stretch(undeformed, patch, closest.xi, is_revolved));
    const double thinnest_m = least_compression * before.distance_m / std::max(1.0, stretch);
    const auto now_at = patch(closest.xi);
    const bool leads_through = dot(difference(now.cell_centre, now_at.x), cross(now_at.t1, now_at.t2)) > 0;
    const bool beside_it = std::abs(height) <= off_m && !through_rubber;
    return (beside_it && leads_through) || closest.distance_m < thinnest_m;
}

namespace {

/// Mean over the sample points of a facet at its node a, weighted with the square of the node's shape function.
double nodal_mean(const ContactSurface::Entry& entry, std::size_t a, std::span<const double> at_points) {
    double sum = 0, weights = 0;
    for (std::size_t q = 0; q < at_points.size(); ++q) {
        const double N = entry.rule->N[q * entry.nodes.size() + a], weight = entry.weight_m2[q] * N * N;
        sum += weight * at_points[q];
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
}

}  // namespace

FacetContact::FacetContact(const ContactState& at, std::size_t facet, std::span<const std::size_t> others,
                           Summary& summary)
    : at_(at),
      entry_(at.surface.entries()[facet]),
      map_(at.patches[facet]),
      facet_(facet),
      others_(others),
      summary_(summary) {
    const Point& middle = map_.nodes[0];
    double radius = entry_.distance_m;
    for (std::size_t a = 0; a < entry_.nodes.size(); ++a)
        radius = std::max(radius, entry_.distance_m + 1.5 * norm(difference(map_.nodes[a], middle)));
    for (const ObstacleDistance& obstacle : at.smooth)
        if (obstacle.at(middle, at.shifts).value_m < radius) near_.push_back(&obstacle);
    clearances_m_.assign(others.size(), std::numeric_limits<double>::max());
}

void FacetContact::add(const std::function<void(const Block&)>& to) {
    if (near_.empty() && others_.empty()) return at_.friction.set(facet_, {}, at_.patches, at_.shifts);
    const std::size_t nodes = entry_.nodes.size();
    for (std::size_t q = 0; q < entry_.X.size(); ++q) {
        Point x{};
        for (std::size_t a = 0; a < nodes; ++a) x = along(x, entry_.rule->N[q * nodes + a], map_.nodes[a]);
        if (!others_.empty()) add_features(q, x);
        for (const ObstacleDistance* obstacle : near_) add_smooth(q, x, *obstacle);
    }
    for (const auto& [k, pressures] : pressures_Pa_)
        for (std::size_t a = 0; a < nodes; ++a) {
            const double mean = nodal_mean(entry_, a, pressures);
            nodal_pressures_Pa_.resize(nodes);
            nodal_pressures_Pa_[a] = std::max(nodal_pressures_Pa_[a], mean);
            summary_.pressure_Pa[k] = std::max(summary_.pressure_Pa[k], mean);
        }
    at_.friction.set(facet_, touches_, at_.patches, at_.shifts);
    for (const Friction::Point& point : at_.friction.points(facet_)) add_friction(point);
    for (const auto& [key, block] : blocks_) to(block);
}

const AreaStretch& FacetContact::stretch_at(std::size_t q) {
    const auto known = stretches_.find(q);
    if (known != stretches_.end()) return known->second;
    return stretches_.emplace(q, area_stretch(entry_, map_, q, at_.surface, at_.wanted)).first->second;
}

Block& FacetContact::block_of(std::size_t key, int obstacle, std::span<const mesh::Index> others) {
    const auto known = blocks_.find(key);
    if (known != blocks_.end()) return known->second;
    Block block;
    block.nodes = entry_.nodes;
    block.nodes.insert(block.nodes.end(), others.begin(), others.end());
    block.obstacle = obstacle;
    block.dimension = at_.surface.dimension();
    const std::size_t size = block.points() * block.dimension;
    block.gradient.assign(size, 0);
    block.hessian.assign(at_.wanted == Wanted::hessian ? size * size : 0, 0);
    return blocks_.emplace(key, std::move(block)).first->second;
}

double FacetContact::pressure_at(std::size_t q, const Barrier& b) {
    const AreaStretch& stretch = stretch_at(q);
    return -entry_.stiffness_Pa * b.slope * stretch.factor / stretch.stretch;
}

double FacetContact::pressure_on(const ContactSurface::Entry& entry, const Patch& now, const surface::FacetPoint& xi,
                                 const Barrier& b) const {
    const double stretch = area_stretch(entry.undeformed, now, xi, at_.surface.is_revolved());
    return -entry.stiffness_Pa * b.slope * area_factor(stretch).value / stretch;
}

void FacetContact::note(std::size_t q, int obstacle, double share, double own_Pa, double other_Pa,
                        const Vector3& away) {
    const double pressure = own_Pa + other_Pa;
    const std::size_t k = obstacle >= 0 ? static_cast<std::size_t>(obstacle) : summary_.area_m2.size() - 1;
    const double facing =
        facing_of(map_, entry_, q, away);  // beside an edge, sides do not face what the end presses on
    summary_.area_m2[k] += facing * share * entry_.weight_m2[q] * stretch_at(q).stretch;
    std::vector<double>& pressures = pressures_Pa_[k];
    pressures.resize(entry_.X.size());
    pressures[q] = std::max(pressures[q], facing * pressure);
    if (own_Pa <= 0 || (summary_.location && pressure <= summary_.max_pressure_Pa)) return;
    summary_.max_pressure_Pa = pressure;
    summary_.location = entry_.X[q];
    summary_.touched = obstacle;
}

bool FacetContact::is_at(std::size_t q, const ContactSurface::Entry& other) const {
    const double touching_m = touching_share_of_size * entry_.size_m;
    if (other.obstacle >= 0 || at_least(other.undeformed, entry_.X[q]) > touching_m) return false;
    const ClosestPoint closest = closest_point(other.undeformed, entry_.X[q]);
    if (closest.distance_m > touching_m) return false;
    const bool neighbours = std::ranges::any_of(entry_.corners, [&](std::size_t corner) {
        return std::ranges::find(other.corners, corner) != other.corners.end();
    });
    return neighbours || !are_facing(entry_, q, other.undeformed, closest);
}

bool FacetContact::may_touch(std::size_t q, const Point& x) const {
    return std::ranges::any_of(others_, [&](std::size_t j) {
        const double acts_m = std::max(entry_.h_m[q], at_.surface.entries()[j].distance_m),
                     range_m = std::max(acts_m, overlap_share_of_size * entry_.size_m);
        return height_above(at_.patches[j], x) <= acts_m && at_least(at_.patches[j], x) <= range_m;
    });
}

void FacetContact::add_features(std::size_t q, const Point& x) {
    std::map<int, std::vector<NearFacet>> facets;  // by obstacle, -1: the actuator
    const bool is_apart = !may_touch(q, x);
    bool touches = false;
    for (std::size_t k = 0; k < others_.size(); ++k) {
        const std::size_t j = others_[k];
        const auto& other = at_.surface.entries()[j];
        const Patch& patch = at_.patches[j];
        const double h = entry_.h_m[q], range = std::max(h, overlap_share_of_size * entry_.size_m);
        const bool in_front = at_.rests && height_above(patch, x) > h;
        if (const double beyond = at_least(patch, x); is_apart || in_front || beyond > range) {
            clearances_m_[k] = std::min(clearances_m_[k], beyond - (in_front ? h : range));
            continue;
        }
        const ClosestPoint closest = closest_point(patch, x);
        if (is_at(q, other)) continue;
        const auto y = patch(closest.xi);
        const bool behind = dot(difference(x, y.x), cross(y.t1, y.t2)) < 0;
        clearances_m_[k] = std::min(clearances_m_[k], closest.distance_m - (at_.rests && !behind ? h : range));
        if (closest.distance_m > range) continue;
        touches = touches || closest.distance_m < std::max(h, other.distance_m) || behind;
        facets[other.obstacle].push_back({j, closest});
    }
    if (!touches) return;
    for (const auto& [obstacle, list] : facets) add_features_of(q, x, list);
}

bool FacetContact::has_passed(std::size_t q, const Point& x, const Feature& closest) const {
    if (!is_behind(closest, at_.patches, x)) return false;
    const auto& other = at_.surface.entries()[closest.facet];
    const Vector3 arm = difference(x, at_.patches[closest.facet](closest.closest.xi).x);
    const double along_normal = -dot(arm, closest.normal) / norm(closest.normal);
    if (!closest.closest.is_interior && along_normal < beside * norm(arm)) return false;
    const Patch& patch = at_.patches[closest.facet];
    return other.obstacle >= 0 || has_passed_through({entry_, q, map_, other, patch, at_.surface.is_revolved()},
                                                     closest.closest, is_facing(map_, entry_, q, closest.normal));
}

bool FacetContact::is_beside(std::size_t q, const Point& x, const Feature& facet) const {
    const auto& other = at_.surface.entries()[facet.facet];
    const Patch& patch = at_.patches[facet.facet];
    const auto y = patch(facet.closest.xi);
    const Vector3 n = cross(y.t1, y.t2);
    return other.obstacle < 0 && dot(difference(x, y.x), n) < touching_share_of_size * entry_.size_m * norm(n) &&
           !has_passed_through({entry_, q, map_, other, patch, at_.surface.is_revolved()}, facet.closest,
                               is_facing(map_, entry_, q, n));
}

/// A point is behind a surface if it is behind the part of it that is closest. Then all parts behind which it lies act: the terms that have
/// the same closest point must cancel. An obstacle is closed: a point is in it only behind the closest of all its facets, and the other
/// side of a thin one does not act. Nor does a facet of the actuator behind which the point has been from the start, as the end face of a block
/// beside whose edge the point has passed through a side.
void FacetContact::add_features_of(std::size_t q, const Point& x, std::span<const NearFacet> facets) {
    const std::vector<Feature> features = features_near(at_.surface, at_.patches, facets, x);
    const auto is_facet = [](const Feature& feature) { return feature.kind == Feature::Kind::facet; };
    const auto is_of_obstacle = [&](const Feature& facet) { return at_.surface.entries()[facet.facet].obstacle >= 0; };
    struct Group {
        const Feature* closest = nullptr;
        bool is_passed = false;
    };
    std::map<std::size_t, Group> groups;
    const Feature* nearest = nullptr;
    std::set<std::size_t> unpassed;
    const auto keep_closer = [](const Feature*& known, const Feature& facet) {
        if (known == nullptr || facet.closest.distance_m < known->closest.distance_m) known = &facet;
    };
    for (const Feature& facet : features | std::views::filter(is_facet)) {
        Group& group = groups[facet.group];
        if (is_beside(q, x, facet)) {
            unpassed.insert(facet.facet);
            continue;
        }
        keep_closer(group.closest, facet);
        keep_closer(nearest, facet);
    }
    for (auto& [number, group] : groups)
        group.is_passed = group.closest != nullptr && (!is_of_obstacle(*group.closest) || group.closest == nearest) &&
                          has_passed(q, x, *group.closest);
    std::vector<NearFacet> others;
    for (const Feature& facet : features | std::views::filter(is_facet)) {
        const bool is_other_side = is_of_obstacle(facet) && dot(facet.normal, nearest->normal) < 0;
        if (!groups[facet.group].is_passed || (!is_other_side && !unpassed.contains(facet.facet)))
            others.push_back({facet.facet, facet.closest});
    }
    if (others.size() < facets.size()) return add_features_of(q, x, others);
    Reaches reaches(at_.surface, entry_, q, features);
    for (const Feature& feature : features) {
        const double farthest = std::max(at_.surface.entries()[feature.facet].distance_m,
                                         std::max(entry_.h_m[q], overlap_share_of_size * entry_.size_m));
        if (feature.closest.distance_m < farthest &&
            (groups[feature.group].is_passed || !is_behind(feature, at_.patches, x)))
            add_feature(q, x, feature, reaches.of(feature),
                        groups[feature.group].closest == &feature ? Nearness::closest : Nearness::other);
    }
}

/// The derivatives of the distance d follow from those of f = d^2/2: grad d = n and d hess d = hess f - n n^T.
void FacetContact::add_feature(std::size_t q, const Point& x, const Feature& feature, const Reach& reach,
                               Nearness nearness) {
    const auto& other = at_.surface.entries()[feature.facet];
    const bool itself = other.obstacle < 0;
    const double h = entry_.h_m[q], distance = feature.closest.distance_m;
    const FacetJet y = jet(at_.patches[feature.facet], feature.closest.xi);
    const Vector3 r = difference(x, y.y);
    const bool behind = is_behind(feature, at_.patches, x);
    if (distance >= (behind ? overlap_share_of_size * entry_.size_m : std::max(reach.own_m, reach.other_m))) return;
    const double d = behind ? -distance : distance, gap = d + reach.offset_m, gap_other = d + reach.offset_of_other_m;
    const bool acts = gap < reach.own_m && reach.own_m > no_gap * h,
               other_acts = feature.is_closest && gap_other < reach.other_m && reach.other_m > no_gap * h;
    if (!acts && !other_acts) return;
    const Barrier b = acts ? barrier(gap, reach.own_m, nearness) : Barrier{};
    const AreaStretch& stretch = stretch_at(q);
    const double share = itself ? 0.5 : 1.0,
                 undeformed = feature.coefficient * share * entry_.weight_m2[q] * entry_.stiffness_Pa,
                 scale = undeformed * stretch.factor, by_f = distance > no_gap * h ? scale * b.slope / d : 0;
    const Vector3 n = distance > 0 ? along({}, 1 / d, r) : along({}, 1 / norm(feature.normal), feature.normal);
    // Both sides act with half of their own pressure.
    const double by_other_Pa = !other_acts ? 0
                                           : pressure_on(other, at_.patches[feature.facet], feature.closest.xi,
                                                         barrier(gap_other, reach.other_m));
    if (feature.is_closest) {
        const double in_contact = std::max(acts ? share_in_contact(gap, reach.own_m) : 0.0,
                                           other_acts ? share_in_contact(gap_other, reach.other_m) : 0.0);
        note(q, other.obstacle, share * in_contact, share * pressure_at(q, b), 0.5 * by_other_Pa, n);
    }
    if (!acts) return;
    Vector3 g{};
    std::array<Vector3, 3> H{};
    for (std::size_t k = 0; k < 3; ++k) {
        g[k] = scale * b.slope * n[k];
        for (std::size_t l = 0; l < 3; ++l)
            H[k][l] = (scale * b.curvature_1_m - by_f) * n[k] * n[l] + (k == l ? by_f : 0);
    }
    summary_.energy_J += scale * b.value_m;
    const std::size_t own = entry_.nodes.size();
    std::vector<double> weights(&entry_.rule->N[q * own], &entry_.rule->N[q * own] + own);
    std::array<mesh::ShapeValue, 9> shapes;
    const auto values = std::span{shapes}.first(other.nodes.size());  // none for an obstacle
    if (itself) mesh::shape_values(other.undeformed.type, {feature.closest.xi[0], feature.closest.xi[1], 0}, values);
    for (const auto& value : values) weights.push_back(-value.value);
    if (!itself) weights.push_back(-1);
    Block& block =
        itself ? block_of(feature.facet, -1, other.nodes)
               : block_of(at_.surface.entries().size() + static_cast<std::size_t>(other.obstacle), other.obstacle, {});
    add_function(block, weights, g, H);
    add_area_stretch(block, stretch, undeformed * b.value_m, along({}, undeformed * b.slope, n), weights);
    if (by_f != 0 && !block.hessian.empty()) add_sliding(block, weights, y, feature.closest, r, values, by_f);
    if (!at_.friction.is_empty())
        touches_.push_back({q, other.obstacle, g, -scale * b.curvature_1_m, feature.facet, feature.closest.xi,
                            feature.is_closest, reach.own_m - gap});
}

void FacetContact::add_smooth(std::size_t q, const Point& x, const ObstacleDistance& obstacle) {
    const Distance d = obstacle.at(x, at_.shifts);
    const double h = entry_.h_m[q];
    if (!at_.rests && d.value_m >= h) return;  // at rest the clearance counts
    const bool mirror = obstacle.index < 0;
    const double initial = mirror ? obstacle.distance(entry_.X[q]).value_m : 0;
    if (mirror && initial <= touching_share_of_size * entry_.size_m) return;
    const bool along_rubber =
        mirror && !is_facing(entry_.undeformed, entry_, q, obstacle.distance(entry_.X[q]).gradient);
    const double reach = along_rubber ? std::min(h, share_of_initial_gap * initial) : h,
                 gap = d.value_m + (along_rubber ? 0
                                    : mirror     ? std::max(h - initial, 0.0)
                                                 : at_.surface.initial_overlap_m(entry_, q, obstacle.index));
    clearance_of_obstacles_m_ = std::min(clearance_of_obstacles_m_, gap - reach);
    if (gap >= reach) return;
    const Barrier b = barrier(gap, reach);
    const std::size_t nodes = entry_.nodes.size();
    std::vector<double> weights(&entry_.rule->N[q * nodes], &entry_.rule->N[q * nodes] + nodes);
    if (!mirror) weights.push_back(-1);
    const AreaStretch& stretch = stretch_at(q);
    const double undeformed = entry_.weight_m2[q] * entry_.stiffness_Pa, scale = undeformed * stretch.factor;
    summary_.energy_J += scale * b.value_m;
    Vector3 g{};
    std::array<Vector3, 3> H{};
    for (std::size_t k = 0; k < 3; ++k) {
        g[k] = scale * b.slope * d.gradient[k];
        for (std::size_t l = 0; l < 3; ++l)
            H[k][l] = scale * (b.curvature_1_m * d.gradient[k] * d.gradient[l] + b.slope * d.hessian[k][l]);
    }
    const auto key = smooth_keys + static_cast<std::size_t>(&obstacle - at_.smooth.data());
    Block& block = block_of(key, obstacle.index, {});
    add_function(block, weights, g, H);
    add_area_stretch(block, stretch, undeformed * b.value_m, along({}, undeformed * b.slope, d.gradient), weights);
    // In the whole actuator both sides of a mirror count, half each, as two walls that touch.
    note(q, obstacle.index, (mirror ? 0.5 : 1) * share_in_contact(gap, reach), pressure_at(q, b), 0, d.gradient);
    if (!at_.friction.is_empty() && !mirror)
        touches_.push_back({.point = q,
                            .obstacle = obstacle.index,
                            .gradient = g,
                            .force_by_gap_N_m = -scale * b.curvature_1_m,
                            .depth_m = reach - gap,
                            .normal_by_position_1_m = d.hessian});
}

void FacetContact::add_friction(const Friction::Point& point) {
    const auto value = Friction::value(point, at_.friction.relative(facet_, point, at_.patches, at_.shifts));
    summary_.energy_J += value.stored_J;
    summary_.dissipated_J += value.dissipated_J;
    const std::size_t nodes = entry_.nodes.size();
    std::vector<double> weights(&entry_.rule->N[point.point * nodes], &entry_.rule->N[point.point * nodes] + nodes);
    const auto add_to = [&](Block& block) {
        add_function(block, weights, value.force_N, value.by_position);
        if (value.slides) add_area_stretch(block, stretch_at(point.point), value.force_N, weights);
    };
    if (!point.other) {
        weights.push_back(-1);
        return add_to(block_of(friction_keys + static_cast<std::size_t>(point.obstacle), point.obstacle, {}));
    }
    const auto& other = at_.surface.entries()[*point.other];
    std::array<mesh::ShapeValue, 9> shapes;
    const auto values = std::span{shapes}.first(other.nodes.size());
    mesh::shape_values(other.undeformed.type, {point.xi[0], point.xi[1], 0}, values);
    for (const auto& shape : values) weights.push_back(-shape.value);
    add_to(block_of(*point.other, -1, other.nodes));
}

}  // namespace soft::contact
