#pragma once
/// What is said where memory ends, and a look ahead for libraries that crash or hang there. Tested by tests/faults/memory.sh.
#include <cstddef>

#include "core/error.hpp"

namespace soft::core {

/// What ran out, by whomever it is noticed: a std::bad_alloc, PETSc, MUMPS, HDF5.
[[nodiscard]] Error out_of_memory();

/// Throws out_of_memory() where the process cannot have `bytes` more of address space (ulimit -v, limits of a job).
void require_memory(std::size_t bytes);

}  // namespace soft::core
