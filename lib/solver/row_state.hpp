#pragma once
/// The values of a converged state, and a row of the path with its fields, independent of the numbering of unknowns, so that
/// a row can be transferred to another mesh. Tested by solver/solver_test, solver/accuracy_test.
#include <vector>

#include "model/path.hpp"
#include "solver/history.hpp"

namespace soft::solver {

/// A row of the path. The fields are on rank 0 alone.
struct RowState {
    model::Step step;                       ///< as reported
    std::vector<double> displacement_m;     ///< [point x 3]
    std::vector<double> tangent;            ///< [point x 3] displacement along the path, any positive scale
    std::vector<double> pressure_Pa;        ///< [point], empty without pressure unknowns
    std::vector<double> free_pressures_Pa;  ///< of the supplies whose pressure is unknown, on all ranks
};

/// The load that a curve shows (model::leading_load), at a state.
[[nodiscard]] double leading_of(const model::Case& input, const StageLoads& loads, const State& state);
/// The same of levels, or its derivative by a direction of the levels and of the load factor.
[[nodiscard]] double leading_of(const model::Case& input, const fem::LoadLevels& levels, double load_factor);

/// The start of the next stage: loads, volumes and gas of a point whose values have been read.
[[nodiscard]] StageStart stage_start_at(const model::Case& input, const StageLoads& loads, const PathPoint& point);

/// Per pressure load, 0 for one on a face.
[[nodiscard]] std::vector<double> undeformed_volumes_m3(fem::System& system);

/// Fills the pressures, volumes and outputs of a point with their slopes along its tangent. If `before` is given, angles
/// continue from it beyond half a turn. Prescribes the motions of the state.
void read_values(fem::System& system, const StageLoads& loads, const PathPoint* before, PathPoint& point);

/// The same for given `levels` and their `slopes`, per unit of the same parameter as the tangent.
void read_values(fem::System& system, const LoadLevels& levels, const LoadLevels& slopes, const PathPoint* before,
                 PathPoint& point);

/// Loads, volumes and outputs of a point whose values have been read, its slopes times `direction` (1 or -1).
[[nodiscard]] model::Step step_of(const fem::System& system, const PathPoint& point, double direction);

/// Whether the tangent of a point is that of the path that leaves it: at the end of a stage it is not that of the next stage.
enum class FromTangent { along_the_path, of_another_stage };

/// Lets contact rest where neither point touches anything (Corrector::solve_at).
void let_contact_rest(fem::System& system, const PathPoint& a, const PathPoint& b);

/// Work of the loads [J], modelled part, between two points whose values have been read: Lobatto's rule of the power along
/// the cubic with both tangents; its error falls with the fourth power of the step. Prescribes the motions of `to`.
/// Tested by solver/work_test.
[[nodiscard]] double work_between(fem::System& system, const PathPoint& from, const PathPoint& to, FromTangent of_from);

/// Fills the stretches of a state, and returns the energies of the modelled part with them. The motions prescribed are those of the state.
fem::StretchSummary read_stretches(fem::System& system, Vec x, model::Step& step);

/// Stretches and energies of a point whose values have been read, its slopes times `direction` (1 or -1). Prescribes its motions.
void read_rubber(fem::System& system, const PathPoint& point, double direction, model::Step& step);

/// `step` with the fields of the point. The motions prescribed are those of the state.
[[nodiscard]] RowState row_state(fem::System& system, const PathPoint& point, double direction, model::Step step);

}  // namespace soft::solver
