#include "surface/free_facets.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"

namespace soft::surface {

std::array<bool, 3> mirrors(const model::Case& model) {
    std::array<bool, 3> planes = model.symmetry_planes;
    if (model.kinematics == model::Kinematics::axisymmetric) planes[1] = true;
    if (model.mesh.dimension == 2) planes[2] = false;
    return planes;
}

std::vector<mesh::Facet> free_facets(const model::Case& model) {
    const std::array<bool, 3> planes = mirrors(model);
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);
    std::vector<mesh::Facet> facets = mesh::boundary_facets(model.mesh);
    std::erase_if(facets, [&](const mesh::Facet& facet) {
        const std::vector<mesh::Index> nodes = mesh::facet_nodes(model.mesh, facet);
        for (std::size_t d = 0; d < 3; ++d)
            if (planes[d] && std::all_of(nodes.begin(), nodes.end(), [&](mesh::Index node) {
                    return std::abs(model.mesh.point(node)[d]) <= tolerance_m;
                }))
                return true;
        return false;
    });
    return facets;
}

std::map<mesh::Facet, std::string> face_names(const model::Case& model) {
    std::map<mesh::Facet, std::string> names;
    for (const model::Cavity& cavity : model.cavities)
        if (const auto wall = model.mesh.facet_sets.find(cavity.wall); wall != model.mesh.facet_sets.end())
            for (const mesh::Facet& facet : wall->second) names.emplace(facet, cavity.wall);
    for (const auto& [name, facets] : model.mesh.facet_sets)
        for (const mesh::Facet& facet : facets) names.emplace(facet, name);
    return names;
}

}  // namespace soft::surface
