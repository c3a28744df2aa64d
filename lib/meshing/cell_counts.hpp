#pragma once
/// Numbers of cells that follow from lengths by rounding. Derivatives by a length need the same cells for slightly different lengths
/// (geometry/variations.hpp): a generator then repeats the numbers of another run instead of rounding again. Generators decide in the same
/// order in every run. Tested by geometry/variations_test.
#include <functional>
#include <vector>

namespace soft::meshing {

/// decide(), or within repeat_counts the number of the recorded run at this place.
[[nodiscard]] int cell_count(const std::function<int()>& decide);

/// The numbers that generate() decides in this thread.
[[nodiscard]] std::vector<int> record_counts(const std::function<void()>& generate);
/// Runs generate() with these numbers; false if it does not ask for exactly as many.
[[nodiscard]] bool repeat_counts(const std::vector<int>& counts, const std::function<void()>& generate);

}  // namespace soft::meshing
