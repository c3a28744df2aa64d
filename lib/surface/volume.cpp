#include "surface/volume.hpp"

#include <set>

#include "model/cavity_surface.hpp"
#include "model/facet_integrals.hpp"

namespace soft::surface {
namespace {

using mesh::Index;
using mesh::Point;
using model::RimEdge;

/// Mean of the nodes of the whole rim, which lies on the symmetry planes that cut it.
Point apex(const model::Case& model, const std::vector<RimEdge>& rim, std::span<const Point> positions) {
    std::set<Index> nodes;
    for (const RimEdge& edge : rim) nodes.insert(edge.begin(), edge.end());
    Point mean{};
    for (const Index node : nodes)
        for (std::size_t d = 0; d < 3; ++d)
            mean[d] += positions[static_cast<std::size_t>(node)][d] / static_cast<double>(nodes.size());
    const auto cut = model::planes_through(model, rim);
    for (std::size_t d = 0; d < 3; ++d)
        if (cut[d]) mean[d] = 0;
    return mean;
}

double caps_m3(const model::Case& model, const std::vector<RimEdge>& rim, std::span<const Point> positions) {
    const Point c = apex(model, rim, positions);
    Point apex_gradient{};
    std::vector<double> gradient(9);  // not used here
    double volume = 0;
    for (const RimEdge& edge : rim) {
        const auto& facet = model::reference_facet(edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2);
        volume += model::cap_volume(facet, mesh::by_component(positions, edge, 3), c, gradient, apex_gradient);
    }
    return volume;
}

}  // namespace

double enclosed_volume_m3(const model::Case& model, std::span<const mesh::Facet> facets,
                          std::span<const Point> positions) {
    double volume = 0;
    for (const mesh::Facet& facet : facets) {
        const auto& reference = model::reference_facet(mesh::facet_type(model.mesh, facet));
        std::vector<double> gradient(static_cast<std::size_t>(reference.dofs()));
        volume += model::swept_volume(
            reference, model.kinematics,
            mesh::by_component(positions, mesh::facet_nodes(model.mesh, facet), model.mesh.dimension), gradient);
    }
    if (model.kinematics == model::Kinematics::solid)
        for (const auto& rim : model::rims(model, facets)) volume += caps_m3(model, rim, positions);
    return volume / model.model_fraction;
}

}  // namespace soft::surface
