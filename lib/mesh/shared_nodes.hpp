#pragma once
/// Numbers new nodes on edges and faces so that all cells sharing them use the same number. Internal to the module.
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// A position on an edge or face is identified by the first-order shape functions of the corners. At mid nodes, and at the nodes
/// of refined cells, these are multiples of 1/16, so all cells that share the edge or face compute exactly the same values.
struct CornerWeight {
    int corner;  ///< local number in the cell
    int sixteenths;
};

/// The corners with nonzero weight at a position of a cell: all of them inside the cell, at most four on a face.
[[nodiscard]] std::vector<CornerWeight> corner_weights(CellType type, const std::array<double, 3>& xi);

class SharedNodes {
public:
    /// The number already assigned to this position; if it is new, assigns and returns `next`. At most four weights.
    Index number(std::span<const Index> cell_nodes, std::span<const CornerWeight> position, Index next);

private:
    struct Key {
        std::array<Index, 4> corners;
        std::array<std::uint8_t, 4> sixteenths;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const noexcept;
    };
    std::unordered_map<Key, Index, Hash> numbers_;
};

}  // namespace soft::mesh
