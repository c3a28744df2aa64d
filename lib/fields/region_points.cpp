#include "fields/region_points.hpp"

#include <algorithm>
#include <utility>

namespace soft::fields {

RegionPoints region_points(const mesh::Mesh& mesh) {
    using Key = std::pair<mesh::Index, std::int32_t>;
    std::vector<Key> keys;
    keys.reserve(mesh.connectivity.size());
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (const mesh::Index node : mesh.cell_nodes(cell))
            keys.emplace_back(node, mesh.cell_regions[static_cast<std::size_t>(cell)]);

    std::vector<Key> points = keys;
    std::ranges::sort(points);
    const auto repeated = std::ranges::unique(points);
    points.erase(repeated.begin(), repeated.end());

    RegionPoints places;
    for (const auto& [node, region] : points) {
        places.node.push_back(node);
        places.region.push_back(region);
    }
    places.connectivity.reserve(keys.size());
    for (const Key& key : keys)
        places.connectivity.push_back(
            static_cast<std::int32_t>(std::ranges::lower_bound(points, key) - points.begin()));
    return places;
}

}  // namespace soft::fields
