#include "contact/contact_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "contact/signed_distance.hpp"
#include "mesh/shape.hpp"
#include "surface/free_facets.hpp"

namespace soft::contact {

namespace {

using mesh::Index;
using mesh::Point;
using surface::FacetPoint;

/// Cosine of the angle between the normals of facets that face each other and the direction between them.
constexpr double facing = 0.5;
/// Facets that face away from each other within this many facet sizes have rubber between them.
constexpr double thickest_wall_in_facets = 3;
/// A point that slides over a corner of the other side makes the equilibrium unstable unless its force over its gap is small against the
/// stiffness of the cells. On a line, points are closer to each other than the default contact distance, so that the force on a corner that slides
/// over them hardly varies.
constexpr std::size_t line_intervals = 64;
constexpr int quadrilateral_parts = 3;
/// Points on [-1, 1] with their weights.
using LinePoint = std::array<double, 2>;
constexpr std::array simpson{LinePoint{-1, 1.0 / 3}, LinePoint{0, 4.0 / 3}, LinePoint{1, 1.0 / 3}};
/// Gregory's weights at the ends of the trapezoidal rule.
constexpr std::array end_weights{95.0 / 288, 317.0 / 240, 23.0 / 30, 793.0 / 720, 157.0 / 160};
/// k over the larger of E_0 and the pressure.
constexpr double stiffness_share = 0.1;

void add_point(SampleRule& rule, const FacetPoint& xi, double weight) {
    for (std::size_t q = 0; q < rule.xi.size(); ++q)
        if (std::hypot(rule.xi[q][0] - xi[0], rule.xi[q][1] - xi[1]) < 1e-9) {
            rule.weights[q] += weight;
            return;
        }
    rule.xi.push_back(xi);
    rule.weights.push_back(weight);
}

/// Simpson's rule in each of so many equal parts of [-1, 1]; points that two parts share come twice.
std::vector<LinePoint> simpson_in_parts(int parts) {
    std::vector<LinePoint> all;
    for (int part = 0; part < parts; ++part)
        for (const auto& [s, w] : simpson) all.push_back({(2 * part + 1 + s) / parts - 1, w / parts});
    return all;
}

void add_triangle(SampleRule& rule, const std::array<FacetPoint, 3>& corners, double area) {
    const auto mean = [](std::initializer_list<FacetPoint> points) {
        FacetPoint sum{};
        for (const FacetPoint& p : points)
            for (std::size_t d = 0; d < 2; ++d) sum[d] += p[d] / static_cast<double>(points.size());
        return sum;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        add_point(rule, corners[k], area / 20);
        add_point(rule, mean({corners[k], corners[(k + 1) % 3]}), area * 2 / 15);
    }
    add_point(rule, mean({corners[0], corners[1], corners[2]}), area * 9 / 20);
}

surface::Box box_within(const Patch& map, double margin_m) {
    surface::Box box{map.low, map.high};
    for (std::size_t d = 0; d < 3; ++d) {
        box.low[d] -= margin_m;
        box.high[d] += margin_m;
    }
    return box;
}

Point middle_of(const Patch& map) {
    const auto xi = mesh::reference_centre(map.type);
    return map({xi[0], xi[1]}).x;
}

Vector3 normal_at(const Patch& map, const FacetPoint& xi) {
    const auto at = map(xi);
    return cross(at.t1, at.t2);
}

Vector3 unit(const Vector3& v) { return norm(v) > 0 ? along({}, 1 / norm(v), v) : v; }

mesh::CellType linear_facet(std::size_t corners) {
    if (corners == 2) return mesh::CellType::line2;
    return corners == 3 ? mesh::CellType::triangle3 : mesh::CellType::quad4;
}

/// Whether the middle of `a` lies behind the facet `b`.
bool is_behind(const Patch& a, const Patch& b, double within_m) {
    const ClosestPoint closest = closest_point(b, middle_of(a));
    const Vector3 arm = difference(middle_of(a), b(closest.xi).x);
    return closest.distance_m < within_m && dot(arm, normal_at(b, closest.xi)) < 0;
}

bool has_facing_points(const ContactSurface::Entry& entry, const ContactSurface::Entry& other) {
    const NormalCone a = normals(entry.undeformed), b = normals(other.undeformed);
    const double angle = std::acos(std::clamp(dot(a.axis, b.axis), -1.0, 1.0));
    if (angle + a.angle + b.angle < std::acos(-facing)) return false;
    for (std::size_t q = 0; q < entry.X.size(); ++q) {
        const ClosestPoint closest = closest_point(other.undeformed, entry.X[q]);
        if (closest.distance_m > 0 && are_facing(entry, q, other.undeformed, closest)) return true;
    }
    return false;
}

/// A point on the axis of revolution stands for the surface halfway to the next point, which it takes from that: with its own radius it
/// would weigh nothing, and the tip of a dome would pass through a wall.
void weigh_point_on_axis(ContactSurface::Entry& entry) {
    std::vector<std::size_t> outward(entry.X.size());
    std::iota(outward.begin(), outward.end(), 0);
    std::ranges::partial_sort(outward, outward.begin() + 2, {}, [&](std::size_t q) { return entry.X[q][1]; });
    const Point &tip = entry.X[outward[0]], &next = entry.X[outward[1]];
    if (!is_on_axis(tip[1], entry.size_m)) return;
    const double moved_m2 = 0.25 * std::numbers::pi * norm(difference(next, tip)) * next[1];
    entry.weight_m2[outward[0]] += moved_m2;
    entry.weight_m2[outward[1]] -= moved_m2;
}

/// Largest prescribed pressure: walls that are pressed together by more than their modulus would overlap.
double largest_pressure_Pa(const model::Case& model) {
    double largest = 0;
    for (const model::Stage& stage : model.path.stages)
        for (const model::SupplyTarget& supply : stage.supplies)
            if (supply.what == model::Prescription::pressure) largest = std::max(largest, std::abs(supply.value));
    return largest;
}

}  // namespace

std::vector<Index> cell_corners(const mesh::Mesh& mesh, Index cell) {
    const auto nodes =
        mesh.cell_nodes(cell).first(static_cast<std::size_t>(mesh::topology(mesh.cell_type(cell)).vertex_count));
    return {nodes.begin(), nodes.end()};
}

bool share_a_side(std::span<const Index> corners, std::span<const Index> others, int dimension) {
    return std::ranges::count_if(
               corners, [&](Index node) { return std::ranges::find(others, node) != others.end(); }) >= dimension;
}

SampleRule sample_rule(mesh::CellType facet) {
    SampleRule rule;
    const mesh::Shape shape = mesh::topology(facet).shape;
    if (shape == mesh::Shape::triangle) {
        const FacetPoint a{0, 0}, b{1, 0}, c{0, 1}, ab{0.5, 0}, bc{0.5, 0.5}, ca{0, 0.5};
        for (const auto& part :
             {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
            add_triangle(rule, part, 0.125);
    } else if (shape == mesh::Shape::line) {
        for (std::size_t i = 0; i <= line_intervals; ++i) {
            const std::size_t from_end = std::min(i, line_intervals - i);
            const double weight = from_end < end_weights.size() ? end_weights[from_end] : 1;
            add_point(rule, {2.0 * static_cast<double>(i) / line_intervals - 1, 0}, 2 * weight / line_intervals);
        }
    } else {
        const auto points = simpson_in_parts(quadrilateral_parts);
        for (const auto& [t, v] : points)
            for (const auto& [s, w] : points) add_point(rule, {s, t}, v * w);
    }
    for (const FacetPoint& xi : rule.xi)
        for (const mesh::ShapeValue& value : mesh::shape_values(facet, {xi[0], xi[1], 0})) {
            rule.N.push_back(value.value);
            rule.dN.push_back({value.gradient[0], shape == mesh::Shape::line ? 0 : value.gradient[1]});
        }
    return rule;
}

double contact_distance_m(const ContactSurface::Entry& entry, const FacetPoint& xi) {
    std::array<mesh::ShapeValue, 4> shapes;
    const auto values = std::span{shapes}.first(entry.corners.size());
    mesh::shape_values(linear_facet(entry.corners.size()), {xi[0], xi[1], 0}, values);
    double h_m = 0;
    for (std::size_t a = 0; a < values.size(); ++a) h_m += values[a].value * entry.corner_h_m[a];
    return h_m;
}

bool are_facing(const ContactSurface::Entry& entry, std::size_t q, const Patch& other, const ClosestPoint& closest) {
    const Vector3 its = unit(normal_at(other, closest.xi));
    const auto faces = [&](const Vector3& n) { return is_facing(entry.undeformed, entry, q, n); };
    if (!faces(its)) return false;
    if (closest.distance_m <= touching_share_of_size * entry.size_m) return true;
    const Vector3 arm = unit(difference(entry.X[q], other(closest.xi).x));
    return dot(arm, its) > facing && faces(arm);
}

bool is_facing(const Patch& patch, const ContactSurface::Entry& entry, std::size_t q, const Vector3& normal) {
    return facing_of(patch, entry, q, normal) > facing;
}

double facing_of(const Patch& patch, const ContactSurface::Entry& entry, std::size_t q, const Vector3& normal) {
    return std::max(0.0, -dot(unit(normal_at(patch, entry.rule->xi[q])), unit(normal)));
}

NormalCone normals(const Patch& facet) {
    std::array<surface::FacetPoint, 9> nodes{};
    const auto& topology = mesh::topology(facet.type);
    const auto count = static_cast<std::size_t>(topology.node_count);
    for (std::size_t a = 0; a < count; ++a) nodes[a] = {topology.nodes[a][0], topology.nodes[a][1]};
    return normals(facet, std::span{nodes}.first(count));
}

NormalCone normals(const Patch& facet, std::span<const surface::FacetPoint> at) {
    if (at.size() > max_normals) throw std::logic_error("normals: too many points");
    std::array<Vector3, max_normals> n{};
    NormalCone cone;
    for (std::size_t a = 0; a < at.size(); ++a) {
        n[a] = normal_at(facet, at[a]);
        const double length = norm(n[a]);
        for (std::size_t d = 0; d < 3 && length > 0; ++d) cone.axis[d] += (n[a][d] /= length);
    }
    const double length = norm(cone.axis);
    if (length == 0) return {{}, std::numbers::pi};
    for (double& component : cone.axis) component /= length;
    double cosine = 1;
    for (std::size_t a = 0; a < at.size(); ++a) cosine = std::min(cosine, dot(cone.axis, n[a]));
    cone.angle = std::acos(std::max(cosine, -1.0));
    return cone;
}

ContactSurface::ContactSurface(const model::Case& model, std::span<const double> modulus_Pa)
    : dimension_(static_cast<std::size_t>(model.mesh.dimension)),
      is_revolved_(model.kinematics == model::Kinematics::axisymmetric) {
    if (!has_self_contact(model) && model.obstacles.empty()) return;  // nothing can touch
    const double pressure_Pa = largest_pressure_Pa(model);
    for (const mesh::Facet& facet : surface::free_facets(model)) {
        Entry entry;
        entry.facet = facet;
        entry.cell_corners = cell_corners(model.mesh, facet.cell);
        entry.nodes = mesh::facet_nodes(model.mesh, facet);
        for (const Index corner : mesh::facet_corners(model.mesh, facet))
            entry.corners.push_back(static_cast<std::size_t>(corner));
        entry.undeformed = make_patch(surface::facet_map(model.mesh, facet, model.mesh.points));
        const mesh::CellType type = entry.undeformed.type;
        if (!rules_.contains(type)) rules_.emplace(type, sample_rule(type));
        entry.rule = &rules_.at(type);
        double area = 0;
        for (std::size_t q = 0; q < entry.rule->xi.size(); ++q) {
            const auto at = entry.undeformed(entry.rule->xi[q]);
            const double share = entry.rule->weights[q] * norm(cross(at.t1, at.t2));
            area += share;
            entry.X.push_back(at.x);
            entry.weight_m2.push_back(share * (is_revolved_ ? 2 * std::numbers::pi * at.x[1] : 1));
        }
        entry.size_m = dimension_ == 2 ? area : std::sqrt(area);
        if (is_revolved_) weigh_point_on_axis(entry);
        entry.stiffness_Pa =
            stiffness_share *
            std::max(
                modulus_Pa[static_cast<std::size_t>(model.mesh.cell_regions[static_cast<std::size_t>(facet.cell)])],
                pressure_Pa);
        nodes_.insert(nodes_.end(), entry.nodes.begin(), entry.nodes.end());
        nodes_.insert(nodes_.end(), entry.cell_corners.begin(), entry.cell_corners.end());
        entries_.push_back(std::move(entry));
    }
    std::ranges::sort(nodes_);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    free_count_ = entries_.size();
    if (entries_.empty()) return;
    set_contact_distances(model.contact.distance);
    add_obstacles(model);
}

/// In proportion to the mean size of the facets at a corner, linear between the corners: where h jumps, so does the contact pressure.
void ContactSurface::set_contact_distances(double share) {
    struct Mean {
        double sum = 0, count = 0;
    };
    std::map<std::size_t, Mean> sizes;
    for (const Entry& entry : entries_)
        for (const std::size_t corner : entry.corners) {
            sizes[corner].sum += entry.size_m;
            ++sizes[corner].count;
        }
    for (Entry& entry : entries_) {
        for (const std::size_t corner : entry.corners)
            entry.corner_h_m.push_back(share * sizes.at(corner).sum / sizes.at(corner).count);
        for (const FacetPoint& xi : entry.rule->xi) entry.h_m.push_back(contact_distance_m(entry, xi));
        entry.distance_m = *std::ranges::max_element(entry.h_m);
        entry.range_m = std::max(entry.distance_m, overlap_share_of_size * entry.size_m);
        distance_m_ = std::max(distance_m_, entry.distance_m);
    }
}

void ContactSurface::add_obstacles(const model::Case& model) {
    std::size_t first_corner = model.mesh.points.size();
    nearest_m_.assign(model.obstacles.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < model.obstacles.size(); ++k)
        if (const auto* faceted = std::get_if<model::FacetedSurface>(&model.obstacles[k].shape)) {
            for (const auto& facet : faceted->facets) {
                Entry entry;
                entry.obstacle = static_cast<int>(k);
                surface::FacetMap map{facet[2] < 0 ? mesh::CellType::line2 : mesh::CellType::triangle3};
                for (std::size_t a = 0; a < (facet[2] < 0 ? 2 : 3); ++a) {
                    entry.corners.push_back(first_corner + static_cast<std::size_t>(facet[a]));
                    map.nodes[a] = faceted->points[static_cast<std::size_t>(facet[a])];
                }
                entry.undeformed = make_patch(map);
                entries_.push_back(std::move(entry));
            }
            first_corner += faceted->points.size();
        } else {
            const SignedDistance distance = signed_distance(model.obstacles[k]);
            for (const Entry& entry : std::span(entries_).first(free_count_))
                for (const Point& X : entry.X) nearest_m_[k] = std::min(nearest_m_[k], distance(X));
        }
    find_initial_overlaps();
}

void ContactSurface::find_initial_overlaps() {
    std::vector<surface::Box> boxes;
    for (const Entry& entry : entries_) boxes.push_back(box_within(entry.undeformed, distance_m_));
    for (const auto& [first, second] : surface::overlapping_pairs(boxes)) {
        const Entry &entry = entries_[static_cast<std::size_t>(first)],
                    &other = entries_[static_cast<std::size_t>(second)];
        add_overlaps(entry, other);
        if (other.obstacle < 0) add_overlaps(other, entry);
    }
}

void ContactSurface::add_overlaps(const Entry& entry, const Entry& other) {
    for (std::size_t q = 0; q < entry.X.size() && entry.obstacle < 0; ++q) {
        if (at_least(other.undeformed, entry.X[q]) > (other.obstacle < 0 ? entry.h_m[q] : distance_m_)) continue;
        const ClosestPoint closest = closest_point(other.undeformed, entry.X[q]);
        const double overlap = entry.h_m[q] - closest.distance_m;
        if (other.obstacle >= 0) {
            double& nearest = nearest_m_[static_cast<std::size_t>(other.obstacle)];
            nearest = std::min(nearest, closest.distance_m);
        } else if (overlap > 0 && are_facing(entry, q, other.undeformed, closest)) {
            double& largest = initial_overlap_m_[{entry.facet, q}];
            largest = std::max(largest, overlap);
        }
    }
}

double ContactSurface::initial_overlap_m(const Entry& entry, std::size_t q, int obstacle) const {
    if (obstacle >= 0) return std::max(entry.h_m[q] - nearest_m_[static_cast<std::size_t>(obstacle)], 0.0);
    const auto known = initial_overlap_m_.find({entry.facet, q});
    return known == initial_overlap_m_.end() ? 0 : known->second;
}

Adjacency ContactSurface::adjacency(std::size_t i, std::size_t j) {
    const std::uint64_t key = std::min(i, j) * entries_.size() + std::max(i, j);
    const auto known = adjacency_.find(key);
    if (known != adjacency_.end()) return known->second;
    return adjacency_.emplace(key, find_adjacency(entries_[i], entries_[j])).first->second;
}

Adjacency ContactSurface::find_adjacency(const Entry& a, const Entry& b) const {
    if (a.facet.cell == b.facet.cell) return Adjacency::sides_of_a_wall;
    if (std::ranges::any_of(a.nodes, [&](Index node) { return std::ranges::find(b.nodes, node) != b.nodes.end(); }))
        return has_facing_points(a, b) || has_facing_points(b, a) ? Adjacency::sides_of_a_groove
                                                                  : Adjacency::neighbours;
    if (share_a_side(a.cell_corners, b.cell_corners, static_cast<int>(dimension_))) return Adjacency::sides_of_a_wall;
    const double within_m = thickest_wall_in_facets * std::max(a.size_m, b.size_m);
    if (dot(normals(a.undeformed).axis, normals(b.undeformed).axis) < 0 &&
        is_behind(a.undeformed, b.undeformed, within_m) && is_behind(b.undeformed, a.undeformed, within_m))
        return Adjacency::sides_of_a_wall;
    return Adjacency::apart;
}

std::vector<Patch> ContactSurface::patches(std::span<const Point> positions, std::span<const Vector3> shifts) const {
    std::vector<Patch> patches;
    patches.reserve(entries_.size());
    for (const Entry& entry : entries_) {
        surface::FacetMap map{entry.undeformed.type, entry.undeformed.nodes};
        for (std::size_t a = 0; a < entry.nodes.size(); ++a)
            map.nodes[a] = positions[static_cast<std::size_t>(entry.nodes[a])];
        if (entry.obstacle >= 0)
            for (Point& node : map.nodes) node = along(node, 1, shifts[static_cast<std::size_t>(entry.obstacle)]);
        Patch& patch = patches.emplace_back(make_patch(map));
        const double share = 1.0 / static_cast<double>(entry.cell_corners.size());
        for (const Index corner : entry.cell_corners)
            patch.cell_centre = along(patch.cell_centre, share, positions[static_cast<std::size_t>(corner)]);
    }
    return patches;
}

}  // namespace soft::contact
