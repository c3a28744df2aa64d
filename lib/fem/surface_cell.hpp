#pragma once
/// Facets, rim edges and node lists with their unknowns, ready for the integrals of model/facet_integrals.hpp.
/// Tested by fem/system_test.
#include <string>
#include <vector>

#include "fem/discretization.hpp"
#include "model/facet_integrals.hpp"

namespace soft::fem {

struct SurfaceCell {
    const model::ReferenceFacet* reference = nullptr;  ///< nullptr for a list of nodes
    std::vector<mesh::Index> nodes;
    std::vector<PetscInt> dofs;  ///< component by component, negative for fixed and prescribed components
    std::vector<double> X;       ///< undeformed positions, in the same order
};

[[nodiscard]] SurfaceCell make_surface_cell(const Discretization& fe, std::vector<mesh::Index> nodes,
                                            const model::ReferenceFacet* reference = nullptr);

/// Those of some facets that this rank assembles.
[[nodiscard]] std::vector<SurfaceCell> own_facets(const Discretization& fe, const std::vector<mesh::Facet>& facets);

/// Nodes that rank 0 evaluates alone; empty on other ranks.
[[nodiscard]] SurfaceCell nodes_on_rank_0(const Discretization& fe, const std::vector<mesh::Index>& nodes);

}  // namespace soft::fem
