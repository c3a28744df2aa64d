#include "contact/candidates.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "contact/crossing.hpp"

namespace soft::contact {

namespace {

/// A search holds until nodes have moved by this fraction of the longest side of the smallest undeformed facet. Boxes grow by what points
/// may move then, and by the range of their facet. So every pair that acts is a candidate, whatever states came before.
constexpr double reach = 0.06;
/// Neighbouring facets may act on each other where their normals are this close to facing each other. Unless rubber is compressed along the
/// surface, they do so only at smaller angles, so that no force begins with a jump.
constexpr double folding_angle = 1.0;
/// Neighbouring facets whose normal cones are this far from facing each other do not fold within `reach`, which turns each normal by up to
/// 0.45.
constexpr double safe_angle = 1.9;

double longest_side(const Patch& patch) {
    double longest = 0;
    for (std::size_t d = 0; d < 3; ++d) longest = std::max(longest, patch.high[d] - patch.low[d]);
    return longest;
}

bool may_fold(NormalCone a, const NormalCone& b, double angle) {
    a.angle += angle;
    return !is_visible_from_one_side(a, b);
}

/// Computes a cone once.
class Cones {
public:
    explicit Cones(std::span<const Patch> patches) : patches_(patches), cones_(patches.size()) {}
    const NormalCone& operator()(std::size_t i) {
        if (!cones_[i]) cones_[i] = normals(patches_[i]);
        return *cones_[i];
    }

private:
    std::span<const Patch> patches_;
    std::vector<std::optional<NormalCone>> cones_;
};

}  // namespace

Candidates::Candidates(ContactSurface& surface, bool self)
    : surface_(surface), self_(self), reach_m_(std::numeric_limits<double>::max()) {
    for (const auto& entry : surface.entries().first(surface.free_count()))
        reach_m_ = std::min(reach_m_, reach * longest_side(entry.undeformed));
}

std::vector<Candidates::Pair> Candidates::search(std::span<const Patch> from, std::span<const Patch> to) const {
    std::vector<surface::Box> boxes;
    const auto entries = surface_.entries();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const double margin_m = entries[i].range_m + of_nodal_motion * reach_m_;
        surface::Box& box = boxes.emplace_back(surface::Box{from[i].low, from[i].high});
        for (std::size_t d = 0; d < 3; ++d) {
            box.low[d] = std::min(box.low[d], to[i].low[d]) - margin_m;
            box.high[d] = std::max(box.high[d], to[i].high[d]) + margin_m;
        }
    }
    std::vector<Pair> pairs;
    Cones cones(from);
    for (const auto& [first, second] : surface::overlapping_pairs(boxes)) {
        const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
        const bool with_obstacle = j >= surface_.free_count();
        if (i >= surface_.free_count() || (!with_obstacle && !self_)) continue;
        const Adjacency kind = with_obstacle ? Adjacency::apart : surface_.adjacency(i, j);
        const bool neighbours = kind == Adjacency::neighbours;
        if (kind == Adjacency::sides_of_a_wall || (neighbours && !may_fold(cones(i), cones(j), safe_angle))) continue;
        pairs.push_back({i, j, neighbours});
    }
    return pairs;
}

bool Candidates::has_moved(std::span<const Patch> patches) const {
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (int a = 0; a < mesh::node_count(patches[i].type); ++a) {
            const auto k = static_cast<std::size_t>(a);
            const Vector3 motion = difference(patches[i].nodes[k], reference_[i].nodes[k]);
            if (dot(motion, motion) > reach_m_ * reach_m_) return true;
        }
    return false;
}

std::vector<std::vector<std::size_t>> Candidates::between(std::span<const Patch> from, std::span<const Patch> to) {
    std::vector<Pair> on_the_way;
    const bool moves = from.data() != to.data();
    bool fresh = false;
    if (reference_.empty() || has_moved(from) || (moves && has_moved(to))) {
        if (moves) {
            on_the_way = search(from, to);
            fresh = true;
        } else {
            pairs_ = search(from, to);
            reference_.assign(from.begin(), from.end());
        }
    }
    std::vector<std::vector<std::size_t>> others(surface_.free_count());
    Cones cones(from);
    for (const Pair& pair : fresh ? on_the_way : pairs_) {  // ascending, so that each list is
        if (pair.may_fold && !may_fold(cones(pair.first), cones(pair.second), folding_angle)) continue;
        others[pair.first].push_back(pair.second);
        if (pair.second < surface_.free_count()) others[pair.second].push_back(pair.first);
    }
    return others;
}

}  // namespace soft::contact
