#include "mesh/arcs.hpp"

#include <algorithm>
#include <cmath>

#include "math/vector.hpp"
#include "mesh/shape.hpp"

namespace soft::mesh {
namespace {

using Xi = std::array<double, 3>;

/// sum w_i p_i
template <std::size_t N>
Point combine(const std::array<double, N>& w, const std::array<Point, N>& p) {
    Point x{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t d = 0; d < 3; ++d) x[d] += w[i] * p[i][d];
    return x;
}

/// Quadratic Lagrange polynomials of the nodes -1, 0, 1.
std::array<double, 3> quadratic(double xi) { return {xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2}; }

Point parabola_point(const Point& first, const Point& middle, const Point& last, double xi) {
    return combine<3>(quadratic(xi), {first, middle, last});
}

/// Index of xi in {-1, 0, 1}; 3 for any other value.
std::size_t node_at(double xi) { return xi == -1 ? 0 : xi == 0 ? 1 : xi == 1 ? 2 : 3; }

/// `at(i)`: point of row i of three.
template <class At>
Point along_row(const At& at, double xi) {
    const std::size_t node = node_at(xi);
    return node < 3 ? at(node) : arc_point(at(0), at(1), at(2), xi);
}

std::size_t node_number(const CellTopology& cell, const Xi& xi) {
    return static_cast<std::size_t>(std::find(cell.nodes.begin(), cell.nodes.end(), xi) - cell.nodes.begin());
}

}  // namespace

/// The point at arc delta from A is at the distance 2 R sin(delta/2) from A, at the angle (whole arc - delta)/2 to the chord AB
/// (inscribed angle theorem). This form uses only lengths and that angle, so flat arcs, whose centre is far away, lose no digits.
Point arc_point(const Point& first, const Point& middle, const Point& last, double xi) {
    const Point chord = combine<2>({1, -1}, {last, first}), rise = combine<2>({1, -1}, {middle, first}),
                rest = combine<2>({1, -1}, {last, middle});
    const double chord2 = dot(chord, chord);
    constexpr double straight = 1e-9;
    if (!(chord2 > 0)) return parabola_point(first, middle, last, xi);
    const Point up = combine<2>({1, -dot(rise, chord) / chord2}, {rise, chord});
    const double sagitta = std::sqrt(dot(up, up)), length = std::sqrt(chord2);
    if (!(sagitta > straight * length)) return parabola_point(first, middle, last, xi);
    const double a = std::sqrt(dot(rise, rise)), b = std::sqrt(dot(rest, rest));
    const double diameter = a * b / sagitta;  // a b c / (2 area), the area being c sagitta / 2
    const auto arc = [diameter](double side) { return 2 * std::asin(std::min(side / diameter, 1.0)); };
    const double to_middle = arc(a), whole = to_middle + arc(b);
    const auto weights = quadratic(xi);
    const double delta = weights[1] * to_middle + weights[2] * whole, angle = (whole - delta) / 2;
    const double distance = diameter * std::sin(delta / 2);
    return combine<3>({1, distance * std::cos(angle) / length, distance * std::sin(angle) / sagitta},
                      {first, chord, up});
}

ArcMap::ArcMap(CellType type) : cell_(&topology(type)) {
    if (cell_->order == 1) return;
    switch (cell_->shape) {
        case Shape::triangle:
        case Shape::tetrahedron:
            simplex_ = cell_;
            level_nodes_.emplace_back();
            for (std::size_t a = 0; a < cell_->nodes.size(); ++a) level_nodes_.front().push_back(a);
            break;
        case Shape::wedge:
            simplex_ = &topology(CellType::triangle6);
            for (const double zeta : {-1.0, 0.0, 1.0}) {
                level_nodes_.emplace_back();
                for (const Xi& xi : simplex_->nodes)
                    level_nodes_.back().push_back(node_number(*cell_, {xi[0], xi[1], zeta}));
            }
            break;
        case Shape::line:
        case Shape::quadrilateral:
        case Shape::hexahedron:
            for (int n = 0; n < 27; ++n) {
                const int i = n % 3 - 1, j = n / 3 % 3 - 1, k = cell_->dimension < 3 ? 0 : n / 9 - 1;
                grid_nodes_[static_cast<std::size_t>(n)] =
                    node_number(*cell_, {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
            }
            break;
    }
}

Point ArcMap::on_simplex(std::span<const Point> nodes, const Xi& xi, std::size_t level) const {
    const auto node = [&](std::size_t a) { return nodes[level_nodes_[level][a]]; };
    Point x{};
    const std::vector<ShapeValue> shapes = shape_values(simplex_->type, xi);
    for (std::size_t a = 0; a < shapes.size(); ++a)
        for (std::size_t d = 0; d < 3; ++d) x[d] += shapes[a].value * node(a)[d];
    const std::vector<double> l = vertex_values(simplex_->type, xi);
    for (std::size_t i = 0; i < l.size(); ++i)
        for (std::size_t j = i + 1; j < l.size(); ++j) {
            if (!(l[i] * l[j] > 0)) continue;
            const Xi &p = simplex_->nodes[i], &q = simplex_->nodes[j];
            const Point &first = node(i), &last = node(j),
                        &middle =
                            node(node_number(*simplex_, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}));
            const double at = l[j] - l[i], blend = 4 * l[i] * l[j] / (1 - at * at);
            const Point arc = arc_point(first, middle, last, at), parabola = parabola_point(first, middle, last, at);
            x = combine<3>({1, blend, -blend}, {x, arc, parabola});
        }
    return x;
}

Point ArcMap::operator()(std::span<const Point> nodes, const Xi& xi) const {
    if (cell_->order == 1) {
        Point x{};
        const std::vector<ShapeValue> shapes = shape_values(cell_->type, xi);
        for (std::size_t a = 0; a < shapes.size(); ++a)
            for (std::size_t d = 0; d < 3; ++d) x[d] += shapes[a].value * nodes[a][d];
        return x;
    }
    if (cell_->shape == Shape::wedge) {
        const auto level = [&](std::size_t k) { return on_simplex(nodes, {xi[0], xi[1], 0}, k); };
        return along_row(level, xi[2]);
    }
    if (simplex_ != nullptr) return on_simplex(nodes, xi, 0);
    const auto row = [&](std::size_t j, std::size_t k) {
        return along_row([&](std::size_t i) { return nodes[grid_nodes_[i + 3 * j + 9 * k]]; }, xi[0]);
    };
    const auto layer = [&](std::size_t k) {
        if (cell_->dimension < 2) return row(1, k);
        return along_row([&](std::size_t j) { return row(j, k); }, xi[1]);
    };
    if (cell_->dimension < 3) return layer(1);
    return along_row(layer, xi[2]);
}

}  // namespace soft::mesh
