#pragma once
/// A vector of unknowns and the levels of the prescribed motions, as this rank's cells and facets read them, with the internal
/// variables of the materials.
/// Tested by fem/system_test.
#include <span>
#include <vector>

#include "fem/discretization.hpp"
#include "fem/internal_variables.hpp"
#include "fem/load_levels.hpp"
#include "fem/solid_kernel.hpp"
#include "fem/surface_cell.hpp"
#include "math/threads.hpp"

namespace soft::fem {

/// The step of the inelastic materials to a state, at this rank's points.
struct InelasticStep {
    std::vector<material::PointStep> points;           ///< by the number of for_each_point
    double dissipated_J = 0, error2 = 0, stress2 = 0;  ///< integrals over the volume
};

class LocalState {
public:
    /// Reads the unknowns of this rank's cells and of `nodes`; rank 0 also those of all named faces. The discretization must outlive this
    /// object.
    LocalState(const Discretization& fe, std::span<const mesh::Index> nodes);

    /// Sets the values of the prescribed components and the time.
    void prescribe(const LoadLevels& levels);
    [[nodiscard]] const LoadLevels& levels() const noexcept { return levels_; }
    /// Copies the unknowns from their ranks. Collective.
    void read(Vec x);

    /// Value of an unknown that this rank reads; of a fixed or prescribed component by its negative index.
    [[nodiscard]] double operator[](PetscInt dof) const { return values_[static_cast<std::size_t>(first_ + dof)]; }
    /// Current positions of the nodes, component by component.
    void positions(const SurfaceCell& cell, std::vector<double>& x) const;

    /// To this state; empty without inelastic materials.
    [[nodiscard]] const InelasticStep& inelastic_step();

    [[nodiscard]] InternalVariables& internal() noexcept { return internal_; }
    [[nodiscard]] const InternalVariables& internal() const noexcept { return internal_; }

private:
    const Discretization& fe_;
    LoadLevels levels_;
    PetscInt first_;  // index of unknown 0; before it 0 for fixed components, and the prescribed values by slot
    std::vector<double> values_;  // by unknown
    linalg::Vector unknowns_;     // those values as a vector
    linalg::Scatter scatter_;
    InternalVariables internal_;
    InelasticStep step_;
    std::vector<double> step_values_;  // values_ where it leads
    double step_time_s_ = 0;
    std::int64_t step_number_ = -1;
};

/// Workspace for one cell, reused from cell to cell.
struct LocalCell {
    explicit LocalCell(const ReferenceCell& reference)
        : X(reference.displacement_dofs()), unknowns(reference.dofs()), out(reference) {}
    std::vector<double> X, unknowns;  ///< component by component
    material::StepMemory memory;
    bool is_elastic = true;
    CellOutput out;
    [[nodiscard]] CellInput input(double pressure_scale_Pa) const {
        return {X,
                {unknowns.data(), X.size()},
                {unknowns.data() + X.size(), unknowns.size() - X.size()},
                pressure_scale_Pa,
                is_elastic ? nullptr : &memory};
    }
};

/// Reads positions, unknowns and internal variables of cell `index` of a group.
void gather(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
            LocalCell& cell);
/// The same, then computes the residual and, if wanted, the stiffness.
void integrate(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
               material::Wanted wanted, LocalCell& cell);

/// Threads for a loop over the cells of a group: 1 for small groups. The results do not depend on it.
[[nodiscard]] int threads_for(const Discretization& fe, const CellGroup& group);

/// Calls visit(point, location, number) for every quadrature point of this rank's cells, in any order, by several threads; `number` counts
/// the points of all groups.
template <class Visit>
void for_each_point(const Discretization& fe, const LocalState& state, const Visit& visit) {
    std::size_t first = 0;
    for (const auto& group : fe.groups) {
        const auto per_cell = static_cast<std::size_t>(group.reference->points);
        const auto frame = std::visit([](const auto& rubber) { return rubber.fiber_frame; }, *group.rubber);
        for_ranges(group.cells.size(), threads_for(fe, group), [&](std::size_t begin, std::size_t end) {
            LocalCell cell(*group.reference);
            std::vector<PointState> points;
            for (std::size_t c = begin; c < end; ++c) {
                gather(fe, state, group, c, cell);
                points.clear();
                sample_cell(*group.reference, fe.input.kinematics, frame, cell.input(fe.dofs.pressure_scale_Pa),
                            cell.out.points, points);
                for (std::size_t q = 0; q < per_cell; ++q)
                    visit(points[q], PointLocation{group, c, q}, first + c * per_cell + q);
            }
        });
        first += group.cells.size() * per_cell;
    }
}

/// Number of quadrature points of this rank's cells.
[[nodiscard]] std::size_t point_count(const Discretization& fe);

/// Collects the derivative of a scalar by the unknowns (`by_x` is overwritten; nullptr if not needed) and by the level of each motion
/// (overwritten; empty if not needed).
class Slopes {
public:
    Slopes(const Discretization& fe, Vec by_x, std::span<double> by_motion);
    [[nodiscard]] bool wanted() const noexcept { return by_x_ != nullptr || !by_motion_.empty(); }
    void add(std::span<const PetscInt> dofs, std::span<const double> slope);
    /// Adds the contributions of all ranks. Collective.
    void finish();

private:
    const Discretization& fe_;
    Vec by_x_;
    std::span<double> by_motion_;
};

}  // namespace soft::fem
