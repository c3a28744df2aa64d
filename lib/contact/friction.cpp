#include "contact/friction.hpp"

#include <algorithm>
#include <cmath>

namespace soft::contact {

namespace {

using mesh::Point;

Vector3 tangential(const Vector3& v, const Vector3& n) { return along(v, -dot(v, n), n); }

/// Into the plane normal to n, with the same length.
Vector3 turned_into_plane(const Vector3& v, const Vector3& n) {
    const Vector3 t = tangential(v, n);
    const double length = norm(t);
    return length > 0 ? along({}, norm(v) / length, t) : Vector3{};
}

/// v turned by the smallest rotation that takes the unit vector `from` to `to` (Rodrigues).
Vector3 turned(const Vector3& v, const Vector3& from, const Vector3& to) {
    const Vector3 axis = cross(from, to);
    const double cosine = dot(from, to);
    if (cosine <= -1 + 1e-9) return v;
    return along(along(along({}, cosine, v), 1, cross(axis, v)), dot(axis, v) / (1 + cosine), axis);
}

}  // namespace

Friction::Friction(const ContactSurface& surface, std::vector<double> coefficients)
    : surface_(surface),
      coefficients_(std::move(coefficients)),
      is_empty_(std::ranges::none_of(coefficients_, [](double mu) { return mu > 0; })),
      points_(surface.free_count()) {}

void Friction::start(std::vector<Patch> patches, std::span<const Vector3> shifts, const FrictionState& from) {
    patches_ = std::move(patches);
    shifts_.assign(shifts.begin(), shifts.end());
    dissipated_J_ = from.dissipated_J;
    slips_.clear();
    for (const auto& slip : from.slips)
        slips_[{slip.facet, slip.point, slip.obstacle}] = {slip.elastic_m, slip.limit_N};
    for (auto& list : points_) list.clear();
}

FrictionState Friction::start_state() const {
    FrictionState state{{}, dissipated_J_};
    for (const auto& [key, slip] : slips_)
        state.slips.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), slip.elastic_m, slip.limit_N});
    return state;
}

double Friction::stiffness_N_m(std::size_t facet, std::size_t point, int obstacle) const {
    const auto& entry = surface_.entries()[facet];
    return (obstacle < 0 ? 0.5 : 1) * entry.weight_m2[point] * entry.stiffness_Pa / entry.h_m[point];
}

void Friction::set(std::size_t facet, std::span<const Touch> touches, std::span<const Patch> patches,
                   std::span<const Vector3> shifts) {
    auto& list = points_[facet];
    list.clear();
    struct Group {
        Vector3 gradient{};
        double force_by_gap_N_m = 0;
        const Touch* closest = nullptr;
    };
    std::map<std::pair<std::size_t, int>, Group> groups;
    for (const Touch& touch : touches) {
        auto& [gradient, by_gap_N_m, closest] = groups[{touch.point, touch.obstacle}];
        gradient = along(gradient, 1, touch.gradient);
        by_gap_N_m += touch.force_by_gap_N_m;
        if (closest == nullptr || touch.is_closest) closest = &touch;
    }
    for (const auto& [key, group] : groups) {
        const auto& [gradient, by_gap_N_m, closest] = group;
        const auto [q, obstacle] = key;
        const double mu = obstacle < 0 ? coefficients_.back() : coefficients_[static_cast<std::size_t>(obstacle)];
        const double force = norm(gradient);
        if (!(mu * force > 0)) continue;
        Point point{q, obstacle, obstacle < 0 ? closest->other : std::nullopt, closest->xi};
        point.normal = along({}, -1 / force, gradient);
        point.normal_by_position_1_m = closest->normal_by_position_1_m;
        point.limit_N = mu * force;
        point.limit_by_gap_N_m = mu * by_gap_N_m;
        point.stiffness_N_m = stiffness_N_m(facet, q, obstacle);
        const auto slip = slips_.find({facet, q, obstacle});
        if (slip != slips_.end()) {
            point.elastic_m = turned_into_plane(slip->second.elastic_m, point.normal);
            point.limit_before_N = slip->second.limit_N;
        }
        Vector3 before = relative(facet, point, patches_, shifts_);
        if (point.other) {
            const Patch &then = patches_[*point.other], &now = patches[*point.other];
            const Vector3 from = unit_normal(then, point.xi), to = unit_normal(now, point.xi);
            before = turned(before, from, to);
        }
        if (slip == slips_.end()) {
            const double approach = dot(difference(before, relative(facet, point, patches, shifts)), point.normal);
            if (approach > closest->depth_m) point.share = closest->depth_m / approach;
        }
        point.start_m = along(point.elastic_m, -point.share, tangential(before, point.normal));
        list.push_back(point);
    }
}

std::span<const Friction::Point> Friction::points(std::size_t facet) const { return points_[facet]; }

Vector3 Friction::relative(std::size_t facet, const Point& point, std::span<const Patch> patches,
                           std::span<const Vector3> shifts) const {
    const mesh::Point x = patches[facet](surface_.entries()[facet].rule->xi[point.point]).x;
    if (point.other) return difference(x, patches[*point.other](point.xi).x);
    return difference(x, shifts[static_cast<std::size_t>(point.obstacle)]);
}

Friction::Value Friction::value(const Point& point, const Vector3& relative) {
    Value at;
    const Vector3 trial = along(point.start_m, point.share, tangential(relative, point.normal));
    const double length = norm(trial), most = point.limit_N / point.stiffness_N_m;
    at.slides = length > most;
    at.elastic_m = at.slides ? along({}, most / length, trial) : trial;
    at.force_N = along({}, point.stiffness_N_m, at.elastic_m);
    at.stored_J = 0.5 * dot(at.force_N, at.elastic_m);
    if (at.slides)
        at.dissipated_J =
            0.5 * (1 + point.limit_before_N / point.limit_N) * dot(at.force_N, difference(trial, at.elastic_m));
    const double stiffness = point.share * (at.slides ? point.limit_N / length : point.stiffness_N_m);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) {
            at.by_position[k][l] = stiffness * ((k == l ? 1 : 0) - point.normal[k] * point.normal[l]);
            if (at.slides)
                at.by_position[k][l] +=
                    trial[k] / length * (point.limit_by_gap_N_m * point.normal[l] - stiffness * trial[l] / length);
            for (std::size_t m = 0; m < 3; ++m)
                at.by_position[k][l] -= point.normal[k] * at.force_N[m] * point.normal_by_position_1_m[m][l];
        }
    return at;
}

double Friction::dissipated_before_J() const {
    double dissipated = dissipated_J_;
    for (const auto& [key, slip] : slips_) {
        const auto [facet, q, obstacle] = key;
        const bool touches = std::ranges::any_of(points_[facet], [&, q = q, obstacle = obstacle](const Point& point) {
            return point.point == q && point.obstacle == obstacle;
        });
        if (!touches) dissipated += 0.5 * stiffness_N_m(facet, q, obstacle) * dot(slip.elastic_m, slip.elastic_m);
    }
    return dissipated;
}

FrictionState Friction::state(std::span<const Patch> patches, std::span<const Vector3> shifts) const {
    FrictionState result{{}, dissipated_before_J()};
    for (std::size_t facet = 0; facet < points_.size(); ++facet)
        for (const Point& point : points_[facet]) {
            const Value now = value(point, relative(facet, point, patches, shifts));
            result.dissipated_J += now.dissipated_J;
            result.slips.push_back({facet, point.point, point.obstacle, now.elastic_m, point.limit_N});
        }
    return result;
}

}  // namespace soft::contact
