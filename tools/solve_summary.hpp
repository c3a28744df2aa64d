#pragma once
/// Summary that solve prints of a run: end of the path and cost. Also the content of --json.
#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli.hpp"
#include "linalg/profile.hpp"
#include "model/case.hpp"
#include "model/path.hpp"
#include "post/energy_balance.hpp"

namespace soft::cli {

/// Outcome of `--tolerance`.
struct AccuracySummary {
    double tolerance = 0, reached = 0;  ///< requested and reached: largest error bar of the load, relative
    int level = 0;                      ///< number of refinements of the mesh of the reported curve
    long long unknowns = 0;             ///< of the finest mesh
    bool has_bars = false;
    std::string end_reason;           ///< why the refinement ended
    std::vector<std::string> doubts;  ///< reasons why the error bars are less reliable
    int caught_signal = 0;            ///< signal that ended the refinement; 0: none
    [[nodiscard]] bool met() const { return has_bars && reached <= tolerance; }
};

struct SolveSummary {
    model::PathEnd end;
    std::string linear_solver, integrator;   ///< as in the design; integrator: of a dynamic case
    std::optional<model::Step> first, last;  ///< rows of the path
    std::optional<int> first_unstable_row;
    bool became_unstable = false;                       ///< some row is unstable under the active control
    std::vector<std::pair<int, std::string>> controls;  ///< static path: active controls, each with its first row
    double max_stretch_p99 = 1;                         ///< maximum over all rows
    model::Step max_stretch_step;                       ///< the row with the largest max_stretch
    std::optional<int> first_crushed_row;
    double min_jacobian = 1;
    double largest_work_J = 0;  ///< of the loads, absolute
    std::optional<AccuracySummary> accuracy;
    long long unknowns = 0;
    int steps = 0;  ///< rows of the path after the undeformed state
    post::EnergyBalance energy;
    int ranks = 1;
    double wall_s = 0, cpu_s = 0;  ///< cpu_s: of this process; in a batch since the previous line
    double peak_memory_MB = 0;     ///< of this process
    double start_s = 0;            ///< time before the path: reading the case and setup
    std::vector<linalg::ProfileRow> profile;
};

/// CPU seconds of this process so far, from the operating system.
struct ProcessTimes {
    double user_s = 0, system_s = 0;
};
[[nodiscard]] ProcessTimes process_times();
[[nodiscard]] double peak_memory_MB();  ///< of this process so far

/// Peak memory of a solve with the default linear solver on one rank [MB], from its number of unknowns n: 50 and 1.15e-4 n log2 n in
/// sections, in solids from 5e-4 n log2 n (thin walls) to 6e-4 n^(4/3) (compact blocks); beyond 500,000 unknowns 6.5e-3 n, by
/// multigrid or in a sheet, to 1.4e-2 n, the largest factorisation chosen in place of multigrid (fem/element_levels.hpp). The growth is that of nested dissection (George, SIAM J. Numer. Anal. 10 (1973) 345), the constants are
/// measured on bellows, tubes, a finger and blocks from 2,000 to 1,090,000 unknowns. Stored rows need additional memory.
struct MemoryRange {
    double low_MB = 0, high_MB = 0;
};
[[nodiscard]] MemoryRange expected_memory(long long unknowns, int dimension);
/// "6858 unknowns, about 60 MB of memory"
[[nodiscard]] std::string start_line(long long unknowns, int dimension);

/// "done: elongation of 130 mm reached; 9 steps, 25 iterations, 36 factorizations; 0.9 s"
/// For dynamics also "generalized-alpha over 2 s, energy balance within 0.01 %".
[[nodiscard]] std::string summary_line(const SolveSummary& summary, const model::Case& model);
[[nodiscard]] nlohmann::ordered_json summary_json(const SolveSummary& summary, const model::Case& model);

/// Table with phase, calls, seconds and share of the total, then the memory. Empty without --profile.
[[nodiscard]] std::vector<std::string> profile_lines(const SolveSummary& summary);

/// Warnings: "the tolerance of 0.1 % is not met: the error bars of the load reach 0.3 %; the next mesh would have ...", and reasons why
/// the error bars are less reliable.
[[nodiscard]] std::vector<std::string> accuracy_lines(const AccuracySummary& accuracy);

/// The controls selected by `path.control: auto` with their first rows; empty for a single control or a user-selected one.
[[nodiscard]] std::string control_line(const SolveSummary& summary, const model::Case& model);
/// Line for a path that reaches its goal in an unstable state; otherwise empty.
[[nodiscard]] std::string stability_line(const SolveSummary& summary);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"; with several stages "vent: 12.3 kPa, ...", for dynamics
/// "50 ms, 12.3 kPa, ...".
[[nodiscard]] std::string step_text(const model::Step& step, const model::Case& model);

/// Progress from 0 to 1: all stages have equal weight; within a stage, the fraction of the way to its nearest goal. Never decreases,
/// also if the load decreases past a limit point.
class Progress {
public:
    explicit Progress(const model::Case& model) : model_(model) {}
    /// Progress after this row. Pass rows in the order of the path, the undeformed state first.
    double advance(const model::Step& step);

private:
    const model::Case& model_;
    std::optional<double> undeformed_m3_;
    model::Step start_, last_;  ///< first row of the stage, and the previous row
    double share_ = 0;
    bool begun_ = false;
};

/// Estimate of the remaining time at the average speed so far.
class RemainingTime {
public:
    /// `share`: progress made before the clock started (resumed run).
    void begin_at(double share) { begin_ = share; }
    /// ", about 3 min left"; empty in the first seconds and without sufficient progress.
    [[nodiscard]] std::string text(double share) const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double begin_ = 0;
};

}  // namespace soft::cli
