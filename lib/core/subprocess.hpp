#pragma once
/// Runs library calls that may crash, loop or exhaust the memory on a bad file in a child process. Its output is discarded.
/// Tested by core/subprocess_test.
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "core/files.hpp"

namespace soft::core {

struct SubprocessLimits {
    std::chrono::seconds wall;                                     ///< wall-clock time
    std::optional<std::chrono::seconds> processor = std::nullopt;  ///< CPU time
    std::size_t memory = no_limit;  ///< bytes in addition to what the process already uses
};

struct SubprocessOutcome {
    std::optional<Bytes> result;  ///< what `work` returned; nullopt if it threw, crashed or was killed at a limit
    std::string reason;           ///< why there is no result: "it crashes (Segmentation fault)"
};

/// Runs `work` in a forked copy of this process. Error(internal) if the process cannot be created.
[[nodiscard]] SubprocessOutcome run_in_subprocess(const std::function<Bytes()>& work, const SubprocessLimits& limits);

}  // namespace soft::core
