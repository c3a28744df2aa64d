#include "post/region_points.hpp"

#include <algorithm>
#include <utility>

namespace soft::post {

RegionPoints make_region_points(const mesh::Mesh& mesh) {
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

    RegionPoints result;
    for (const auto& [node, region] : points) {
        result.node.push_back(node);
        result.region.push_back(region);
    }
    result.connectivity.reserve(keys.size());
    for (const Key& key : keys)
        result.connectivity.push_back(
            static_cast<std::int32_t>(std::ranges::lower_bound(points, key) - points.begin()));
    return result;
}

}  // namespace soft::post
