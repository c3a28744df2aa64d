#pragma once
/// Parallel loops. Tested by math/threads_test; equal results: fem/settings_test, linalg/multifrontal_test, linalg/threaded_product_test.
#include <cstddef>
#include <functional>

namespace soft {

/// `stated` if positive, else the threads that OpenMP may use: all cores, OMP_NUM_THREADS, or what a program has set; but no more than
/// the system allows, because libgomp ends the process if it cannot start one. The threads are started and kept by the first call.
[[nodiscard]] int thread_count(int stated);

/// Divides 0 .. count - 1 into one range per thread, of equal lengths, and calls work(begin, end) for each. Rethrows an exception of work.
void for_ranges(std::size_t count, int threads, const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace soft
