#include "fem/reaction.hpp"

#include <algorithm>
#include <set>

#include "model/face_symmetry.hpp"

namespace soft::fem {

namespace {

/// A face with some fixed or prescribed components.
struct ConstrainedFace {
    std::string face;
    std::array<bool, 3> components;
};

std::vector<ConstrainedFace> constrained_faces(const model::Case& input) {
    std::vector<ConstrainedFace> faces;
    for (const auto& support : input.supports) faces.push_back({support.face, support.fixed});
    for (const auto& motion : input.motions) {
        const auto& moved = motion.displacement_m;
        faces.push_back({motion.face, {moved[0].has_value(), moved[1].has_value(), moved[2].has_value()}});
    }
    return faces;
}

/// The reaction at nodes shared by several constrained faces is divided equally among them.
std::vector<Vector3> reaction_shares(const model::Case& input, const std::string& face,
                                     const std::vector<mesh::Index>& nodes) {
    const auto& set = input.mesh.facet_sets.at(face);
    const std::set<mesh::Facet> own(set.begin(), set.end());
    struct Count {
        std::array<bool, 3> by_face{};
        std::array<int, 3> by_others{};
    };
    std::vector<Count> counts(nodes.size());
    for (const ConstrainedFace& constrained : constrained_faces(input)) {
        std::set<std::size_t> here, beside;  // indices into `nodes`
        for (const mesh::Facet& facet : input.mesh.facet_sets.at(constrained.face))
            for (const mesh::Index node : mesh::facet_nodes(input.mesh, facet)) {
                const auto found = std::ranges::lower_bound(nodes, node);
                if (found == nodes.end() || *found != node) continue;
                (own.contains(facet) ? here : beside).insert(static_cast<std::size_t>(found - nodes.begin()));
            }
        for (std::size_t i = 0; i < 3; ++i) {
            if (!constrained.components[i]) continue;
            for (const std::size_t index : here) counts[index].by_face[i] = true;
            for (const std::size_t index : beside) ++counts[index].by_others[i];
        }
    }
    std::vector<Vector3> shares(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            shares[k][i] = counts[k].by_face[i] ? 1.0 / (1 + counts[k].by_others[i]) : 0.0;
    return shares;
}

}  // namespace

const Vector3* Reaction::share_of(mesh::Index node) const {
    const auto found = std::ranges::lower_bound(nodes, node);
    if (found == nodes.end() || *found != node) return nullptr;
    return &shares[static_cast<std::size_t>(found - nodes.begin())];
}

Reaction make_reaction(const model::Case& input, const model::Output& output) {
    const auto symmetry = model::face_symmetry(input.mesh, {input.kinematics, input.symmetry_planes}, output.face);
    const FaceWeights weights = face_weights(input, output.face);
    Reaction reaction;
    reaction.measure = output.measure;
    reaction.copies = symmetry.copies;
    reaction.nodes = weights.nodes;
    reaction.shares = reaction_shares(input, output.face, reaction.nodes);
    reaction.direction = output.measure == model::Measure::force
                             ? model::uncancelled_force(symmetry, output.direction)
                             : model::uncancelled_moment(symmetry, output.direction);
    for (std::size_t k = 0; k < weights.nodes.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            if (!symmetry.mirrored[i])
                reaction.centre[i] += weights.weights_m2[k] / weights.area_m2 * input.mesh.point(weights.nodes[k])[i];
    return reaction;
}

std::vector<double> at_nodes_of(const Reaction& reaction, const NodalForces& forces, int dimension) {
    const std::size_t n = reaction.nodes.size();
    std::vector<double> list(n * static_cast<std::size_t>(dimension), 0.0);
    for (std::size_t k = 0; k < forces.nodes.size(); ++k) {
        const auto found = std::ranges::lower_bound(reaction.nodes, forces.nodes[k]);
        if (found == reaction.nodes.end() || *found != forces.nodes[k]) continue;
        const auto a = static_cast<std::size_t>(found - reaction.nodes.begin());
        for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) list[i * n + a] += forces.forces_N[k][i];
    }
    return list;
}

double add_share(const Reaction& reaction, const NodeForces& forces, double sign, std::span<double> slope) {
    const std::size_t n = forces.nodes.size(), columns = slope.size();
    const auto dimension = static_cast<std::size_t>(forces.dimension);
    double share = 0;
    for (std::size_t a = 0; a < n; ++a) {
        const Vector3* component_shares = reaction.share_of(forces.nodes[a]);
        if (component_shares == nullptr) continue;
        Vector3 force{}, arm{};
        for (std::size_t i = 0; i < dimension; ++i) {
            force[i] = (*component_shares)[i] * forces.force[i * n + a];
            arm[i] = forces.x[i * n + a] - reaction.centre[i];
        }
        const bool is_force = reaction.measure == model::Measure::force;
        const Vector3 weight = is_force ? reaction.direction : cross(reaction.direction, arm);
        share += dot(weight, force);
        if (slope.empty()) continue;
        for (std::size_t i = 0; i < dimension && !forces.stiffness.empty(); ++i)
            for (std::size_t j = 0; j < columns; ++j)
                slope[j] += sign * weight[i] * (*component_shares)[i] * forces.stiffness[(i * n + a) * columns + j];
        const Vector3 by_position = is_force ? Vector3{} : cross(force, reaction.direction);
        for (std::size_t i = 0; i < dimension; ++i) slope[i * n + a] += sign * by_position[i];
    }
    return sign * share;
}

}  // namespace soft::fem
