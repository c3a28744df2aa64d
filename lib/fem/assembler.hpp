#pragma once
/// Assembles the equilibrium on the free unknowns x = (displacements, scaled pressures) under given load levels:
///   R(x, levels) = internal forces + contact forces - sum over the loads of level x force(x),    K = dR/dx,
/// with pressure x force per unit pressure for the pressure loads, nodal forces of the dead loads, and
/// prescribed displacements as values of the nodes of the cells (and facets) that they move. Collective over the communicator.
/// Tested by fem/system_test, fem/loads_test (Taylor remainders, rank independence) and the verification suite.
#include <optional>
#include <span>
#include <vector>

#include "fem/contact.hpp"
#include "fem/loads.hpp"
#include "fem/local_state.hpp"
#include "linalg/block_entries.hpp"

namespace soft::fem {

/// Outcome of one evaluation; an inverted cell is an expected failure.
struct Evaluation {
    double min_jacobian = 1;      ///< smallest det F over all quadrature points
    mesh::Index worst_cell = -1;  ///< cell where it occurs
    double force_scale = 0;       ///< root of the sum of squares of all cells' nodal forces, before they cancel
    bool pattern_grew = false;    ///< contact needs, or has added, entries beyond the pattern of K
    [[nodiscard]] bool admissible() const noexcept { return min_jacobian > 0.0; }
};

/// What happens to blocks of contact beyond the pattern of a matrix. To insert them moves the whole matrix for every row.
enum class NewEntries { omit, insert };

/// A direction of the load levels, and the vector that receives -dR/d(direction).
struct LoadColumn {
    LoadLevels direction;
    Vec out = nullptr;
};

class Assembler {
public:
    /// All four must outlive this object.
    Assembler(const Discretization& fe, const Loads& loads, Contact& contact, LocalState& state)
        : fe_(fe), loads_(loads), contact_(contact), state_(state) {}

    /// Fills R and the columns, and with K also the tangent (required by columns that move a face). Prescribes the levels' motions.
    /// If the result is not admissible they are incomplete, and so is K where the pattern grew and new entries are omitted.
    Evaluation evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns,
                        NewEntries entries);

    /// The part of R of pressure and dead loads alone, and of no cell, and with K its derivative. Prescribes the levels.
    void load_forces(Vec x, const LoadLevels& levels, Vec R, Mat K = nullptr);

    /// Power of the loads on the modelled part [W], in the time unit of `velocity` of the unknowns and `rates`
    /// of the levels; prescribed motions contribute with the forces that move their nodes. Prescribes the levels.
    [[nodiscard]] double load_power(Vec x, Vec velocity, const LoadLevels& levels, const LoadLevels& rates);

private:
    /// What one evaluation adds to; K nullptr: no tangent is computed.
    struct Targets {
        Vec R;
        linalg::BlockAdder* K;
        std::span<const LoadColumn> columns;
    };
    /// Indices of the blocks of cells and facets in matrices of the pattern used last.
    struct MatrixIndices {
        PetscObjectId matrix = 0;
        PetscObjectState state = -1;
        std::uint64_t pattern = 0;
        std::vector<linalg::BlockIndices> groups, pressures;
    };

    void find_block_indices(Mat K);
    void add_cells(std::size_t group, const Targets& to, Evaluation& result) const;
    void add_stiffness(std::size_t group, std::size_t first, std::span<const LocalCell> cells, int threads,
                       linalg::BlockAdder& K) const;
    void add_pressures(std::size_t load, const Targets& to) const;
    void add_dead_loads(const Targets& to) const;
    /// Returns whether a block is beyond the pattern of K.
    [[nodiscard]] bool add_contact(const Targets& to, Mat K, NewEntries entries) const;
    /// column -= matrix x (velocity of the prescribed components), for one cell or facet.
    void subtract_moved(const LoadColumn& column, std::span<const PetscInt> dofs, std::span<const double> matrix) const;
    /// Power of the forces that move prescribed components.
    [[nodiscard]] double motion_power(const LoadLevels& rates) const;
    [[nodiscard]] double power_of(std::span<const PetscInt> dofs, std::span<const double> force,
                                  const LoadLevels& rates) const;
    [[nodiscard]] double velocity_of(PetscInt dof, const LoadLevels& rates) const;

    const Discretization& fe_;
    const Loads& loads_;
    Contact& contact_;
    LocalState& state_;
    MatrixIndices indices_;
};

}  // namespace soft::fem
