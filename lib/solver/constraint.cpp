#include "solver/constraint.hpp"

#include <stdexcept>

namespace soft::solver {

double evaluate(const Constraint& constraint, assembly::System& system, Vec x, double load_factor, Vec gradient) {
    SOFT_PETSC(VecZeroEntries(gradient));
    switch (constraint.kind) {
        case ConstraintKind::load_factor: return load_factor;
        case ConstraintKind::volume: {
            const auto volume = system.enclosed_volume(x, gradient);
            if (!volume) throw std::logic_error("volume constraint without a cavity");
            return *volume;
        }
        case ConstraintKind::output:
            linalg::copy(system.output_weights(constraint.output), gradient);
            return linalg::dot(gradient, x);
        case ConstraintKind::arc:
            linalg::copy(constraint.arc_direction, gradient);
            return linalg::dot(gradient, x) - linalg::dot(gradient, constraint.arc_origin);
    }
    throw std::logic_error("evaluate: unknown constraint");
}

}  // namespace soft::solver
