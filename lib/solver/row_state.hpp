#pragma once
/// What a converged state says of itself, and a row of the path with its fields, free of the numbering of unknowns: what
/// carries a row to another mesh. Tested by solver/solver_test, solver/accuracy_test.
#include <vector>

#include "solution/path.hpp"
#include "solver/history.hpp"

namespace soft::solver {

/// A row of the path. The fields are on rank 0 alone.
struct RowState {
    solution::Step step;                    ///< as it is reported
    std::vector<double> displacement_m;     ///< [point x 3]
    std::vector<double> tangent;            ///< [point x 3] displacement along the path, any positive scale
    std::vector<double> pressure_Pa;        ///< [point], empty without pressure unknowns
    std::vector<double> free_pressures_Pa;  ///< of the supplies whose pressure is unknown, on all ranks
};

/// The load that a curve shows (model::leading_load), at a state.
[[nodiscard]] double leading_of(const model::Case& input, const StageLoads& loads, const State& state);

/// Where the stage after this one starts: loads, volumes and gas of a point that has been read.
[[nodiscard]] StageStart stage_start_at(const model::Case& input, const StageLoads& loads, const PathPoint& point);

/// Of each pressure load, 0 for one on a face.
[[nodiscard]] std::vector<double> undeformed_volumes_m3(assembly::System& system);

/// Fills the pressures, volumes and outputs of a point with their slopes along its tangent. Angles go on from `before`
/// beyond half a turn, where there is one. Prescribes the motions of the state.
void read_values(assembly::System& system, const StageLoads& loads, const PathPoint* before, PathPoint& point);

/// The same under loads that are known as `levels` and their `slopes`, per unit of what the tangent is per unit of.
void read_values(assembly::System& system, const LoadLevels& levels, const LoadLevels& slopes, const PathPoint* before,
                 PathPoint& point);

/// Loads, volumes and outputs of a point that has been read, its slopes times `direction` (1 or -1).
[[nodiscard]] solution::Step step_of(const assembly::System& system, const PathPoint& point, double direction);

/// Whether the tangent of a point is that of the path which leaves it: at the end of a stage it is not that of the next one.
enum class FromTangent { along_the_path, of_another_stage };

/// Work of the loads [J], modelled part, on the way between two points that have been read: Simpson's rule of the power along
/// the cubic with both tangents, so that its error falls with the fourth power of the step. Prescribes the motions of `to`.
/// Tested by solver/work_test.
[[nodiscard]] double work_between(assembly::System& system, const PathPoint& from, const PathPoint& to,
                                  FromTangent of_from);

/// Stretches of a state; gives the energy stored in the modelled part [J]. The motions prescribed are those of the state.
double read_stretches(assembly::System& system, Vec x, solution::Step& step);

/// Stretches and energies of a point that has been read, its slopes times `direction` (1 or -1). Prescribes its motions.
void read_rubber(assembly::System& system, const PathPoint& point, double direction, solution::Step& step);

/// `step` with the fields of the point. The motions prescribed are those of the state.
[[nodiscard]] RowState row_state(assembly::System& system, const PathPoint& point, double direction,
                                 solution::Step step);

}  // namespace soft::solver
