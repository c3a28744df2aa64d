#include "contact/separation.hpp"

#include <algorithm>
#include <cmath>

namespace soft::contact {

namespace {

std::span<const mesh::Point> nodes_of(const Patch& patch) {
    return std::span{patch.nodes}.first(static_cast<std::size_t>(mesh::node_count(patch.type)));
}

/// In the axes of a facet.
Vector3 seen_from(const Patch& patch, const mesh::Point& x) {
    const Vector3 r = difference(x, patch.centre);
    return {dot(patch.axes[0], r), dot(patch.axes[1], r), dot(patch.axes[2], r)};
}

}  // namespace

void Separations::set(std::size_t i, std::size_t j, double clearance_m, std::span<const Patch> patches) {
    if (clearance_m <= 0) {
        pairs_.erase(key(i, j));
        return;
    }
    Pair& pair = pairs_[key(i, j)];
    pair.clearance_m = clearance_m;
    pair.nodes.clear();
    for (const std::size_t facet : {i, j})
        for (const mesh::Point& node : nodes_of(patches[facet])) pair.nodes.push_back(seen_from(patches[i], node));
}

double Separations::clearance_m(std::size_t i, std::size_t j, std::span<const Patch> patches) const {
    const auto known = pairs_.find(key(i, j));
    if (known == pairs_.end()) return 0;
    double moved = 0;
    auto before = known->second.nodes.begin();
    for (const std::size_t facet : {i, j}) {
        double largest2 = 0;
        for (const mesh::Point& node : nodes_of(patches[facet])) {
            const Vector3 motion = difference(seen_from(patches[i], node), *before++);
            largest2 = std::max(largest2, dot(motion, motion));
        }
        moved += of_nodal_motion * std::sqrt(largest2);
    }
    return known->second.clearance_m - moved;
}

}  // namespace soft::contact
