#include "fem/nodal_forces.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "fem/pressure_kernel.hpp"
#include "fem/solid_kernel.hpp"
#include "mesh/locate.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

void add_component(Index node, int i, double value, const DofMap& map, SparseVector& vector) {
    const auto dof = map.displacement[node * map.dimension + i];
    if (dof == -1 || value == 0.0) return;  // prescribed components are included
    vector.dofs.push_back(dof);
    vector.values.push_back(value);
}

NodalForces spread(const FaceWeights& weights, const std::array<double, 3>& factor) {
    NodalForces forces{weights.nodes, {}};
    for (const double weight : weights.weights_m2)
        forces.forces_N.push_back({factor[0] * weight, factor[1] * weight, factor[2] * weight});
    return forces;
}

/// Ascending, so that sums run in the same order on every rank.
FaceWeights listed(const std::map<Index, double>& shares) {
    FaceWeights weights;
    for (const auto& [node, share] : shares) {
        weights.nodes.push_back(node);
        weights.weights_m2.push_back(share);
    }
    return weights;
}

std::vector<double> densities(const model::Case& input, const std::string& load) {
    std::vector<double> density;
    for (const auto& region : input.mesh.region_names) {
        const auto material = std::ranges::find(input.materials, region, &model::Material::name);
        if (material == input.materials.end() || !material->density_kg_m3)
            throw Error(ExitCode::bad_input, "loads." + load, "the material has no density",
                        "add material.density, for example 1080 kg/m^3");
        density.push_back(*material->density_kg_m3);
    }
    return density;
}

}  // namespace

FaceWeights face_weights(const model::Case& input, const std::string& face) {
    const mesh::Mesh& mesh = input.mesh;
    const auto set = mesh.facet_sets.find(face);
    if (set == mesh.facet_sets.end() || set->second.empty())
        throw Error(ExitCode::bad_input, "loads", "no face is called '" + face + "'");
    std::map<Index, double> shares;
    double area = 0;
    for (const auto& facet : set->second) {
        const auto reference = fem::make_reference_facet(mesh::facet_type(mesh, facet));
        const auto nodes = mesh::facet_nodes(mesh, facet);
        std::vector<double> X(reference.dofs()), share(reference.nodes, 0.0);
        for (int i = 0; i < mesh.dimension; ++i)
            for (int a = 0; a < reference.nodes; ++a) X[i * reference.nodes + a] = mesh.point(nodes[a])[i];
        area += fem::facet_area(reference, input.kinematics, X, share);
        for (int a = 0; a < reference.nodes; ++a) shares[nodes[a]] += share[a];
    }
    FaceWeights weights = listed(shares);
    weights.area_m2 = area;
    return weights;
}

SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                               const std::array<double, 3>& direction) {
    const FaceWeights weights = face_weights(input, face);
    SparseVector mean = on_unknowns(spread(weights, direction), map);
    for (double& value : mean.values) value /= weights.area_m2;
    return mean;
}

SparseVector point_displacement(const model::Case& input, const DofMap& map, const std::string& name,
                                const mesh::Point& point, const std::array<double, 3>& direction) {
    const auto location = mesh::locate(input.mesh, point);
    if (!location)
        throw Error(ExitCode::bad_input, "outputs." + name, "the point is outside the mesh",
                    "use a point of the undeformed part");
    const auto nodes = input.mesh.cell_nodes(location->cell);
    return on_unknowns(spread({{nodes.begin(), nodes.end()}, location->weights, 1.0}, direction), map);
}

SparseVector on_unknowns(const NodalForces& forces, const DofMap& map) {
    SparseVector vector;
    for (std::size_t k = 0; k < forces.nodes.size(); ++k)
        for (int i = 0; i < map.dimension; ++i) add_component(forces.nodes[k], i, forces.forces_N[k][i], map, vector);
    return vector;
}

NodalForces face_force(const model::Case& input, const std::string& face, const std::array<double, 3>& traction_Pa) {
    return spread(face_weights(input, face), traction_Pa);
}

NodalForces plug_force(const model::Case& input, const model::PressureLoad& load) {
    NodalForces plugs;
    if (!load.sealed || !load.plug_thrust) return plugs;
    for (const auto& target : load.targets) {
        const auto cavity = std::ranges::find(input.cavities, target, &model::Cavity::name);
        if (cavity == input.cavities.end()) continue;
        for (const auto& opening : cavity->openings) {
            const FaceWeights weights = face_weights(input, opening.face);
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

NodalForces body_force(const model::Case& input, std::span<const fem::ReferenceCell> references,
                       const model::BodyForce& force) {
    const mesh::Mesh& mesh = input.mesh;
    const auto density = densities(input, force.name);
    std::map<Index, double> mass;
    std::vector<fem::PointState> points;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& reference = reference_of(references, mesh.cell_type(cell));
        const auto nodes = mesh.cell_nodes(cell);
        std::vector<double> X(reference.displacement_dofs()), rest(reference.dofs(), 0.0);
        for (int i = 0; i < mesh.dimension; ++i)
            for (int a = 0; a < reference.nodes; ++a) X[i * reference.nodes + a] = mesh.point(nodes[a])[i];
        points.clear();
        const std::size_t moving = X.size();
        fem::CellPoints work(reference);
        fem::sample_cell(reference, input.kinematics, material::FiberFrame::cartesian,
                         {X, {rest.data(), moving}, {rest.data() + moving, rest.size() - moving}, 1.0}, work, points);
        for (std::size_t q = 0; q < points.size(); ++q)
            for (int a = 0; a < reference.nodes; ++a)
                mass[nodes[a]] +=
                    density[mesh.cell_regions[cell]] * points[q].weight_m3 * reference.N[q * reference.nodes + a];
    }
    return spread(listed(mass), force.acceleration_m_s2);
}

}  // namespace soft::fem
