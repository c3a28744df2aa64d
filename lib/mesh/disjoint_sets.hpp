#pragma once
/// Groups of connected objects (union-find with path halving). Tested by mesh/mesh_test.
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace soft::mesh {

/// The objects 0 to size - 1, at first each in its own group.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    /// The smallest object of the group.
    [[nodiscard]] std::size_t first(std::size_t object) {
        while (parent_[object] != object) object = parent_[object] = parent_[parent_[object]];
        return object;
    }
    void unite(std::size_t a, std::size_t b) {
        const auto [low, high] = std::minmax({first(a), first(b)});
        parent_[high] = low;
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace soft::mesh
