#pragma once
/// Work of libraries that may crash, loop or ask for all memory on a bad file: in a process of its own. What it prints goes
/// nowhere. Tested by core/subprocess_test.
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "core/files.hpp"

namespace soft::core {

struct SubprocessLimits {
    std::chrono::seconds wall;                                     ///< time on the clock
    std::optional<std::chrono::seconds> processor = std::nullopt;  ///< time of computing
    std::size_t memory = no_limit;                                 ///< bytes beyond what the process has already
};

struct SubprocessEnd {
    std::optional<Bytes>
        result;          ///< what `work` returned; nullopt where it threw, crashed or met a limit (it is ended then)
    std::string reason;  ///< of the latter: "it crashes (Segmentation fault)"
};

/// Runs `work` in a copy of this process. Error(internal) where no process can be made.
[[nodiscard]] SubprocessEnd run_in_subprocess(const std::function<Bytes()>& work, const SubprocessLimits& limits);

}  // namespace soft::core
