#pragma once
/// What solve tells about a run: the end of the path, its cost. The numbers of --json.
#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli.hpp"
#include "fields/energy_balance.hpp"
#include "linalg/profile.hpp"
#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::cli {

/// What `--tolerance` has come to.
struct AccuracySummary {
    double asked = 0, reached = 0;  ///< largest error bar of the load, relative
    int level = 0;                  ///< how often the cells of the reported curve's mesh were halved
    long long unknowns = 0;         ///< of the finest mesh
    bool has_bars = false;
    std::string obstacle;             ///< why no finer mesh was tried
    std::vector<std::string> doubts;  ///< why the bars are less reliable
    int caught_signal = 0;            ///< that has ended the refinement
    [[nodiscard]] bool met() const { return has_bars && reached <= asked; }
};

struct SolveSummary {
    solution::PathEnd end;
    std::optional<solution::Step> first, last;  ///< rows of the path
    std::optional<int> first_unstable_row;
    bool gave_way = false;                              ///< a row is unstable under the control in use
    std::vector<std::pair<int, std::string>> controls;  ///< of a static path, each with the first row that it finds
    double max_stretch_p99 = 1;                     ///< of all rows
    solution::Step most_stretched;                      ///< the row with the largest max_stretch
    std::optional<int> first_crushed_row;
    double min_jacobian = 1;
    std::optional<AccuracySummary> accuracy;
    long long unknowns = 0;
    int steps = 0;  ///< rows of the path after the undeformed state
    fields::EnergyBalance energy;
    int ranks = 1;
    double wall_s = 0, cpu_s = 0;  ///< cpu_s: of this process; in a batch since its line before
    double peak_memory_MB = 0;     ///< of this process
    double start_s = 0;            ///< before the path: the case read, tables made
    std::vector<linalg::ProfileRow> profile;
};

/// CPU seconds of this process so far, from the operating system.
struct ProcessTimes {
    double user_s = 0, system_s = 0;
};
[[nodiscard]] ProcessTimes process_times();
[[nodiscard]] double peak_memory_MB();  ///< of this process so far

/// Peak memory of a solve with the default linear solver on one rank [MB], from its number of unknowns n: 50 and 1.15e-4 n log2 n in
/// sections, in solids from 5e-4 n log2 n (thin walls) to 6e-4 n^(4/3) (compact blocks), 6.5e-3 n beyond 500,000 unknowns, where
/// multigrid takes over. The growth is that of nested dissection (George, SIAM J. Numer. Anal. 10 (1973) 345), the constants are
/// measured on bellows, tubes, a finger and blocks from 2,000 to 1,090,000 unknowns. Rows that are kept come on top.
struct MemoryRange {
    double low_MB = 0, high_MB = 0;
};
[[nodiscard]] MemoryRange expected_memory(long long unknowns, int dimension);
/// "6858 unknowns, about 60 MB of memory"
[[nodiscard]] std::string start_line(long long unknowns, int dimension);

/// "done: elongation of 130 mm reached; 9 steps, 25 iterations, 36 factorizations; 0.9 s"
/// Of a motion besides "generalized-alpha over 2 s, energy balance within 0.01 %".
[[nodiscard]] std::string summary_line(const SolveSummary& summary, const model::Case& model);
[[nodiscard]] nlohmann::ordered_json summary_json(const SolveSummary& summary, const model::Case& model);

/// A table: what, calls, seconds, part of the whole; then the memory. Empty without --profile.
[[nodiscard]] std::vector<std::string> profile_lines(const SolveSummary& summary);

/// What to warn of: "the tolerance of 0.1 % is missed: the error bars reach 0.3 %; the next mesh would have ...", and why the bars are
/// less reliable.
[[nodiscard]] std::vector<std::string> accuracy_lines(const AccuracySummary& accuracy);

/// One line a limit point of the load, of the first few: "limit point at 44.339 kPa, elongation 13.44 mm, volume 45.7 mL". Not of
/// one at which the path ends, which the end names.
[[nodiscard]] std::vector<std::string> limit_lines(const SolveSummary& summary, const model::Case& model);

/// One line a bifurcation: "bifurcation at 26.1 kPa, elongation 127 mm, volume 80 mL: another branch leaves the path ..."
[[nodiscard]] std::vector<std::string> bifurcation_lines(const solution::PathEnd& end, const model::Case& model);
/// Of a path that comes to its goal in a state in which no body stays; else empty.
/// Which controls `path.control: auto` has chosen, and from which row on; empty where it stayed with one or the user has chosen.
[[nodiscard]] std::string control_line(const SolveSummary& summary, const model::Case& model);
[[nodiscard]] std::string stability_line(const SolveSummary& summary);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"; of a case with several stages "vent: 12.3 kPa, ...", of a motion
/// "50 ms, 12.3 kPa, ...".
[[nodiscard]] std::string step_text(const solution::Step& step, const model::Case& model);

/// How much of the way is done, from 0 to 1: all stages alike, within a stage of the way to its nearest goal. The load may
/// fall past a limit point; progress does not.
class Progress {
public:
    explicit Progress(const model::Case& model) : model_(model) {}
    /// After this row; rows in the order of the path, the undeformed state first.
    double advance(const solution::Step& step);

private:
    const model::Case& model_;
    std::optional<double> undeformed_m3_;
    solution::Step start_, last_;  ///< where the stage began, and the row before
    double share_ = 0;
    bool begun_ = false;
};

/// A rough time to the end, as if the rest went as fast as what is done.
class RemainingTime {
public:
    /// `share` was done before the clock started.
    void begin_at(double share) { begin_ = share; }
    /// ", about 3 min left"; empty in the first seconds and where there is no saying.
    [[nodiscard]] std::string text(double share) const;

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double begin_ = 0;
};

}  // namespace soft::cli
