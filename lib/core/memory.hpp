#pragma once
/// The out-of-memory error, and a check of available address space before calling libraries that crash or hang without memory.
/// Tested by tests/faults/memory.sh.
#include <cstddef>

#include "core/error.hpp"

namespace soft::core {

/// The error for any failed allocation, whether detected as std::bad_alloc or by PETSc, MUMPS or HDF5.
[[nodiscard]] Error out_of_memory();

/// Throws out_of_memory() if the process cannot map `bytes` more of address space (ulimit -v, limits of a job).
void require_memory(std::size_t bytes);

}  // namespace soft::core
