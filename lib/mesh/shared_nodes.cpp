#include "mesh/shared_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/shape.hpp"

namespace soft::mesh {

std::vector<CornerWeight> corner_weights(CellType type, const std::array<double, 3>& xi) {
    const std::vector<double> values = vertex_values(type, xi);
    std::vector<CornerWeight> weights;
    for (std::size_t v = 0; v < values.size(); ++v)
        if (values[v] != 0) weights.push_back({static_cast<int>(v), static_cast<int>(std::lround(16 * values[v]))});
    return weights;
}

Index SharedNodes::number(std::span<const Index> cell_nodes, std::span<const CornerWeight> position, Index next) {
    std::array<std::pair<Index, int>, 4> parts;
    parts.fill({std::numeric_limits<Index>::max(), 0});
    for (std::size_t i = 0; i < position.size(); ++i)
        parts[i] = {cell_nodes[static_cast<std::size_t>(position[i].corner)], position[i].sixteenths};
    std::sort(parts.begin(), parts.end());  // neighbouring cells list the same corners in a different order
    Key key{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        key.corners[i] = parts[i].first;
        key.sixteenths[i] = static_cast<std::uint8_t>(parts[i].second);
    }
    return numbers_.try_emplace(key, next).first->second;
}

std::size_t SharedNodes::Hash::operator()(const Key& key) const noexcept {
    std::uint64_t hash = 0;
    const auto mix = [&hash](std::uint64_t value) {  // multiply by the golden ratio and fold
        hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    };
    for (std::size_t i = 0; i < 4; ++i) {
        mix(static_cast<std::uint64_t>(key.corners[i]));
        mix(key.sixteenths[i]);
    }
    return static_cast<std::size_t>(hash);
}

}  // namespace soft::mesh
