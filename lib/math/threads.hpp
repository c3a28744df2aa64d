#pragma once
/// Number of threads of a parallel loop. Tested by fem/settings_test and linalg/multifrontal_test (equal results).
#include <omp.h>

namespace soft {

/// `stated` if positive, else the threads that OpenMP may use: all cores, OMP_NUM_THREADS, or what a program has set.
[[nodiscard]] inline int thread_count(int stated) { return stated > 0 ? stated : omp_get_max_threads(); }

}  // namespace soft
