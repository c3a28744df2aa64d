#pragma once
/// What all uses of MUMPS share. Internal to the module.
#include <algorithm>
#include <array>

#include "core/memory.hpp"

namespace soft::linalg {

/// ICNTL(14), work space beyond the estimate [%]: small by default, and the pivoting of a saddle point needs more.
constexpr int mumps_work_space = 80;

/// `status`: INFOG(1). Throws where an allocation failed, of reals or integers in the analysis, later, or beyond ICNTL(23): shorter
/// steps do not help.
inline void require_mumps_memory(int status) {
    constexpr std::array no_memory{-5, -7, -13, -19};
    if (std::ranges::find(no_memory, status) != no_memory.end()) throw core::out_of_memory();
}

}  // namespace soft::linalg
