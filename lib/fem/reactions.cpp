/// Reactions of constrained faces at a state: the contributions of cells, pressures and dead loads (reaction.hpp).
#include <algorithm>

#include "fem/system.hpp"

namespace soft::fem {

Reaction System::complete_reaction(const model::Output& output) {
    Reaction reaction = make_reaction(input_, output);
    const auto touches = [&](std::span<const mesh::Index> nodes) {
        return std::ranges::any_of(nodes, [&](mesh::Index node) { return reaction.has(node); });
    };
    for (const auto& group : groups_) {
        auto& list = reaction.cells.emplace_back();
        for (std::size_t c = 0; c < group.cells.size(); ++c)
            if (touches(input_.mesh.cell_nodes(group.cells[c]))) list.push_back(c);
    }
    for (const auto& load : loads_) {
        auto& list = reaction.facets.emplace_back();
        for (std::size_t f = 0; f < load.facets.size(); ++f)
            if (touches(load.facets[f].nodes)) list.push_back(f);
    }
    reaction.at_nodes = nodes_on_rank_0(reaction.nodes);
    if (rank_ != 0) return reaction;
    const int dimension = map_.dimension;
    for (const auto& load : input_.loads)
        reaction.plugs.push_back(at_nodes_of(reaction, plug_force(input_, load), dimension));
    for (const auto& traction : input_.tractions)
        reaction.tractions.push_back(
            at_nodes_of(reaction, face_force(input_, traction.face, traction.traction_Pa), dimension));
    for (const auto& force : input_.body_forces)
        reaction.body_forces.push_back(at_nodes_of(reaction, body_force(input_, references_, force), dimension));
    return reaction;
}

double System::reaction(const Reaction& reaction, Vec x, Vec gradient, LoadLevels* by_levels) {
    if (gradient != nullptr) SOFT_PETSC(VecZeroEntries(gradient));
    read_state(x);
    double value = cell_reactions(reaction, gradient, by_levels) + pressure_reactions(reaction, gradient, by_levels) +
                   dead_reactions(reaction, gradient, by_levels);
    value *= reaction.copies;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, comm_);
    finish_slope(gradient, {});
    if (gradient != nullptr) SOFT_PETSC(VecScale(gradient, reaction.copies));
    if (by_levels == nullptr) return value;
    for (auto* list : {&by_levels->pressures_Pa, &by_levels->tractions, &by_levels->body_forces, &by_levels->motions}) {
        for (double& slope : *list) slope *= reaction.copies;
        if (!list->empty())
            MPI_Allreduce(MPI_IN_PLACE, list->data(), static_cast<int>(list->size()), MPI_DOUBLE, MPI_SUM, comm_);
    }
    return value;
}

double System::cell_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const {
    const bool slopes = gradient != nullptr || by_levels != nullptr;
    const std::span<double> by_motion =
        by_levels != nullptr ? std::span<double>(by_levels->motions) : std::span<double>();
    double value = 0;
    std::vector<double> slope, position;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const CellGroup& group = groups_[g];
        const auto& reference = *group.reference;
        const auto size = static_cast<std::size_t>(reference.dofs());
        LocalCell local(reference);
        fem::CellOutput out(reference);
        for (const std::size_t c : reaction.cells[g]) {
            gather_cell(group, c, local);
            std::visit(
                [&](const auto& rubber) {
                    fem::integrate_cell(reference, input_.kinematics, rubber, local.input(map_.pressure_scale_Pa),
                                        slopes ? material::Wanted::stress_and_tangent : material::Wanted::stress, out);
                },
                *group.rubber);
            position = local.X;
            for (std::size_t k = 0; k < position.size(); ++k) position[k] += local.unknowns[k];
            slope.assign(slopes ? size : 0, 0.0);
            const NodeForces forces{input_.mesh.cell_nodes(group.cells[c]), map_.dimension, position, out.residual,
                                    out.stiffness};
            value += add_share(reaction, forces, -1.0, slope);
            if (slopes) add_slope(gradient, by_motion, {&group.dofs[c * size], size}, slope);
        }
    }
    return value;
}

double System::pressure_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const {
    const bool slopes = gradient != nullptr || by_levels != nullptr;
    const std::span<double> by_motion =
        by_levels != nullptr ? std::span<double>(by_levels->motions) : std::span<double>();
    double value = 0;
    std::vector<double> position, loaded, force, stiffness, slope;
    for (std::size_t load = 0; load < loads_.size(); ++load) {
        const double pressure = levels_.pressures_Pa[load];
        const bool follows = input_.loads[load].shape == model::LoadShape::deformed;
        for (const std::size_t f : reaction.facets[load]) {
            const auto& facet = loads_[load].facets[f];
            const auto& reference = tables_[facet.reference];
            const auto size = static_cast<std::size_t>(reference.dofs());
            gather_surface(facet, position);
            if (follows)
                loaded = position;
            else
                gather_undeformed(facet, loaded);
            force.assign(size, 0.0);
            stiffness.assign(slopes && follows ? size * size : 0, 0.0);
            fem::pressure_force(reference, input_.kinematics, loaded, force, stiffness);
            slope.assign(slopes ? size : 0, 0.0);
            const double per_pressure =
                add_share(reaction, {facet.nodes, map_.dimension, position, force, stiffness}, 1.0, slope);
            value += pressure * per_pressure;
            if (by_levels != nullptr) by_levels->pressures_Pa[load] += per_pressure;
            for (double& s : slope) s *= pressure;
            if (slopes) add_slope(gradient, by_motion, facet.dofs, slope);
        }
    }
    return value;
}

double System::dead_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const {
    if (rank_ != 0) return 0;
    const std::span<double> by_motion =
        by_levels != nullptr ? std::span<double>(by_levels->motions) : std::span<double>();
    double value = 0;
    std::vector<double> position, slope;
    gather_surface(reaction.at_nodes, position);
    const auto add = [&](const std::vector<std::vector<double>>& forces, std::vector<double> LoadLevels::*list) {
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const double level = (levels_.*list)[i];
            slope.assign(position.size(), 0.0);
            const double per_level =
                add_share(reaction, {reaction.nodes, map_.dimension, position, forces[i], {}}, 1.0, slope);
            value += level * per_level;
            if (by_levels != nullptr) (by_levels->*list)[i] += per_level;
            for (double& s : slope) s *= level;
            add_slope(gradient, by_motion, reaction.at_nodes.dofs, slope);
        }
    };
    add(reaction.plugs, &LoadLevels::pressures_Pa);
    add(reaction.tractions, &LoadLevels::tractions);
    add(reaction.body_forces, &LoadLevels::body_forces);
    return value;
}

}  // namespace soft::fem
