#pragma once
/// The scalar equation c(state) = target that selects one state on the equilibrium path. Together with R = 0 and the
/// equations of the supplies it forms the bordered system, which is regular at limit points as long as c grows along the path.
///   load_factor: c = lambda        pressure: c = the unknown pressure of a supply [Pa]
///   volume: c = volume of a load's cavities [m^3]       output: c = an output [m or rad]
///   arc: c = t . (x - x0)          length projected on a unit direction t from a state x0 (cylindrical: no load term)
/// Tested by solver/solver_test.
#include <cstddef>
#include <string_view>
#include <vector>

#include "solver/stage_loads.hpp"

namespace soft::solver {

/// A state of the body under a stage's loads.
struct State {
    linalg::Vector x;
    double load_factor = 0;
    std::vector<double> pressures_Pa;  ///< of the free supplies (StageLoads)
};

[[nodiscard]] linalg::Vector copy_of(Vec x);
[[nodiscard]] State copy_of(const State& state);
/// a + share (b - a)
[[nodiscard]] State between(const State& a, const State& b, double share);

enum class ConstraintKind { load_factor, volume, output, arc, pressure };

/// For messages: "load factor", "arc length".
[[nodiscard]] std::string_view name(ConstraintKind kind);

struct Constraint {
    ConstraintKind kind = ConstraintKind::load_factor;
    std::size_t index = 0;        ///< of the output, of the load (volume), of the free supply (pressure)
    Vec arc_origin = nullptr;     ///< x0, kind arc only; not owned
    Vec arc_direction = nullptr;  ///< t of unit length, kind arc only; not owned
    double scale = 0;             ///< |c - target| is compared to the larger of this and |target|
};

/// c and its derivatives, except dc/dx.
struct ConstraintValue {
    double value = 0;
    double by_load_factor = 0;
    std::vector<double> by_pressures;  ///< one per free supply
};

/// Fills `gradient` = dc/dx. Uses the prescribed motions of the state.
[[nodiscard]] ConstraintValue evaluate(const Constraint& constraint, fem::System& system, const StageLoads& loads,
                                       const State& state, Vec gradient);

/// target - value; for an angle, the shorter way round.
[[nodiscard]] double remaining(const Constraint& constraint, const model::Case& input, double target, double value);

}  // namespace soft::solver
