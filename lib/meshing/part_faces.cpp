#include "meshing/part_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

using mesh::Point;

/// Divides the facets of a surface into regions.
class Regions {
public:
    explicit Regions(const BodySurface& surface) : surface_(surface), region_(surface.triangles.size(), none) {
        for (const auto& t : surface.triangles) facets_.push_back(triangle_geometry(surface.points, t));
        around_.resize(surface.triangles.size());
        for (const auto& [edge, sides] : edges_with_sides(surface)) {
            around_[sides[0]].push_back(sides[1]);
            around_[sides[1]].push_back(sides[0]);
        }
    }

    std::vector<PartFace> take() {
        find_planes();
        find_curved();
        std::ranges::stable_sort(faces_, std::greater{}, &PartFace::area_m2);
        return std::move(faces_);
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    /// Assigns to `region` all facets without a region that are connected to `start` by steps for which `joins(from, to)` is true.
    template <class Joins>
    std::vector<std::size_t> flood(std::size_t start, std::size_t region, Joins&& joins) {
        std::vector<std::size_t> found{start};
        region_[start] = region;
        for (std::size_t k = 0; k < found.size(); ++k)
            for (const std::size_t next : around_[found[k]])
                if (region_[next] == none && joins(found[k], next)) {
                    region_[next] = region;
                    found.push_back(next);
                }
        return found;
    }

    [[nodiscard]] double area(const std::vector<std::size_t>& facets) const {
        return std::accumulate(facets.begin(), facets.end(), 0.0,
                               [&](double sum, std::size_t f) { return sum + facets_[f].area; });
    }

    void find_planes() {
        constexpr double flat = 1e-5, parallel = 0.9994;  // 2 degrees: rounded coordinates tilt thin facets
        const double near_m = flat * surface_.extent_m();
        std::vector<std::size_t> order(facets_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, std::greater{}, [&](std::size_t f) { return facets_[f].area; });
        std::vector<std::vector<std::size_t>> regions;
        for (const std::size_t seed : order) {
            if (region_[seed] != none) continue;
            const TriangleGeometry& plane = facets_[seed];
            regions.push_back(flood(seed, regions.size(), [&](std::size_t, std::size_t next) {
                if (dot(facets_[next].normal, plane.normal) < parallel) return false;
                return std::ranges::all_of(surface_.triangles[next], [&](int corner) {
                    const Point& p = surface_.points[static_cast<std::size_t>(corner)];
                    return std::abs(dot(along(p, -1, plane.centre), plane.normal)) <= near_m;
                });
            }));
        }
        keep_planes(regions);
    }

    /// Keeps regions much larger than their smooth neighbours: a strip of a curved surface has neighbours of similar area.
    void keep_planes(const std::vector<std::vector<std::size_t>>& regions) {
        constexpr double larger = 4;
        static const double smooth = std::cos(sharp_rad);
        std::vector<double> areas, max_beside(regions.size());
        for (const auto& facets : regions) areas.push_back(area(facets));
        for (std::size_t f = 0; f < facets_.size(); ++f)
            for (const std::size_t next : around_[f])
                if (region_[next] != region_[f] && dot(facets_[f].normal, facets_[next].normal) > smooth)
                    max_beside[region_[f]] = std::max(max_beside[region_[f]], areas[region_[next]]);
        const std::vector<std::size_t> all = region_;
        std::ranges::fill(region_, none);
        for (std::size_t r = 0; r < regions.size(); ++r) {
            if (areas[r] < larger * max_beside[r]) continue;
            PartFace face;
            face.shape = PartFace::Shape::plane;
            face.facets = regions[r];
            for (const std::size_t f : face.facets) region_[f] = r;
            face.direction = facets_[face.facets.front()].normal;
            add(std::move(face));
        }
    }

    void find_curved() {
        static const double smooth = std::cos(sharp_rad);
        for (std::size_t seed = 0; seed < facets_.size(); ++seed) {
            if (region_[seed] != none) continue;
            PartFace face;
            face.facets = flood(seed, facets_.size() + seed, [&](std::size_t from, std::size_t next) {
                return dot(facets_[from].normal, facets_[next].normal) > smooth;
            });
            fit_cylinder(face);
            add(std::move(face));
        }
    }

    void add(PartFace face) {
        face.area_m2 = area(face.facets);
        const std::size_t largest =
            *std::ranges::max_element(face.facets, {}, [&](std::size_t f) { return facets_[f].area; });
        face.on_face = facets_[largest].centre;
        if (face.shape != PartFace::Shape::cylinder)
            for (const std::size_t f : face.facets)
                for (std::size_t d = 0; d < 3; ++d)
                    face.centre[d] += facets_[f].area * facets_[f].centre[d] / face.area_m2;
        faces_.push_back(std::move(face));
    }

    /// The direction most nearly perpendicular to the normals: eigenvector of the largest eigenvalue of trace(M) I - M with
    /// M = sum of area n n^T, by power iteration.
    [[nodiscard]] Vector3 axis_of(const std::vector<std::size_t>& facets) const {
        constexpr int rounds = 200;
        std::array<Vector3, 3> rest{};  // trace(M) I - M
        for (const std::size_t f : facets)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    rest[i][j] += facets_[f].area * ((i == j ? 1 : 0) - facets_[f].normal[i] * facets_[f].normal[j]);
        Vector3 axis{1, 0.7, 0.4};
        for (int k = 0; k < rounds; ++k) {
            Vector3 next{dot(rest[0], axis), dot(rest[1], axis), dot(rest[2], axis)};
            const double length = norm(next);
            for (std::size_t d = 0; d < 3; ++d) axis[d] = next[d] / length;
        }
        const auto longest = std::ranges::max_element(axis, {}, [](double x) { return std::abs(x); });
        if (*longest < 0)
            for (double& x : axis) x = -x;
        return axis;
    }

    void fit_cylinder(PartFace& face) const {
        constexpr double agrees = 1e-3;
        const Vector3 axis = axis_of(face.facets);
        for (const std::size_t f : face.facets)
            if (std::abs(dot(facets_[f].normal, axis)) > 10 * agrees) return;
        const Vector3 u = unit_across(axis), v = cross(axis, u);
        std::vector<Point> corners;
        for (const std::size_t f : face.facets)
            for (const int corner : surface_.triangles[f])
                corners.push_back(surface_.points[static_cast<std::size_t>(corner)]);
        const auto circle = fit_circle(corners, u, v);
        if (!circle) return;
        const auto [a, b, radius] = *circle;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Point& p : corners) {
            if (std::abs(std::hypot(dot(p, u) - a, dot(p, v) - b) - radius) > agrees * radius) return;
            low = std::min(low, dot(p, axis));
            high = std::max(high, dot(p, axis));
        }
        face.shape = PartFace::Shape::cylinder;
        face.direction = axis;
        face.radius_m = radius;
        for (std::size_t d = 0; d < 3; ++d) face.centre[d] = a * u[d] + b * v[d] + 0.5 * (low + high) * axis[d];
        const TriangleGeometry& one = facets_[face.facets.front()];
        face.is_bore = dot(one.normal, along(one.centre, -1, face.centre)) < 0;
    }

    static Vector3 unit_across(const Vector3& axis) {
        const std::size_t least = static_cast<std::size_t>(
            std::ranges::min_element(axis, {}, [](double x) { return std::abs(x); }) - axis.begin());
        Vector3 unit{};
        unit[least] = 1;
        Vector3 u = cross(axis, unit);
        const double length = norm(u);
        for (double& x : u) x /= length;
        return u;
    }

    struct Circle {
        double a, b, radius;
    };
    /// Least squares of p^2 = 2 a u + 2 b v + c about the mean (I. Kasa, IEEE Trans. Instrum. Meas. 25, 1976).
    static std::optional<Circle> fit_circle(const std::vector<Point>& corners, const Vector3& u, const Vector3& v) {
        const double count = static_cast<double>(corners.size());
        double mu = 0, mv = 0;
        for (const Point& p : corners) {
            mu += dot(p, u) / count;
            mv += dot(p, v) / count;
        }
        double uu = 0, uv = 0, vv = 0, uz = 0, vz = 0;
        for (const Point& p : corners) {
            const double x = dot(p, u) - mu, y = dot(p, v) - mv, z = x * x + y * y;
            uu += x * x, uv += x * y, vv += y * y, uz += x * z, vz += y * z;
        }
        const double determinant = uu * vv - uv * uv;
        if (!(determinant > 1e-12 * uu * vv)) return std::nullopt;
        const double a = 0.5 * (uz * vv - vz * uv) / determinant, b = 0.5 * (vz * uu - uz * uv) / determinant;
        return Circle{mu + a, mv + b, std::sqrt((uu + vv) / count + a * a + b * b)};
    }

    const BodySurface& surface_;
    std::vector<TriangleGeometry> facets_;
    std::vector<std::vector<std::size_t>> around_;
    std::vector<std::size_t> region_;
    std::vector<PartFace> faces_;
};

FaceRule::Box box_around(const BodySurface& surface, const PartFace& face) {
    FaceRule::Box box;
    box.from.fill(std::numeric_limits<double>::infinity());
    box.to.fill(-std::numeric_limits<double>::infinity());
    for (const std::size_t f : face.facets)
        for (const int corner : surface.triangles[f])
            for (std::size_t d = 0; d < 3; ++d) {
                const double x = surface.points[static_cast<std::size_t>(corner)][d];
                box.from[d] = std::min(box.from[d], x);
                box.to[d] = std::max(box.to[d], x);
            }
    return box;
}

/// Candidate rules for a face, the simplest first.
std::vector<FaceRule> candidates(const BodySurface& surface, const PartFace& face) {
    constexpr double along_an_axis = 1 - 1e-9, within_rad = 0.05;
    const FaceRule empty{"face", {}, {}, {}, {}};
    std::vector<FaceRule> rules;
    const FaceRule::Box box = box_around(surface, face);
    if (face.shape == PartFace::Shape::plane)
        for (std::size_t d = 0; d < 3; ++d)
            if (std::abs(face.direction[d]) > along_an_axis) {
                rules.push_back(empty);
                rules.back().plane = FaceRule::Plane{d, face.on_face[d]};
                rules.push_back(rules.back());
                rules.back().box = box;
            }
    rules.push_back(empty);
    rules.back().flood = FaceRule::Flood{face.on_face, {}};
    rules.push_back(empty);
    rules.back().box = box;
    if (face.shape == PartFace::Shape::plane) {
        rules.push_back(rules.back());
        rules.back().direction = FaceRule::Direction{face.direction, within_rad};
    }
    return rules;
}

}  // namespace

std::vector<PartFace> part_faces(const BodySurface& surface) {
    std::vector<PartFace> faces = Regions{surface}.take();
    for (PartFace& face : faces) {
        std::vector<bool> own(surface.triangles.size());
        for (const std::size_t f : face.facets) own[f] = true;
        for (const FaceRule& rule : candidates(surface, face))
            if (named_faces(surface, {rule}).back().facets == own) {
                face.rule = rule;
                break;
            }
    }
    return faces;
}

}  // namespace soft::meshing
