#pragma once
/// Number of threads of a parallel loop. Tested by math/threads_test; equal results: fem/settings_test, linalg/multifrontal_test.

namespace soft {

/// `stated` if positive, else the threads that OpenMP may use: all cores, OMP_NUM_THREADS, or what a program has set; but no more than
/// the system allows, because libgomp ends the process if it cannot start one. The threads are started and kept by the first call.
[[nodiscard]] int thread_count(int stated);

}  // namespace soft
