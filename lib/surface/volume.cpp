#include "surface/volume.hpp"

#include <map>
#include <set>

#include "fem/pressure_kernel.hpp"
#include "model/cavity_surface.hpp"

namespace soft::surface {
namespace {

using mesh::Index;
using mesh::Point;
using model::RimEdge;

/// Nodal positions component by component, as the kernels expect them.
std::vector<double> gather(std::span<const Index> nodes, int dimension, std::span<const Point> positions) {
    std::vector<double> x;
    for (int i = 0; i < dimension; ++i)
        for (const Index node : nodes)
            x.push_back(positions[static_cast<std::size_t>(node)][static_cast<std::size_t>(i)]);
    return x;
}

/// Mean of the rim's nodes, projected onto the symmetry planes (which contain the mean of the mirrored rim).
Point apex(const model::Case& model, const std::vector<RimEdge>& rim, std::span<const Point> positions) {
    std::set<Index> nodes;
    for (const RimEdge& edge : rim) nodes.insert(edge.begin(), edge.end());
    Point mean{};
    for (const Index node : nodes)
        for (std::size_t d = 0; d < 3; ++d)
            mean[d] += positions[static_cast<std::size_t>(node)][d] / static_cast<double>(nodes.size());
    for (std::size_t d = 0; d < 3; ++d)
        if (model.symmetry_planes[d]) mean[d] = 0;
    return mean;
}

/// Cache of the reference tables of facet types.
class Tables {
public:
    const fem::ReferenceFacet& operator[](mesh::CellType type) {
        const auto found = tables_.find(type);
        return found != tables_.end() ? found->second
                                      : tables_.emplace(type, fem::make_reference_facet(type)).first->second;
    }

private:
    std::map<mesh::CellType, fem::ReferenceFacet> tables_;
};

double caps_m3(const model::Case& model, const std::vector<RimEdge>& rim, std::span<const Point> positions,
               Tables& tables) {
    const Point c = apex(model, rim, positions);
    std::array<double, 3> apex_gradient{};
    std::vector<double> gradient(9);  // not used here
    double volume = 0;
    for (const RimEdge& edge : rim) {
        const auto& table = tables[edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2];
        volume += fem::cap_volume(table, gather(edge, 3, positions), c, gradient, apex_gradient);
    }
    return volume;
}

}  // namespace

double enclosed_volume_m3(const model::Case& model, std::span<const mesh::Facet> facets,
                          std::span<const Point> positions) {
    Tables tables;
    double volume = 0;
    for (const mesh::Facet& facet : facets) {
        const auto& table = tables[mesh::facet_type(model.mesh, facet)];
        std::vector<double> gradient(static_cast<std::size_t>(table.dofs()));
        volume +=
            fem::swept_volume(table, model.kinematics,
                              gather(mesh::facet_nodes(model.mesh, facet), model.mesh.dimension, positions), gradient);
    }
    if (model.kinematics == model::Kinematics::solid)
        for (const auto& rim : model::rims(model, facets)) volume += caps_m3(model, rim, positions, tables);
    return volume / model.model_fraction;
}

}  // namespace soft::surface
