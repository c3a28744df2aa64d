#include "contact/prescribed.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"

namespace soft::contact {

PrescribedNodes::PrescribedNodes(const model::Case& model) {
    const auto add = [&](const std::string& face, const std::array<bool, 3>& components) {
        const auto facets = model.mesh.facet_sets.find(face);
        if (facets == model.mesh.facet_sets.end()) return;  // an obstacle
        for (const mesh::Facet& facet : facets->second)
            for (const mesh::Index node : mesh::facet_nodes(model.mesh, facet))
                for (std::size_t d = 0; d < 3; ++d) components_[node][d] = components_[node][d] || components[d];
    };
    for (const model::Support& support : model.supports) add(support.face, support.fixed);
    for (const model::Motion& motion : model.motions) {
        std::array<bool, 3> components{};
        for (std::size_t d = 0; d < 3; ++d) components[d] = motion.displacement_m[d].has_value();
        add(motion.face, components);
    }
}

bool PrescribedNodes::hold(const mesh::Mesh& mesh, const mesh::Facet& facet, const surface::FacetPoint& xi,
                           const Vector3& away) const {
    constexpr double negligible = 1e-3;  // of a shape function, and of a component of the direction
    const auto shapes = mesh::shape_values(mesh::facet_type(mesh, facet), {xi[0], xi[1], 0});
    const auto nodes = mesh::facet_nodes(mesh, facet);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        if (std::abs(shapes[a].value) < negligible) continue;
        const auto found = components_.find(nodes[a]);
        for (std::size_t d = 0; d < 3; ++d)
            if (std::abs(away[d]) > negligible && (found == components_.end() || !found->second[d])) return false;
    }
    return true;
}

}  // namespace soft::contact
