#pragma once
#include <cmath>

#include "fem/system.hpp"

namespace soft::fem {

/// A smooth vector: a displacement of about `size` [m] and pressures of order one unknown.
inline linalg::Vector wavy(const System& system, double size, double phase) {
    auto x = system.make_vector();
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i)
        SOFT_PETSC(VecSetValue(x, i, size * std::sin(phase + 0.37 * static_cast<double>(i)), INSERT_VALUES));
    linalg::assemble(x);
    return x;
}

}  // namespace soft::fem
