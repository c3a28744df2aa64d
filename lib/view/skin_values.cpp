/// Positions and values of the bases and vertices of a skin at a step.
#include <algorithm>

#include "view/skin.hpp"

namespace soft::view {

std::vector<Point> base_positions(const Skin& skin, const model::Case& model, const post::RegionPoints& region_points,
                                  std::span<const double> displacement_m) {
    std::vector<Point> bases(skin.base_count());
    for (std::size_t b = 0; b < bases.size(); ++b)
        for (auto k = static_cast<std::size_t>(skin.first_source[b]);
             k < static_cast<std::size_t>(skin.first_source[b + 1]); ++k) {
            const mesh::Index node = region_points.node[static_cast<std::size_t>(skin.sources[k])];
            for (std::size_t i = 0; i < 3; ++i) {
                const double u = displacement_m.empty() ? 0.0 : displacement_m[3 * static_cast<std::size_t>(node) + i];
                bases[b][i] += skin.weights[k] * (model.mesh.point(node)[i] + u);
            }
        }
    return bases;
}

std::vector<double> base_values(const Skin& skin, std::span<const double> nodal) {
    std::vector<double> values(skin.base_count(), 0.0);
    for (std::size_t b = 0; b < values.size(); ++b)
        for (auto k = static_cast<std::size_t>(skin.first_source[b]);
             k < static_cast<std::size_t>(skin.first_source[b + 1]); ++k)
            values[b] += skin.weights[k] * nodal[static_cast<std::size_t>(skin.sources[k])];
    const bool positive = std::ranges::all_of(nodal, [](double value) { return value >= 0; });
    if (positive)
        for (double& value : values) value = std::max(value, 0.0);
    return values;
}

std::vector<Point> vertex_positions(const Skin& skin, std::span<const Point> bases) {
    std::vector<Point> positions(skin.vertices.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const std::array<double, 9>& A = skin.placements[static_cast<std::size_t>(skin.vertices[v].placement)];
        const Point& x = bases[static_cast<std::size_t>(skin.vertices[v].base)];
        for (std::size_t i = 0; i < 3; ++i)
            positions[v][i] = A[3 * i] * x[0] + A[3 * i + 1] * x[1] + A[3 * i + 2] * x[2];
    }
    return positions;
}

std::vector<std::array<std::int32_t, 3>> triangles(const Skin& skin) {
    std::vector<std::array<std::int32_t, 3>> out;
    for (const Face& face : skin.faces) {
        out.push_back({face[0], face[1], face[2]});
        if (face[3] != face[2]) out.push_back({face[0], face[2], face[3]});
    }
    return out;
}

}  // namespace soft::view
