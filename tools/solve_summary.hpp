#pragma once
/// What solve tells about a run: the end of the path, its cost. The numbers of --json.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "cli.hpp"
#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::cli {

struct SolveSummary {
    solution::PathEnd end;
    long long unknowns = 0;
    int steps = 0;                 ///< rows of the path after the undeformed state
    int ranks = 1;
    double wall_s = 0, cpu_s = 0;  ///< of this process
    double peak_memory_MB = 0;
};

/// Seconds and megabytes so far, from the operating system.
void measure_process(SolveSummary& summary);

/// "done: elongation of 130 mm reached; 9 steps, 25 iterations, 36 factorizations; 6858 unknowns, 0.9 s"
[[nodiscard]] std::string summary_line(const SolveSummary& summary);
[[nodiscard]] nlohmann::ordered_json summary_json(const SolveSummary& summary, const model::Case& model);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"
[[nodiscard]] std::string step_text(const solution::Step& step, const model::Case& model);

/// How much of the way to the nearest goal is done, from 0 to 1; `first` is the undeformed state.
[[nodiscard]] double share_done(const solution::Step& first, const solution::Step& step, const model::Case& model);

}  // namespace soft::cli
