#pragma once
/// Settings and error checks shared by all uses of MUMPS. Internal to the module.
#include <algorithm>
#include <array>

#include "core/memory.hpp"

namespace soft::linalg {

/// ICNTL(14), work space beyond the estimate [%]: the default is too small for the pivoting of a saddle-point matrix.
constexpr int mumps_work_space = 80;

/// `status` is INFOG(1). Throws if an allocation failed (reals or integers, in the analysis or later, or beyond ICNTL(23)): smaller
/// load steps would not help.
inline void require_mumps_memory(int status) {
    constexpr std::array allocation_errors{-5, -7, -13, -19};
    if (std::ranges::find(allocation_errors, status) != allocation_errors.end()) throw core::out_of_memory();
}

}  // namespace soft::linalg
