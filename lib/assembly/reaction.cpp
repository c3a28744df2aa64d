#include "assembly/reaction.hpp"

#include <algorithm>

#include "model/face_symmetry.hpp"

namespace soft::assembly {

bool Reaction::has(mesh::Index node) const { return std::ranges::binary_search(nodes, node); }

Reaction make_reaction(const model::Case& input, const model::Output& output) {
    const auto symmetry = model::face_symmetry(input.mesh, {input.kinematics, input.symmetry_planes}, output.face);
    const FaceWeights weights = face_weights(input, output.face);
    Reaction reaction;
    reaction.measure = output.measure;
    reaction.copies = symmetry.copies;
    reaction.nodes = weights.nodes;
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
        if (!reaction.has(forces.nodes[a])) continue;
        Vector3 force{}, arm{};
        for (std::size_t i = 0; i < dimension; ++i) {
            force[i] = forces.force[i * n + a];
            arm[i] = forces.x[i * n + a] - reaction.centre[i];
        }
        const bool is_force = reaction.measure == model::Measure::force;
        const Vector3 weight = is_force ? reaction.direction : cross(reaction.direction, arm);
        share += dot(weight, force);
        if (slope.empty()) continue;
        for (std::size_t i = 0; i < dimension && !forces.stiffness.empty(); ++i)
            for (std::size_t j = 0; j < columns; ++j)
                slope[j] += sign * weight[i] * forces.stiffness[(i * n + a) * columns + j];
        const Vector3 by_position = is_force ? Vector3{} : cross(force, reaction.direction);
        for (std::size_t i = 0; i < dimension; ++i) slope[i * n + a] += sign * by_position[i];
    }
    return sign * share;
}

}  // namespace soft::assembly
