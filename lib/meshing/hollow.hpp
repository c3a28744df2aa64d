#pragma once
/// Rooms in a meshed block: cells are taken away, and the sides that this lays bare get a name.
/// Tested by geometry/segment_test.
#include <functional>
#include <string>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// `room` of a cell: the face of the room it makes way for, or empty for a cell that stays. Facet sets keep the sides of
/// cells that stay; regions without a cell, and points without one, go.
[[nodiscard]] mesh::Mesh hollowed(const mesh::Mesh& block, const std::function<std::string(mesh::Index cell)>& room);

}  // namespace soft::meshing
