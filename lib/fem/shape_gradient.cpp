#include "fem/shape_gradient.hpp"

#include <algorithm>

#include "linalg/profile.hpp"

namespace soft::fem {

bool has_shape_gradient(const Discretization& fe) {
    const bool in_section = fe.input.kinematics == model::Kinematics::axisymmetric;
    return fe.input.formulation != model::Formulation::f_bar && !model::is_inelastic(fe.input) &&
           std::ranges::all_of(fe.rubbers, [&](const material::AnyRubber& any) {
               return std::visit(
                   [&](const auto& rubber) {
                       return in_section || !rubber.fibers || rubber.fiber_frame == material::FiberFrame::cartesian;
                   },
                   any);
           });
}

std::vector<std::vector<Vector3>> ShapeGradient::evaluate(Vec x, const LoadLevels& levels, std::span<const Vec> psis) {
    const linalg::ScopedTimer timed(linalg::Phase::residual);
    while (states_.size() <= psis.size()) states_.emplace_back(fe_, std::span<const mesh::Index>{});
    states_[0].prescribe(levels);
    states_[0].read(x);
    for (std::size_t k = 0; k < psis.size(); ++k) states_[k + 1].read(psis[k]);
    const mesh::Mesh& mesh = fe_.input.mesh;
    std::vector<std::vector<Vector3>> sums(psis.size(), std::vector<Vector3>(mesh.points.size()));
    std::vector<std::vector<double>> local(psis.size()), shape;
    for (const CellGroup& group : fe_.groups) {
        const ReferenceCell& reference = *group.reference;
        LocalCell cell(reference);
        for (std::size_t c = 0; c < group.cells.size(); ++c) {
            gather(fe_, states_[0], group, c, cell);
            const auto dofs = group.dofs_of(c);
            for (std::size_t k = 0; k < psis.size(); ++k) {
                local[k].clear();
                for (const PetscInt dof : dofs) local[k].push_back(states_[k + 1][dof]);
            }
            std::visit(
                [&](const auto& rubber) {
                    find_shape_gradients(reference, fe_.input.kinematics, rubber,
                                         cell.input(fe_.dofs.pressure_scale_Pa), local, cell.out, shape);
                },
                *group.rubber);
            const auto nodes = mesh.cell_nodes(group.cells[c]);
            for (std::size_t k = 0; k < psis.size(); ++k)
                for (std::size_t i = 0; i < static_cast<std::size_t>(reference.dimension); ++i)
                    for (std::size_t a = 0; a < nodes.size(); ++a)
                        sums[k][static_cast<std::size_t>(nodes[a])][i] += shape[k][i * nodes.size() + a];
        }
    }
    for (auto& sum : sums)
        MPI_Allreduce(MPI_IN_PLACE, sum.data(), static_cast<int>(3 * sum.size()), MPI_DOUBLE, MPI_SUM, fe_.comm);
    return sums;
}

}  // namespace soft::fem
