#include "fem/nodal_forces.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "core/error.hpp"
#include "fem/solid_kernel.hpp"
#include "mesh/locate.hpp"
#include "model/facet_integrals.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

void add_component(Index node, int i, double value, const DofMap& map, SparseVector& vector) {
    const auto dof = map.displacement[node * map.dimension + i];
    if (dof == -1 || value == 0.0) return;  // prescribed components are included
    vector.dofs.push_back(dof);
    vector.values.push_back(value);
}

NodalForces spread(std::vector<Index> nodes, const std::vector<double>& weights, const Vector3& factor) {
    NodalForces forces{std::move(nodes), {}};
    for (const double weight : weights)
        forces.forces_N.push_back({factor[0] * weight, factor[1] * weight, factor[2] * weight});
    return forces;
}

model::FaceWeights weights_of(const model::Case& input, const std::string& face) {
    return model::face_weights(input.mesh, input.kinematics, face);
}

NodalForces spread(const model::FaceWeights& weights, const Vector3& factor) {
    return spread(weights.nodes, weights.weights_m2, factor);
}

NodalForces body_force(const Discretization& fe, const Vector3& acceleration_m_s2) {
    const mesh::Mesh& mesh = fe.input.mesh;
    const auto density = densities_kg_m3(fe.input);
    std::map<Index, double> mass;  // ascending, so that sums run in the same order on every rank
    std::vector<PointState> points;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& reference = reference_of(fe.references, mesh.cell_type(cell));
        const auto nodes = mesh.cell_nodes(cell);
        const auto X = mesh::by_component(mesh.points, nodes, mesh.dimension);
        const std::vector<double> rest(reference.dofs(), 0.0);
        points.clear();
        CellPoints work(reference);
        sample_cell(reference, fe.input.kinematics, material::FiberFrame::cartesian,
                    {X, {rest.data(), X.size()}, {rest.data() + X.size(), rest.size() - X.size()}, 1.0}, work, points);
        for (std::size_t q = 0; q < points.size(); ++q)
            for (int a = 0; a < reference.nodes; ++a)
                mass[nodes[a]] +=
                    density[mesh.cell_regions[cell]] * points[q].weight_m3 * reference.N[q * reference.nodes + a];
    }
    std::vector<Index> nodes;
    std::vector<double> masses_kg;
    for (const auto& [node, share] : mass) {
        nodes.push_back(node);
        masses_kg.push_back(share);
    }
    return spread(std::move(nodes), masses_kg, acceleration_m_s2);
}

}  // namespace

SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                               const Vector3& direction) {
    const model::FaceWeights weights = weights_of(input, face);
    SparseVector mean = on_unknowns(spread(weights, direction), map);
    for (double& value : mean.values) value /= weights.area_m2;
    return mean;
}

SparseVector point_displacement(const model::Case& input, const DofMap& map, const std::string& name,
                                const mesh::Point& point, const Vector3& direction) {
    const auto location = mesh::locate(input.mesh, point);
    if (!location)
        throw Error(ExitCode::bad_input, "outputs." + name, "the point is outside the mesh",
                    "use a point of the undeformed part");
    const auto nodes = input.mesh.cell_nodes(location->cell);
    return on_unknowns(spread({nodes.begin(), nodes.end()}, location->weights, direction), map);
}

SparseVector on_unknowns(const NodalForces& forces, const DofMap& map) {
    SparseVector vector;
    for (std::size_t k = 0; k < forces.nodes.size(); ++k)
        for (int i = 0; i < map.dimension; ++i) add_component(forces.nodes[k], i, forces.forces_N[k][i], map, vector);
    return vector;
}

NodalForces plug_force(const model::Case& input, const model::PressureLoad& load) {
    NodalForces plugs;
    if (!load.sealed || !load.plug_thrust) return plugs;
    for (const auto& target : load.targets) {
        const auto cavity = std::ranges::find(input.cavities, target, &model::Cavity::name);
        if (cavity == input.cavities.end()) continue;
        for (const auto& opening : cavity->openings) {
            const model::FaceWeights weights = weights_of(input, opening.face);
            const NodalForces mean = spread(weights, opening.direction);
            plugs.nodes.insert(plugs.nodes.end(), mean.nodes.begin(), mean.nodes.end());
            for (auto force : mean.forces_N) {
                for (double& f : force) f = opening.area_m2 * input.model_fraction * (f / weights.area_m2);
                plugs.forces_N.push_back(force);
            }
        }
    }
    return plugs;
}

NodalForces dead_force(const Discretization& fe, const model::DeadLoad& load) {
    switch (load.kind) {
        case model::DeadLoadKind::traction:
        case model::DeadLoadKind::force: return spread(weights_of(fe.input, load.name), load.vector_SI);
        case model::DeadLoadKind::gravity: return body_force(fe, load.vector_SI);
    }
    throw std::logic_error("dead_force: unknown kind");
}

}  // namespace soft::fem
