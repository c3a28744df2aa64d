#pragma once
/// The rows of a path solved again, each independently, on the mesh with every cell halved.
///
/// A row is transferred as displacements u0 and direction t (mesh::prolong) and solved for with
///     t . (u - u0) = 0
/// (the arc constraint, t of unit length, zero in the pressure unknowns) and a free load factor: the state of the finer
/// mesh nearest to that of the coarse one, which exists at limit points and on branches alike. Newton's method starts from u0 plus the
/// difference that it found in the row before; else from u0; else it follows the chord of the coarse path in parts from that row; else the
/// load is that of the coarse row; also where the nearest state lies beyond the loads of the stage. With an obstacle that moves, a state counts
/// only within 0.05 of the load factor of the coarse row. For the last row of a stage follows what ended the stage (its load factor or an
/// `until`). Load levels are relative to the state that the
/// finer mesh has at the end of the stage before.
/// Tested by solver/accuracy_test and the verification suite.
#include <optional>

#include "mesh/refine.hpp"
#include "solver/corrector.hpp"
#include "solver/natural_frequencies.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

enum class RowPosition { first, inside, ends_stage };

class RefinedPath {
public:
    /// `fine`: the system of the same case on the mesh of `refined`. Both must outlive it.
    RefinedPath(fem::System& fine, const mesh::Refined& refined);

    /// Call for the rows in the order of the path, `first` only for the first. The result's stability is that of the coarse row. With
    /// Keep::values it has its load, volumes, outputs, stage and counts alone: such a row is only compared. nullopt where Newton's method does not
    /// converge.
    enum class Keep { fields, values };
    [[nodiscard]] std::optional<RowState> solve(const RowState& coarse, RowPosition position, Keep keep);

    [[nodiscard]] WorkCount work() const { return corrector_.work(); }

private:
    void set_stage(int stage);
    [[nodiscard]] RowState with_fields(model::Step step, const PathPoint& point, const model::Step& coarse);
    /// The initial guess of a row. Sets nearest_: the arc constraint, or the load factor where the tangent is zero.
    [[nodiscard]] State carry_over(const RowState& coarse);
    [[nodiscard]] std::optional<State> equilibrium(const RowState& coarse, RowPosition position);
    [[nodiscard]] bool end_stage(State& state, const RowState& coarse);
    /// With an obstacle that moves: whether the load is near that of the row. Elsewhere the state has left the obstacle.
    [[nodiscard]] bool is_at_load(const State& state, const RowState& coarse) const;
    /// Solves for the state nearest to the coarse row, at its load.
    [[nodiscard]] bool correct_to_nearest(State& state, const RowState& coarse);
    /// The row approached from the one before in parts of the coarse step, where the guess is too far away, as in contact.
    enum class Approach { by_load, to_the_nearest };
    [[nodiscard]] std::optional<State> follow_from_last(const RowState& coarse, Approach approach);
    enum class Settle { no, yes };  ///< by an overdamped motion (snap.hpp), where Newton's method fails
    /// The state at the load of the coarse row: where an obstacle just touches the coarse mesh, the finer one is still at rest, and the load
    /// does not move it.
    [[nodiscard]] std::optional<State> at_equal_load(const RowState& coarse, Settle settling);

    fem::System& system_;
    const mesh::Refined& refined_;
    Corrector corrector_;
    int stage_ = -1;
    std::optional<StageLoads> loads_;
    linalg::Vector origin_, direction_;          // the coarse row on the fine mesh, without pressures
    linalg::Vector correction_;                  // of the row before: the solution minus its origin
    double corrected_m_ = 0;                     // norm of that origin; 0: there is none
    std::vector<double> undeformed_volumes_m3_;  // by load
    Constraint nearest_;
    bool moves_obstacle_;
    std::optional<PathPoint> last_;
    std::optional<NaturalFrequencies> frequencies_;
    FromTangent of_last_ = FromTangent::along_the_path;
};

}  // namespace soft::solver
