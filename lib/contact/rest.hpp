#pragma once

#include <span>
#include <vector>

#include "math/tensor.hpp"
#include "mesh/mesh.hpp"

namespace soft::contact {

/// Positions at which nothing touched: nothing touches while no node and no obstacle has moved farther than motion_m from them.
/// Configuration: deformed, m. Private to the module. Tested by contact/potential_test.
struct Rest {
    std::vector<mesh::Point> positions;  // of the nodes of the contact surface
    std::vector<Vector3> shifts;         // of the obstacles
    double motion_m;

    [[nodiscard]] bool holds(std::span<const mesh::Index> nodes, std::span<const mesh::Point> at,
                             std::span<const Vector3> shifts_at) const {
        const auto moves = [this](const Vector3& from, const Vector3& to) {
            const Vector3 motion = difference(to, from);
            return dot(motion, motion) > motion_m * motion_m;
        };
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (moves(positions[k], at[static_cast<std::size_t>(nodes[k])])) return false;
        for (std::size_t k = 0; k < shifts.size(); ++k)
            if (moves(shifts[k], shifts_at[k])) return false;
        return true;
    }
};

}  // namespace soft::contact
