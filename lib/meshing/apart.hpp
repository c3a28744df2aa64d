#pragma once
/// Work of libraries that may crash or never end on a bad file: in a process of its own. What it prints to stdout goes nowhere.
/// Private to the room. Held by geometry/part_test.
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

namespace soft::meshing {

/// What `work` returns; nullopt where it throws, crashes, or takes longer than the limit (it is ended then).
/// Error(internal) where no process can be made.
[[nodiscard]] std::optional<std::vector<double>> done_apart(const std::function<std::vector<double>()>& work,
                                                            std::chrono::seconds limit);

}  // namespace soft::meshing
