#include "meshing/regions.hpp"

#include <algorithm>

namespace soft::meshing {

std::int32_t region_number(mesh::Mesh& mesh, const std::string& name) {
    auto found = std::ranges::find(mesh.region_names, name);
    if (found == mesh.region_names.end()) found = mesh.region_names.insert(found, name);
    return static_cast<std::int32_t>(found - mesh.region_names.begin());
}

const std::string& region_of(const mesh::Mesh& mesh, mesh::Index cell) {
    return mesh.region_names[static_cast<std::size_t>(mesh.cell_regions[static_cast<std::size_t>(cell)])];
}

}  // namespace soft::meshing
