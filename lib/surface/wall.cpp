#include "surface/wall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "surface/cgal_queries.hpp"
#include "surface/facet_map.hpp"
#include "surface/free_facets.hpp"
#include "surface/triangles.hpp"
#include "surface/volume.hpp"

namespace soft::surface {
namespace {

using mesh::Point;
/// Start points of the rays: inside the facet, because at a sharp corner the normal at the edge runs along the neighbouring face.
std::vector<FacetPoint> samples(mesh::Shape shape) {
    switch (shape) {
        case mesh::Shape::line: return {{-0.8, 0}, {0, 0}, {0.8, 0}};
        case mesh::Shape::triangle: return {{1 / 6.0, 1 / 6.0}, {2 / 3.0, 1 / 6.0}, {1 / 6.0, 2 / 3.0}};
        case mesh::Shape::quadrilateral: return {{-0.6, -0.6}, {0.6, -0.6}, {-0.6, 0.6}, {0.6, 0.6}};
        default: return {};  // cells are not facets
    }
}

/// Distance along the ray to the curved facet, by Newton's method from the hit on the triangle; the distance to the triangle if the
/// ray misses the curved facet.
double on_curved_facet(const FacetMap& map, const Point& from, const Vector3& direction, double first_guess_m) {
    const bool is_triangle = mesh::topology(map.type).shape == mesh::Shape::triangle;
    FacetPoint xi{is_triangle ? 1 / 3.0 : 0, is_triangle ? 1 / 3.0 : 0};
    double t = first_guess_m;
    double size = 0;
    for (int iteration = 0; iteration < 12; ++iteration) {
        const FacetMap::Value at = map(xi);
        size = std::max({size, norm(at.t1), mesh::dimension(map.type) == 1 ? 0 : norm(at.t2)});
        // t1 du + t2 dv - d dt = p + t d - x, by Cramer's rule
        const Vector3 gap = along(along(from, t, direction), -1, at.x);
        const double determinant = -dot(direction, cross(at.t1, at.t2));
        if (determinant == 0) return first_guess_m;
        const double du = -dot(direction, cross(gap, at.t2)) / determinant;
        const double dv = -dot(direction, cross(at.t1, gap)) / determinant;
        const double dt = dot(gap, cross(at.t1, at.t2)) / determinant;
        xi = {xi[0] + du, xi[1] + dv};
        t += dt;
        if (std::abs(dt) <= 1e-12 * size) break;
    }
    constexpr double sagitta = 0.25;  // of the facet's half length: no valid second-order facet has a larger one
    return std::abs(t - first_guess_m) <= sagitta * size ? t : first_guess_m;
}

class WallProbe {
public:
    WallProbe(const model::Case& model, const model::Cavity& cavity)
        : model_(&model),
          cavity_(cavity_facets(model, cavity)),
          boundary_(free_facets(model)),
          mirrors_(mirrors(model)) {
        tree_.emplace(facet_triangles(model.mesh, boundary_));
    }

    [[nodiscard]] std::size_t facet_count() const { return cavity_.size(); }
    [[nodiscard]] FacetMap map(std::size_t facet) const {
        return facet_map(model_->mesh, cavity_[facet], model_->mesh.points);
    }

    /// Wall thickness at a point of a cavity facet.
    [[nodiscard]] std::optional<WallThickness> at(std::size_t facet, const FacetMap& map, const FacetPoint& xi) const {
        const FacetMap::Value start = map(xi);
        Vector3 d = cross(start.t2, start.t1);  // into the rubber
        const double length_of_d = norm(d);
        if (!(length_of_d > 0)) return std::nullopt;
        for (double& component : d) component /= length_of_d;
        const auto length = trace(start.x, d, boundary_number(facet));
        if (!length) return std::nullopt;
        return WallThickness{*length, start.x};
    }

private:
    [[nodiscard]] FacetMap boundary_map(int number) const {
        return facet_map(model_->mesh, boundary_[static_cast<std::size_t>(number)], model_->mesh.points);
    }

    [[nodiscard]] int boundary_number(std::size_t facet) const {  // boundary facets are sorted
        const auto found = std::lower_bound(boundary_.begin(), boundary_.end(), cavity_[facet]);
        return found != boundary_.end() && *found == cavity_[facet] ? static_cast<int>(found - boundary_.begin()) : -1;
    }

    [[nodiscard]] std::optional<double> trace(Point from, Vector3 d, int skip) const {
        constexpr int max_reflections = 8;
        double length = 0;
        for (int leg = 0; leg <= max_reflections; ++leg) {
            std::optional<RayTree::Hit> hit = tree_->first_hit(from, d, skip);
            if (hit) hit->distance_m = on_curved_facet(boundary_map(hit->facet), from, d, hit->distance_m);
            std::size_t plane = 3;
            double to_plane = hit ? hit->distance_m : std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < 3; ++k)
                if (mirrors_[k] && from[k] * d[k] < 0 && -from[k] / d[k] < to_plane) {
                    to_plane = -from[k] / d[k];
                    plane = k;
                }
            if (plane == 3) return hit ? std::optional(length + hit->distance_m) : std::nullopt;
            from = along(from, to_plane, d);
            from[plane] = 0;
            d[plane] = -d[plane];
            length += to_plane;
            skip = -1;
        }
        return std::nullopt;
    }

    const model::Case* model_;
    std::vector<mesh::Facet> cavity_, boundary_;
    std::array<bool, 3> mirrors_;
    std::optional<RayTree> tree_;
};

/// Pattern search along the reference coordinates with step halving, from the best sample of the best facet.
WallThickness search(const WallProbe& probe, std::size_t facet, FacetPoint xi, WallThickness best) {
    constexpr int halvings = 8;  // 0.4 / 2^8 of a facet: far below the resolution of a mesh
    const FacetMap map = probe.map(facet);
    const mesh::Shape shape = mesh::topology(map.type).shape;
    double step = 0.4;
    for (int round = 0; round < halvings; step /= 2, ++round)
        for (const FacetPoint& move :
             {FacetPoint{step, 0}, FacetPoint{-step, 0}, FacetPoint{0, step}, FacetPoint{0, -step}}) {
            const FacetPoint next{xi[0] + move[0], xi[1] + move[1]};
            if (!is_inside(shape, next, 0.02)) continue;  // the margin that the samples keep
            const auto wall = probe.at(facet, map, next);
            if (!wall || !(wall->thickness_m < best.thickness_m)) continue;
            best = *wall;
            xi = next;
        }
    return best;
}

}  // namespace

std::optional<WallThickness> min_wall(const model::Case& model, const model::Cavity& cavity) {
    const WallProbe probe(model, cavity);
    std::optional<WallThickness> best;
    std::size_t best_facet = 0;
    FacetPoint best_sample{};
    for (std::size_t facet = 0; facet < probe.facet_count(); ++facet) {
        const FacetMap map = probe.map(facet);
        for (const FacetPoint& xi : samples(mesh::topology(map.type).shape)) {
            const auto wall = probe.at(facet, map, xi);
            if (!wall || (best && !(wall->thickness_m < best->thickness_m))) continue;
            best = wall;
            best_facet = facet;
            best_sample = xi;
        }
    }
    if (best) best = search(probe, best_facet, best_sample, *best);
    return best;
}

}  // namespace soft::surface
