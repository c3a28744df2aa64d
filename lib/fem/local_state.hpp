#pragma once
/// A vector of unknowns and the levels of the prescribed motions, as this rank's cells and facets read them.
/// Tested by fem/system_test.
#include <span>
#include <vector>

#include "fem/discretization.hpp"
#include "fem/load_levels.hpp"
#include "fem/solid_kernel.hpp"
#include "fem/surface_cell.hpp"

namespace soft::fem {

class LocalState {
public:
    /// Reads the unknowns of this rank's cells and of `nodes`; rank 0 also those of all named faces. The discretization must outlive this
    /// object.
    LocalState(const Discretization& fe, std::span<const mesh::Index> nodes);

    /// Sets the values of the prescribed components.
    void prescribe(const LoadLevels& levels);
    [[nodiscard]] const LoadLevels& levels() const noexcept { return levels_; }
    /// Copies the unknowns from their ranks. Collective.
    void read(Vec x);

    /// Value of an unknown that this rank reads; of a fixed or prescribed component by its negative index.
    [[nodiscard]] double operator[](PetscInt dof) const { return values_[static_cast<std::size_t>(first_ + dof)]; }
    /// Current positions of the nodes, component by component.
    void positions(const SurfaceCell& cell, std::vector<double>& x) const;

private:
    const Discretization& fe_;
    LoadLevels levels_;
    PetscInt first_;  // index of unknown 0; before it 0 for fixed components, and the prescribed values by slot
    std::vector<double> values_;  // by unknown
    linalg::Vector unknowns_;     // those values as a vector
    linalg::Scatter scatter_;
};

/// Workspace for one cell, reused from cell to cell.
struct LocalCell {
    explicit LocalCell(const ReferenceCell& reference)
        : X(reference.displacement_dofs()), unknowns(reference.dofs()), out(reference) {}
    std::vector<double> X, unknowns;  ///< component by component
    CellOutput out;
    [[nodiscard]] CellInput input(double pressure_scale_Pa) const {
        return {X,
                {unknowns.data(), X.size()},
                {unknowns.data() + X.size(), unknowns.size() - X.size()},
                pressure_scale_Pa};
    }
};

/// Reads positions and unknowns of cell `index` of a group.
void gather(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
            LocalCell& cell);
/// The same, then computes the residual and, if wanted, the stiffness.
void integrate(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
               material::Wanted wanted, LocalCell& cell);

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
