#pragma once
/// Cavities in a meshed block: removes cells and names the facets that this exposes.
/// Tested by geometry/segment_test.
#include <functional>
#include <string>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// `cavity` maps a cell to the face of the cavity that replaces it, or to an empty string for a cell that remains. Facet sets keep
/// the facets of remaining cells. Regions and points without a cell are removed.
[[nodiscard]] mesh::Mesh hollowed(const mesh::Mesh& block, const std::function<std::string(mesh::Index cell)>& cavity);

}  // namespace soft::meshing
