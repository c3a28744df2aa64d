#pragma once
/// The scalar equation c(x, lambda) = target that picks one state on the equilibrium path. Together with R = 0 it
/// makes the bordered system that is regular at limit points as long as c goes on growing along the path.
///   load_factor: c = lambda        volume: c = enclosed volume [m^3]       output: c = w . x [m]
///   arc: c = t . (x - x0) / |t|    projected length along a direction t from a state x0 (cylindrical: no load term)
/// Held by solver/solver_test.
#include <cstddef>

#include "assembly/system.hpp"

namespace soft::solver {

enum class ConstraintKind { load_factor, volume, output, arc };

struct Constraint {
    ConstraintKind kind = ConstraintKind::load_factor;
    std::size_t output = 0;         ///< index of the output, kind output only
    Vec arc_origin = nullptr;       ///< x0, kind arc only; not owned
    Vec arc_direction = nullptr;    ///< t of unit length, kind arc only; not owned
};

/// Value of c; fills `gradient` = dc/dx (zero for load_factor). dc/dlambda is 1 for load_factor, else 0.
[[nodiscard]] double evaluate(const Constraint& constraint, assembly::System& system, Vec x, double load_factor,
                              Vec gradient);

[[nodiscard]] inline double load_slope(const Constraint& constraint) noexcept {
    return constraint.kind == ConstraintKind::load_factor ? 1.0 : 0.0;
}

}  // namespace soft::solver
