#include "fem/reaction.hpp"

#include <algorithm>
#include <optional>
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
        if (model::moves_obstacle(input, motion)) continue;
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

/// Index of a node of the face; nullopt for any other node.
std::optional<std::size_t> index_of(const Reaction& reaction, mesh::Index node) {
    const auto found = std::ranges::lower_bound(reaction.nodes, node);
    if (found == reaction.nodes.end() || *found != node) return std::nullopt;
    return static_cast<std::size_t>(found - reaction.nodes.begin());
}

/// The entries of `forces` at the nodes of the face, component by component.
std::vector<double> at_nodes_of(const Reaction& reaction, const NodalForces& forces, int dimension) {
    const std::size_t n = reaction.nodes.size();
    std::vector<double> list(n * static_cast<std::size_t>(dimension), 0.0);
    for (std::size_t k = 0; k < forces.nodes.size(); ++k) {
        const auto a = index_of(reaction, forces.nodes[k]);
        for (std::size_t i = 0; i < static_cast<std::size_t>(dimension) && a; ++i)
            list[i * n + *a] += forces.forces_N[k][i];
    }
    return list;
}

/// Nodal forces of a cell, a facet or dead loads, and their derivatives.
struct NodeForces {
    std::span<const mesh::Index> nodes;
    int dimension;
    std::span<const double> x;      // positions, component by component
    std::span<const double> force;  // the forces first, component by component; further entries (pressures) are ignored
    std::span<const double> stiffness;  // d force / d unknowns, row-major, as many columns as `slope`; empty: constant
};

/// Returns the contribution of `forces` to the output and adds `sign` times its derivative by the unknowns to `slope`, unless
/// that is empty.
double add_share(const Reaction& reaction, const NodeForces& forces, double sign, std::span<double> slope) {
    const std::size_t n = forces.nodes.size(), columns = slope.size();
    const auto dimension = static_cast<std::size_t>(forces.dimension);
    double share = 0;
    for (std::size_t a = 0; a < n; ++a) {
        const auto index = index_of(reaction, forces.nodes[a]);
        if (!index) continue;
        const Vector3& component_shares = reaction.shares[*index];
        Vector3 force{}, arm{};
        for (std::size_t i = 0; i < dimension; ++i) {
            force[i] = component_shares[i] * forces.force[i * n + a];
            arm[i] = forces.x[i * n + a] - reaction.centre[i];
        }
        const bool is_force = reaction.measure == model::Measure::force;
        const Vector3 weight = is_force ? reaction.direction : cross(reaction.direction, arm);
        share += dot(weight, force);
        if (slope.empty()) continue;
        for (std::size_t i = 0; i < dimension && !forces.stiffness.empty(); ++i)
            for (std::size_t j = 0; j < columns; ++j)
                slope[j] += sign * weight[i] * component_shares[i] * forces.stiffness[(i * n + a) * columns + j];
        const Vector3 by_position = is_force ? Vector3{} : cross(force, reaction.direction);
        for (std::size_t i = 0; i < dimension; ++i) slope[i * n + a] += sign * by_position[i];
    }
    return sign * share;
}

double cell_reactions(const Reaction& reaction, const LoadedState& at, Slopes& slopes) {
    const auto wanted = slopes.wanted() ? material::Wanted::stress_and_tangent : material::Wanted::stress;
    const Discretization& fe = at.fe;
    double value = 0;
    std::vector<double> slope, x;
    for (std::size_t g = 0; g < fe.groups.size(); ++g) {
        const CellGroup& group = fe.groups[g];
        LocalCell cell(*group.reference);
        for (const std::size_t c : reaction.cells[g]) {
            integrate(fe, at.state, group, c, wanted, cell);
            x = cell.X;
            for (std::size_t k = 0; k < x.size(); ++k) x[k] += cell.unknowns[k];
            slope.assign(slopes.wanted() ? cell.unknowns.size() : 0, 0.0);
            const NodeForces forces{fe.input.mesh.cell_nodes(group.cells[c]), fe.dofs.dimension, x, cell.out.residual,
                                    cell.out.stiffness};
            value += add_share(reaction, forces, -1.0, slope);
            if (slopes.wanted()) slopes.add(group.dofs_of(c), slope);
        }
    }
    return value;
}

double pressure_reactions(const Reaction& reaction, const LoadedState& at, Slopes& slopes, LoadLevels* by_levels) {
    double value = 0;
    std::vector<double> x, force, stiffness, slope;
    for (std::size_t load = 0; load < at.loads.pressures.size(); ++load) {
        const PressureSurface& surface = at.loads.pressures[load];
        const double pressure = at.state.levels().pressures_Pa[load];
        for (const std::size_t f : reaction.facets[load]) {
            const SurfaceCell& facet = surface.facets[f];
            at.state.positions(facet, x);
            stiffness.resize(slopes.wanted() && surface.follows ? x.size() * x.size() : 0);
            pressure_force(at.fe, surface, facet, x, force, stiffness);
            slope.assign(slopes.wanted() ? x.size() : 0, 0.0);
            const double per_pressure =
                add_share(reaction, {facet.nodes, at.fe.dofs.dimension, x, force, stiffness}, 1.0, slope);
            value += pressure * per_pressure;
            if (by_levels != nullptr) by_levels->pressures_Pa[load] += per_pressure;
            for (double& s : slope) s *= pressure;
            if (slopes.wanted()) slopes.add(facet.dofs, slope);
        }
    }
    return value;
}

double contact_reactions(const Reaction& reaction, const LoadedState& at, Slopes& slopes) {
    double value = 0;
    std::vector<double> x, slope;
    at.contact.evaluate(
        slopes.wanted() ? contact::Wanted::hessian : contact::Wanted::gradient,
        [&](std::span<const PetscInt> dofs, const contact::Block& block) {
            std::vector<mesh::Index> nodes = block.nodes;
            if (block.obstacle >= 0) nodes.push_back(-1);
            x.assign(dofs.size(), 0.0);
            for (std::size_t i = 0; i < block.dimension; ++i)
                for (std::size_t a = 0; a < block.nodes.size(); ++a)
                    x[i * nodes.size() + a] = at.contact.position(block.nodes[a])[i];
            slope.assign(slopes.wanted() ? dofs.size() : 0, 0.0);
            value += add_share(reaction, {nodes, at.fe.dofs.dimension, x, block.gradient, block.hessian}, -1.0, slope);
            if (slopes.wanted()) slopes.add(dofs, slope);
        });
    return value;
}

double dead_reactions(const Reaction& reaction, const LoadedState& at, Slopes& slopes, LoadLevels* by_levels) {
    if (at.fe.rank != 0) return 0;
    double value = 0;
    std::vector<double> x, slope;
    at.state.positions(reaction.at_nodes, x);
    const auto add = [&](const std::vector<std::vector<double>>& forces, std::vector<double> LoadLevels::*list) {
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const double level = (at.state.levels().*list)[i];
            slope.assign(x.size(), 0.0);
            const double per_level =
                add_share(reaction, {reaction.nodes, at.fe.dofs.dimension, x, forces[i], {}}, 1.0, slope);
            value += level * per_level;
            if (by_levels != nullptr) (by_levels->*list)[i] += per_level;
            for (double& s : slope) s *= level;
            slopes.add(reaction.at_nodes.dofs, slope);
        }
    };
    add(reaction.plugs, &LoadLevels::pressures_Pa);
    add(reaction.dead_loads, &LoadLevels::dead_loads);
    return value;
}

/// The cells, facets and dead forces at the nodes of the face.
void find_contributions(Reaction& reaction, const Discretization& fe, const Loads& loads) {
    const model::Case& input = fe.input;
    const auto touches = [&](std::span<const mesh::Index> nodes) {
        return std::ranges::any_of(nodes, [&](mesh::Index node) { return index_of(reaction, node).has_value(); });
    };
    for (const auto& group : fe.groups) {
        auto& list = reaction.cells.emplace_back();
        for (std::size_t c = 0; c < group.cells.size(); ++c)
            if (touches(input.mesh.cell_nodes(group.cells[c]))) list.push_back(c);
    }
    for (const auto& load : loads.pressures) {
        auto& list = reaction.facets.emplace_back();
        for (std::size_t f = 0; f < load.facets.size(); ++f)
            if (touches(load.facets[f].nodes)) list.push_back(f);
    }
    reaction.at_nodes = nodes_on_rank_0(fe, reaction.nodes);
    if (fe.rank != 0) return;
    const int dimension = fe.dofs.dimension;
    for (const auto& load : input.loads)
        reaction.plugs.push_back(at_nodes_of(reaction, plug_force(input, load), dimension));
    for (const auto& load : input.dead_loads)
        reaction.dead_loads.push_back(at_nodes_of(reaction, dead_force(fe, load), dimension));
}

}  // namespace

Reaction make_reaction(const Discretization& fe, const Loads& loads, const model::Output& output) {
    const model::Case& input = fe.input;
    const auto symmetry = model::face_symmetry(input.mesh, {input.kinematics, input.symmetry_planes}, output.face);
    const auto weights = model::face_weights(input.mesh, input.kinematics, output.face);
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
    find_contributions(reaction, fe, loads);
    return reaction;
}

double own_value(const Reaction& reaction, const LoadedState& at, Slopes& slopes, LoadLevels* by_levels) {
    return cell_reactions(reaction, at, slopes) + contact_reactions(reaction, at, slopes) +
           pressure_reactions(reaction, at, slopes, by_levels) + dead_reactions(reaction, at, slopes, by_levels);
}

}  // namespace soft::fem
