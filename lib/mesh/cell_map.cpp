#include "mesh/cell_map.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace soft::mesh {
namespace {

/// Position and gradient; the caller sets the determinant, which depends on the dimension of the cell or facet.
CellMap map_nodes(const Mesh& mesh, std::span<const Index> nodes, const std::vector<ShapeValue>& shapes) {
    CellMap map{};
    for (std::size_t a = 0; a < shapes.size(); ++a) {
        const Point& X = mesh.point(nodes[a]);
        for (std::size_t i = 0; i < 3; ++i) {
            map.position[i] += shapes[a].value * X[i];
            for (std::size_t d = 0; d < 3; ++d) map.dX_dxi[3 * i + d] += shapes[a].gradient[d] * X[i];
        }
    }
    return map;
}

double determinant(int dimension, const std::array<double, 9>& m) {
    if (dimension == 1) return std::hypot(m[0], m[3], m[6]);
    if (dimension == 2) return m[0] * m[4] - m[1] * m[3];
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

}  // namespace

CellMap map_cell(const Mesh& mesh, Index cell, const std::vector<ShapeValue>& shapes) {
    CellMap map = map_nodes(mesh, mesh.cell_nodes(cell), shapes);
    map.determinant = determinant(dimension(mesh.cell_type(cell)), map.dX_dxi);
    return map;
}

std::array<double, 3> facet_normal(const Mesh& mesh, const Facet& facet, const std::vector<ShapeValue>& shapes) {
    const auto m = map_nodes(mesh, facet_nodes(mesh, facet), shapes).dX_dxi;
    if (mesh.dimension == 2) return {m[3], -m[0], 0};
    return {m[3] * m[7] - m[6] * m[4], m[6] * m[1] - m[0] * m[7], m[0] * m[4] - m[3] * m[1]};
}

std::vector<QuadraturePoint> volume_rule(CellType type) {
    const CellTopology& t = topology(type);
    const bool tensor = t.shape == Shape::line || t.shape == Shape::quadrilateral || t.shape == Shape::hexahedron;
    return quadrature(t.shape, tensor ? 7 : 5);
}

namespace {

/// Calls add(cell, contribution) for every quadrature point.
template <class Add>
void for_each_share(const Mesh& mesh, Measure kind, Add&& add) {
    struct Sample {
        std::vector<ShapeValue> shapes;
        double weight;
    };
    std::vector<Sample> samples;
    std::optional<CellType> tabulated;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const CellType type = mesh.cell_type(cell);
        if (tabulated != type) {
            samples.clear();
            for (const QuadraturePoint& p : volume_rule(type)) samples.push_back({shape_values(type, p.xi), p.weight});
            tabulated = type;
        }
        for (const Sample& sample : samples) {
            const CellMap map = map_cell(mesh, cell, sample.shapes);
            const double turn = kind == Measure::revolved ? 2 * std::numbers::pi * map.position[1] : 1.0;
            add(cell, sample.weight * map.determinant * turn);
        }
    }
}

}  // namespace

double measure(const Mesh& mesh, Measure kind) {
    double sum = 0;
    for_each_share(mesh, kind, [&](Index, double share) { sum += share; });
    return sum;
}

std::vector<double> region_measures(const Mesh& mesh, Measure kind) {
    std::vector<double> sums(mesh.region_names.size(), 0.0);
    for_each_share(mesh, kind, [&](Index cell, double share) {
        sums[static_cast<std::size_t>(mesh.cell_regions[static_cast<std::size_t>(cell)])] += share;
    });
    return sums;
}

}  // namespace soft::mesh
