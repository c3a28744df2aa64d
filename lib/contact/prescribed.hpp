#pragma once
/// The nodes whose displacement is prescribed, by a support or a moved face. Private to the module. Tested by contact/obstacle_test.
#include <array>
#include <map>

#include "model/case.hpp"
#include "surface/facet_map.hpp"

namespace soft::contact {

class PrescribedNodes {
public:
    explicit PrescribedNodes(const model::Case& model);

    /// Whether a point of the facet cannot give way along `away`: the nodes that move it are prescribed in all components of that direction.
    [[nodiscard]] bool hold(const mesh::Mesh& mesh, const mesh::Facet& facet, const surface::FacetPoint& xi,
                            const Vector3& away) const;

private:
    std::map<mesh::Index, std::array<bool, 3>> components_;
};

}  // namespace soft::contact
