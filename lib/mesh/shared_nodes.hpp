#pragma once
/// New nodes on edges and sides, found once however many cells ask for them. Private to the module.
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// A place on an edge or side by its corners: the first-order shape functions there, which all cells that share the side
/// agree on to the last digit because they are multiples of 1/16 at the places of mid nodes and of halved cells.
struct CornerWeight {
    int corner;  ///< local number in the cell
    int sixteenths;
};

/// The corners with a share in a place of a cell; all of them inside the cell, at most four on a side.
[[nodiscard]] std::vector<CornerWeight> corner_weights(CellType type, const std::array<double, 3>& xi);

class SharedNodes {
public:
    /// The number this place was given before; if it is new, `next`, which is remembered. At most four weights.
    Index number(std::span<const Index> cell_nodes, std::span<const CornerWeight> place, Index next);

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
