#pragma once
/// Regions of a mesh by name. Tested by meshing/box_grid_test and geometry/segment_test.
#include <cstdint>
#include <string>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// The number of the region of this name; adds it if it does not exist.
[[nodiscard]] std::int32_t region_number(mesh::Mesh& mesh, const std::string& name);

[[nodiscard]] const std::string& region_of(const mesh::Mesh& mesh, mesh::Index cell);

}  // namespace soft::meshing
