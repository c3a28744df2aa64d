#pragma once
/// The rows of a path solved again, each for itself, on the mesh with every cell halved.
///
/// A row is carried over as displacements u0 and direction t (mesh::prolong) and solved for with
///     t . (u - u0) = 0
/// (the arc constraint, t of unit length, zero in the pressure unknowns) and the load factor free: the state of the finer
/// body nearest to where the coarse one was, which exists at limit points and on branches alike. The last row of a stage
/// holds instead what the stage ended by (its load factor or an `until`). Levels of the loads are measured from the finer
/// body's own state at the end of the stage before.
/// Tested by solver/accuracy_test and the verification suite.
#include <optional>

#include "mesh/refine.hpp"
#include "solver/newton.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

enum class RowPlace { first, inside, ends_stage };

class RefinedPath {
public:
    /// `fine`: the system of the same case on the mesh of `refined`. Both must outlive it.
    RefinedPath(assembly::System& fine, const mesh::Refined& refined);

    /// Rows in the order of the path, `first` only the first. The result's stability is that of the coarse row; its fields
    /// are left out where `fields` says so. nullopt where Newton's method does not converge.
    enum class Keep { fields, values };
    [[nodiscard]] std::optional<RowState> solve(const RowState& coarse, RowPlace place, Keep keep);

    [[nodiscard]] int iterations() const noexcept { return iterations_; }
    [[nodiscard]] int factorizations() const noexcept { return newton_.factorizations(); }

private:
    void set_stage(int stage);
    /// The guess of a row; sets nearest_, the arc constraint, or the load factor where the path does not move.
    [[nodiscard]] State carry_over(const RowState& coarse);
    [[nodiscard]] std::optional<State> equilibrium(const RowState& coarse, RowPlace place);
    [[nodiscard]] bool end_stage(State& state);
    [[nodiscard]] bool converges(const Constraint& constraint, double target, State& state);

    assembly::System& system_;
    const mesh::Refined& refined_;
    Newton newton_;
    int stage_ = -1;
    std::optional<StageLoads> loads_;
    linalg::Vector origin_, direction_, pressures_;  // pressures_: the row before, a guess of the pressure unknowns
    std::vector<double> undeformed_volumes_m3_;      // by load
    Constraint nearest_;
    std::optional<PathPoint> last_;
    FromTangent of_last_ = FromTangent::along_the_path;
    int iterations_ = 0;
};

}  // namespace soft::solver
