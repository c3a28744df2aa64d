#include "contact/patch.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/shape.hpp"

namespace soft::contact {

namespace {

/// A second-order facet reaches beyond the ball of its nodes by less than this fraction.
constexpr double beyond_ball = 1.25;

/// Coefficients of the shape functions: N_a = sum of table[k][a] xi^i eta^j, k = 3 i + j. The polynomials have degree 2 at most in each
/// coordinate, so Taylor's formula at the origin with central differences is exact.
using Table = std::array<std::array<double, 9>, 9>;

Table make_table(mesh::CellType type) {
    Table table{};
    const auto N = [type](double xi, double eta) { return mesh::shape_values(type, {xi, eta, 0}); };
    const bool line = mesh::dimension(type) == 1;
    // Weights of the values at -1, 0, 1 in the coefficients of 1, s, s^2.
    constexpr std::array<std::array<double, 3>, 3> weights{{{0, 1, 0}, {-0.5, 0, 0.5}, {0.5, -1, 0.5}}};
    for (int p = 0; p < 3; ++p)
        for (int q = 0; q < 3; ++q) {
            if (line && q != 1) continue;
            const auto values = N(p - 1, line ? 0 : q - 1);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    for (std::size_t a = 0; a < values.size(); ++a)
                        table[3 * i + j][a] += weights[i][static_cast<std::size_t>(p)] *
                                               weights[j][static_cast<std::size_t>(q)] * values[a].value;
        }
    return table;
}

const Table& table_of(mesh::CellType type) {
    static const std::map<mesh::CellType, Table> tables = [] {
        std::map<mesh::CellType, Table> made;
        for (const auto facet : {mesh::CellType::line2, mesh::CellType::line3, mesh::CellType::triangle3,
                                 mesh::CellType::triangle6, mesh::CellType::quad4, mesh::CellType::quad9})
            made.emplace(facet, make_table(facet));
        return made;
    }();
    return tables.at(type);
}

/// Between the coefficients of a facet: those of a line contain eta^0 only.
std::size_t stride_of(const Patch& patch) { return patch.is_line() ? 3 : 1; }

/// Each monomial s^i t^j of a quadrilateral or line lies in [0, 1] for even i and j, else in [-1, 1]; of a triangle always in [0, 1].
void find_boxes(Patch& patch) {
    const bool triangle = mesh::topology(patch.type).shape == mesh::Shape::triangle;
    const auto middle = patch({});
    const Vector3 normal = cross(middle.t1, middle.t2);
    patch.axes[0] = along({}, 1 / norm(middle.t1), middle.t1);
    patch.axes[2] = along({}, 1 / norm(normal), normal);
    patch.axes[1] = cross(patch.axes[2], patch.axes[0]);
    patch.low = patch.high = patch.c[0];
    for (std::size_t d = 0; d < 3; ++d) patch.oriented_low[d] = patch.oriented_high[d] = dot(patch.axes[d], patch.c[0]);
    const std::size_t stride = stride_of(patch);
    for (std::size_t k = stride; k < 9; k += stride) {
        const bool even = triangle || (k / 3 % 2 == 0 && k % 3 % 2 == 0);
        const auto add = [even](double c, double& low, double& high) {
            low += even ? std::fmin(c, 0) : -std::abs(c);
            high += even ? std::fmax(c, 0) : std::abs(c);
        };
        for (std::size_t d = 0; d < 3; ++d) {
            add(patch.c[k][d], patch.low[d], patch.high[d]);
            add(dot(patch.axes[d], patch.c[k]), patch.oriented_low[d], patch.oriented_high[d]);
        }
    }
}

}  // namespace

surface::FacetMap::Value Patch::operator()(const surface::FacetPoint& xi) const {
    const auto [s, t] = xi;
    surface::FacetMap::Value at{};
    if (is_line()) {
        for (std::size_t d = 0; d < 3; ++d) {
            at.x[d] = c[0][d] + s * (c[3][d] + s * c[6][d]);
            at.t1[d] = c[3][d] + 2 * s * c[6][d];
        }
        at.t2 = {0, 0, 1};
        return at;
    }
    for (std::size_t d = 0; d < 3; ++d) {
        const auto row = [&](std::size_t i) { return c[3 * i][d] + t * (c[3 * i + 1][d] + t * c[3 * i + 2][d]); };
        const auto slope = [&](std::size_t i) { return c[3 * i + 1][d] + 2 * t * c[3 * i + 2][d]; };
        at.x[d] = row(0) + s * (row(1) + s * row(2));
        at.t1[d] = row(1) + 2 * s * row(2);
        at.t2[d] = slope(0) + s * (slope(1) + s * slope(2));
    }
    return at;
}

Patch make_patch(const surface::FacetMap& facet) {
    Patch patch{facet.type, facet.nodes};
    const auto nodes = static_cast<std::size_t>(mesh::node_count(facet.type));
    const Table& table = table_of(facet.type);
    for (std::size_t k = 0, stride = stride_of(patch); k < 9; k += stride)
        for (std::size_t a = 0; a < nodes; ++a)
            if (table[k][a] != 0) patch.c[k] = along(patch.c[k], table[k][a], facet.nodes[a]);
    for (std::size_t a = 0; a < nodes; ++a)
        patch.centre = along(patch.centre, 1.0 / static_cast<double>(nodes), facet.nodes[a]);
    for (std::size_t a = 0; a < nodes; ++a)
        patch.radius_m = std::max(patch.radius_m, beyond_ball * norm(difference(facet.nodes[a], patch.centre)));
    find_boxes(patch);
    return patch;
}

}  // namespace soft::contact
