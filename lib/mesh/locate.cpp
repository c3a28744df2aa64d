#include "mesh/locate.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/cell_map.hpp"

namespace soft::mesh {
namespace {

using Xi = std::array<double, 3>;

/// Newton's method converges in a few steps in a valid cell. An iterate farther outside than the size of the cell means that the
/// cell does not contain the point.
constexpr int max_iterations = 20;
constexpr double converged = 1e-13, lost = 4.0;

/// Distance of xi from the reference cell; negative inside.
double outside(Shape shape, const Xi& xi) {
    const auto interval = [](double x) { return std::abs(x) - 1.0; };
    const double simplex = std::max({-xi[0], -xi[1], xi[0] + xi[1] - 1.0});
    switch (shape) {
        case Shape::line: return interval(xi[0]);
        case Shape::quadrilateral: return std::max(interval(xi[0]), interval(xi[1]));
        case Shape::hexahedron: return std::max({interval(xi[0]), interval(xi[1]), interval(xi[2])});
        case Shape::triangle: return simplex;
        case Shape::wedge: return std::max(simplex, interval(xi[2]));
        case Shape::tetrahedron: return std::max({-xi[0], -xi[1], -xi[2], xi[0] + xi[1] + xi[2] - 1.0});
    }
    return lost;
}

/// Solves m d = r for the leading dimension x dimension block by Cramer's rule.
Xi solve(int dimension, const std::array<double, 9>& m, const Xi& r, double determinant) {
    if (dimension == 2)
        return {(r[0] * m[4] - m[1] * r[1]) / determinant, (m[0] * r[1] - r[0] * m[3]) / determinant, 0};
    const auto replaced = [&](std::size_t column) {
        std::array<double, 9> n = m;
        for (std::size_t i = 0; i < 3; ++i) n[3 * i + column] = r[i];
        return n[0] * (n[4] * n[8] - n[5] * n[7]) - n[1] * (n[3] * n[8] - n[5] * n[6]) +
               n[2] * (n[3] * n[7] - n[4] * n[6]);
    };
    return {replaced(0) / determinant, replaced(1) / determinant, replaced(2) / determinant};
}

std::optional<Xi> reference_coordinates(const Mesh& mesh, Index cell, const Point& point) {
    const CellType type = mesh.cell_type(cell);
    Xi xi = reference_centre(type);
    for (int i = 0; i < max_iterations; ++i) {
        const CellMap map = map_cell(mesh, cell, shape_values(type, xi));
        if (map.determinant == 0.0) return std::nullopt;
        const Xi off{point[0] - map.position[0], point[1] - map.position[1], point[2] - map.position[2]};
        const Xi step = solve(mesh.dimension, map.dX_dxi, off, map.determinant);
        for (std::size_t k = 0; k < 3; ++k) xi[k] += step[k];
        const double size = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
        if (!(size < lost) || outside(topology(type).shape, xi) > lost) return std::nullopt;
        if (size < converged) return xi;
    }
    return std::nullopt;
}

bool is_in_bounding_box(const Mesh& mesh, Index cell, const Point& point) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.dimension); ++i) {
        double low = mesh.point(mesh.cell_nodes(cell)[0])[i], high = low;
        for (const Index node : mesh.cell_nodes(cell)) {
            low = std::min(low, mesh.point(node)[i]);
            high = std::max(high, mesh.point(node)[i]);
        }
        const double margin = 0.5 * (high - low);  // a curved side extends beyond its nodes
        if (point[i] < low - margin || point[i] > high + margin) return false;
    }
    return true;
}

}  // namespace

std::optional<Location> locate(const Mesh& mesh, const Point& point) {
    constexpr double same = 1e-9;  // rounding of coordinates on a side that two cells share
    std::optional<Location> found;
    double least = locate_tolerance;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        if (!is_in_bounding_box(mesh, cell, point)) continue;
        const auto xi = reference_coordinates(mesh, cell, point);
        if (!xi) continue;
        const double distance = outside(topology(mesh.cell_type(cell)).shape, *xi);
        if (!(distance < (found ? least - same : least))) continue;
        least = distance;
        found = Location{cell, {}};
        for (const ShapeValue& shape : shape_values(mesh.cell_type(cell), *xi)) found->weights.push_back(shape.value);
    }
    return found;
}

Index nearest_node(const Mesh& mesh, const Point& point) {
    Index nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
        const Point& X = mesh.points[node];
        const double distance = std::hypot(X[0] - point[0], X[1] - point[1], X[2] - point[2]);
        if (distance >= least) continue;
        least = distance;
        nearest = static_cast<Index>(node);
    }
    return nearest;
}

}  // namespace soft::mesh
