#include "fem/cavity_volumes.hpp"

#include <algorithm>
#include <set>

#include "linalg/profile.hpp"

namespace soft::fem {

CavityVolumes::CavityVolumes(const Discretization& fe, LocalState& state) : fe_(fe), state_(state) {
    const model::Case& input = fe.input;
    for (const auto& load : input.loads) {
        auto& indices = by_load_.emplace_back();
        for (const auto& target : load.targets) {  // the order of model::measured_cavities
            const auto found = std::ranges::find(input.cavities, target, &model::Cavity::name);
            if (found == input.cavities.end()) continue;
            indices.push_back(cavities_.size());
            const auto facets = model::cavity_facets(input, *found);
            Cavity& cavity = cavities_.emplace_back(Cavity{own_facets(fe, facets), {}});
            if (input.mesh.dimension == 3 && fe.rank == 0)
                for (const auto& rim : model::rims(input, facets)) cavity.rims.push_back(make_rim(rim));
        }
    }
}

CavityVolumes::Rim CavityVolumes::make_rim(const std::vector<model::RimEdge>& edges) const {
    Rim rim;
    std::set<mesh::Index> nodes;
    for (const auto& edge : edges) {
        const auto type = edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2;
        rim.edges.push_back(make_surface_cell(fe_, edge, &model::reference_facet(type)));
        nodes.insert(edge.begin(), edge.end());
    }
    rim.nodes = nodes.size();
    rim.on_plane = model::planes_through(fe_.input, edges);
    return rim;
}

double CavityVolumes::of_cavity(std::size_t cavity, Vec x, Vec gradient, std::span<double> by_motion) {
    return sum({&cavity, 1}, x, gradient, by_motion);
}

double CavityVolumes::of_load(std::size_t load, Vec x, Vec gradient, std::span<double> by_motion) {
    return sum(by_load_.at(load), x, gradient, by_motion);
}

double CavityVolumes::sum(std::span<const std::size_t> cavities, Vec x, Vec gradient, std::span<double> by_motion) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    Slopes slopes(fe_, gradient, by_motion);
    state_.read(x);
    double total = 0;
    for (const std::size_t index : cavities) {
        const Cavity& cavity = cavities_.at(index);
        double volume = 0;
        add_wall(cavity, volume, slopes);
        for (const Rim& rim : cavity.rims) add_caps(rim, volume, slopes);
        total += volume / fe_.input.model_fraction;
    }
    MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    slopes.finish();
    return total;
}

void CavityVolumes::add_wall(const Cavity& cavity, double& volume, Slopes& slopes) const {
    std::vector<double> x, slope;
    for (const auto& facet : cavity.facets) {
        state_.positions(facet, x);
        slope.assign(x.size(), 0.0);
        volume += model::swept_volume(*facet.reference, fe_.input.kinematics, x, slope);
        for (double& s : slope) s /= fe_.input.model_fraction;
        slopes.add(facet.dofs, slope);
    }
}

void CavityVolumes::add_caps(const Rim& rim, double& volume, Slopes& slopes) const {
    const double fraction = fe_.input.model_fraction, nodes = static_cast<double>(rim.nodes);
    std::vector<double> y, slope;
    Vector3 apex{}, apex_slope{};
    std::vector<std::pair<PetscInt, std::size_t>> apex_dofs;  // unknown and component; each node once
    std::set<mesh::Index> seen;
    for (const auto& edge : rim.edges) {
        state_.positions(edge, y);
        const std::size_t n = edge.nodes.size();
        for (std::size_t a = 0; a < n; ++a) {
            if (!seen.insert(edge.nodes[a]).second) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                if (rim.on_plane[i]) continue;
                apex[i] += y[i * n + a] / nodes;
                apex_dofs.emplace_back(edge.dofs[i * n + a], i);
            }
        }
    }
    for (const auto& edge : rim.edges) {
        state_.positions(edge, y);
        slope.assign(y.size(), 0.0);
        volume += model::cap_volume(*edge.reference, y, apex, slope, apex_slope);
        for (double& s : slope) s /= fraction;
        slopes.add(edge.dofs, slope);
    }
    const double share = 1.0 / (nodes * fraction);
    for (const auto& [dof, component] : apex_dofs) {
        const double part = share * apex_slope[component];
        slopes.add({&dof, 1}, {&part, 1});
    }
}

}  // namespace soft::fem
