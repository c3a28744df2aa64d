#include "view/obstacle_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <variant>

#include "fem/plane_axes.hpp"

namespace soft::view {

namespace {

using Curve = std::vector<Point>;

constexpr int samples = 96;  // per curve
constexpr int grid_lines = 8, generators = 16, meridians = 12;

Point sum(const Point& a, double s, const Vector3& e, double t = 0, const Vector3& f = {}) {
    return along(along(a, s, e), t, f);
}

Curve line(const Point& middle, const Vector3& direction, double half) {
    Curve curve;
    for (int i = 0; i <= samples; ++i) curve.push_back(along(middle, half * (2.0 * i / samples - 1), direction));
    return curve;
}

Curve circle(const Point& center, double radius, const Vector3& e, const Vector3& f) {
    Curve curve;
    for (int i = 0; i <= samples; ++i) {
        const double angle = 2 * std::numbers::pi * i / samples;
        curve.push_back(sum(center, radius * std::cos(angle), e, radius * std::sin(angle), f));
    }
    return curve;
}

/// In the plane of the directions i and j, at a position along the other one.
std::vector<Curve> rectangle(const model::Box& box, std::size_t i, std::size_t j, double across) {
    Point middle{across, across, across};
    std::array<double, 3> half{};
    for (const std::size_t d : {i, j}) {
        middle[d] = 0.5 * (box.low[d] + box.high[d]);
        half[d] = 0.5 * (box.high[d] - box.low[d]) - box.radius_m;
    }
    const auto unit = [](std::size_t d, double sign) {
        Vector3 e{};
        e[d] = sign;
        return e;
    };
    std::vector<Curve> curves;
    for (const double a : {-1.0, 1.0}) {
        curves.push_back(line(along(middle, half[i] + box.radius_m, unit(i, a)), unit(j, 1), half[j]));
        curves.push_back(line(along(middle, half[j] + box.radius_m, unit(j, a)), unit(i, 1), half[i]));
        for (const double b : {-1.0, 1.0}) {
            const Curve whole =
                circle(sum(middle, half[i], unit(i, a), half[j], unit(j, b)), box.radius_m, unit(i, a), unit(j, b));
            curves.emplace_back(whole.begin(), whole.begin() + samples / 4 + 1);
        }
    }
    return curves;
}

struct Frame {
    Point center;  ///< of the window
    double half;   ///< of its diagonal
};

std::vector<Curve> edges(const model::FacetedSurface& surface) {
    std::set<std::array<int, 2>> pairs;
    for (const auto& facet : surface.facets) {
        const std::size_t corners = facet[2] < 0 ? 2 : 3;
        for (std::size_t k = 0; k < corners; ++k)
            pairs.insert({std::min(facet[k], facet[(k + 1) % corners]), std::max(facet[k], facet[(k + 1) % corners])});
    }
    std::vector<Curve> curves;
    for (const auto& [a, b] : pairs) {
        const Point &from = surface.points[static_cast<std::size_t>(a)],
                    &to = surface.points[static_cast<std::size_t>(b)];
        const Vector3 half = along({}, 0.5, difference(to, from));
        curves.push_back(line(along(from, 1, half), half, 1));
    }
    return curves;
}

struct InSpace {
    Frame at;
    std::vector<Curve> operator()(const model::Plane& plane) const {
        const auto [e, f] = fem::plane_axes(plane.normal);
        const double height = dot(difference(at.center, plane.point), plane.normal);
        const Point middle = along(at.center, -height, plane.normal);
        std::vector<Curve> curves;
        for (int k = -grid_lines; k <= grid_lines; ++k) {
            curves.push_back(line(along(middle, k * at.half / grid_lines, e), f, at.half));
            curves.push_back(line(along(middle, k * at.half / grid_lines, f), e, at.half));
        }
        return curves;
    }
    std::vector<Curve> operator()(const model::Cylinder& cylinder) const {
        const auto [e, f] = fem::plane_axes(cylinder.axis);
        const Point middle =
            along(cylinder.point, dot(difference(at.center, cylinder.point), cylinder.axis), cylinder.axis);
        std::vector<Curve> curves;
        for (int k = -grid_lines; k <= grid_lines; ++k)
            curves.push_back(circle(along(middle, k * at.half / grid_lines, cylinder.axis), cylinder.radius_m, e, f));
        for (int k = 0; k < generators; ++k) {
            const double angle = 2 * std::numbers::pi * k / generators;
            curves.push_back(
                line(sum(middle, cylinder.radius_m * std::cos(angle), e, cylinder.radius_m * std::sin(angle), f),
                     cylinder.axis, at.half));
        }
        return curves;
    }
    std::vector<Curve> operator()(const model::Sphere& sphere) const {
        std::vector<Curve> curves;
        for (int k = 0; k < meridians / 2; ++k) {
            const double angle = 2 * std::numbers::pi * k / meridians;
            curves.push_back(circle(sphere.center, sphere.radius_m, {1, 0, 0}, {0, std::cos(angle), std::sin(angle)}));
        }
        for (int k = 1; k < meridians / 2; ++k) {
            const double angle = 2 * std::numbers::pi * k / meridians;
            curves.push_back(circle(along(sphere.center, sphere.radius_m * std::cos(angle), {1, 0, 0}),
                                    sphere.radius_m * std::sin(angle), {0, 1, 0}, {0, 0, 1}));
        }
        return curves;
    }
    std::vector<Curve> operator()(const model::Box& box) const {
        std::vector<Curve> curves;
        for (std::size_t d = 0; d < 3; ++d)
            for (const double across : {box.low[d] + box.radius_m, box.high[d] - box.radius_m})
                for (Curve& curve : rectangle(box, (d + 1) % 3, (d + 2) % 3, across))
                    curves.push_back(std::move(curve));
        return curves;
    }
    std::vector<Curve> operator()(const model::FacetedSurface& surface) const { return edges(surface); }
};

/// In the plane of a section.
struct InSection {
    Frame at;
    bool revolved;
    std::vector<Curve> operator()(const model::Plane& plane) const {
        const double height = dot(difference(at.center, plane.point), plane.normal);
        return {line(along(at.center, -height, plane.normal), {-plane.normal[1], plane.normal[0], 0}, at.half)};
    }
    std::vector<Curve> operator()(const model::Cylinder& cylinder) const {
        if (!revolved) return {circle(cylinder.point, cylinder.radius_m, {1, 0, 0}, {0, 1, 0})};
        return {line({at.center[0], cylinder.radius_m, 0}, {1, 0, 0}, at.half)};
    }
    std::vector<Curve> operator()(const model::Sphere& sphere) const {
        return {circle(sphere.center, sphere.radius_m, {1, 0, 0}, {0, 1, 0})};
    }
    std::vector<Curve> operator()(const model::Box& box) const { return rectangle(box, 0, 1, 0); }
    std::vector<Curve> operator()(const model::FacetedSurface& surface) const { return edges(surface); }
};

/// Meridians, and circles through a few points.
std::vector<Curve> revolve(const std::vector<Curve>& section) {
    std::vector<Curve> curves;
    for (const Curve& curve : section) {
        for (int k = 0; k < meridians; ++k) {
            const double angle = 2 * std::numbers::pi * k / meridians;
            Curve& turned = curves.emplace_back();
            for (const Point& p : curve)
                if (p[1] >= 0) turned.push_back({p[0], p[1] * std::cos(angle), p[1] * std::sin(angle)});
        }
        for (std::size_t i = 0; i < curve.size(); i += samples / grid_lines)
            if (curve[i][1] > 0) curves.push_back(circle({curve[i][0], 0, 0}, curve[i][1], {0, 1, 0}, {0, 0, 1}));
    }
    return curves;
}

void add_inside(std::vector<Line>& lines, const std::vector<Curve>& curves, const Vector3& signs,
                const Window& window) {
    const auto mirrored = [&](const Point& p) { return Point{signs[0] * p[0], signs[1] * p[1], signs[2] * p[2]}; };
    const auto inside = [&](const Point& p) {
        for (std::size_t d = 0; d < 3; ++d)
            if (p[d] < window.low[d] || p[d] > window.high[d]) return false;
        return true;
    };
    for (const Curve& curve : curves)
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const Line piece{mirrored(curve[i]), mirrored(curve[i + 1])};
            if (inside(piece[0]) && inside(piece[1])) lines.push_back(piece);
        }
}

/// Signs of the coordinates of the actuator and of its mirror images.
std::vector<Vector3> images(const model::Case& model, Extent extent) {
    const bool is_mirrored =
        (extent == Extent::opened || extent == Extent::whole) && model.kinematics != model::Kinematics::plane_strain;
    std::vector<Vector3> signs{{1, 1, 1}};
    for (std::size_t d = 0; d < 3; ++d) {
        if (!is_mirrored || !model.symmetry_planes[d]) continue;
        const std::size_t count = signs.size();
        for (std::size_t i = 0; i < count; ++i) {
            signs.push_back(signs[i]);
            signs.back()[d] = -1;
        }
    }
    return signs;
}

}  // namespace

std::vector<Line> obstacle_lines(const model::Case& model, const model::Obstacle& obstacle, const Vector3& shift,
                                 const Window& window, Extent extent) {
    const Point middle = along(along({}, 0.5, window.low), 0.5, window.high);
    const Frame at{difference(middle, shift), 0.5 * norm(difference(window.high, window.low))};
    const bool solid = model.kinematics == model::Kinematics::solid,
               revolved = model.kinematics == model::Kinematics::axisymmetric;
    std::vector<Curve> curves = std::visit(
        [&](const auto& shape) {
            return solid ? InSpace{at}(shape) : InSection{at, revolved}(shape);
        },
        obstacle.shape);
    for (Curve& curve : curves)
        for (Point& p : curve) p = along(p, 1, shift);
    if (revolved && extent != Extent::flat) curves = revolve(curves);
    std::vector<Line> lines;
    for (const Vector3& signs : images(model, extent)) add_inside(lines, curves, signs, window);
    return lines;
}

}  // namespace soft::view
