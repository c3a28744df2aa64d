#include "solve_summary.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "core/units.hpp"
#include "event_summary.hpp"

namespace soft::cli {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

model::LimitPoint point_of(const model::Step& step) { return {0, step.pressure_Pa, step.volume_m3, step.outputs}; }

std::string time_text(double time_s) { return core::quantity_text(time_s, core::Dimension::time); }

nlohmann::ordered_json motion_json(const SolveSummary& summary, const model::Dynamics& dynamics) {
    nlohmann::ordered_json json = {{"integrator", summary.integrator}, {"duration_s", dynamics.duration_s}};
    if (summary.last && summary.last->motion) {
        json["time_s"] = summary.last->motion->time_s;
        json["kinetic_energy_J"] = summary.last->motion->kinetic_energy_J;
        json["stored_energy_J"] = summary.last->motion->stored_energy_J;
        json["load_work_J"] = summary.last->motion->load_work_J;
        json["damping_work_J"] = summary.last->motion->damping_work_J;
    }
    return json;
}

std::string motion_text(const SolveSummary& summary, const model::Dynamics& dynamics) {
    std::string text = summary.integrator + " over " + time_text(dynamics.duration_s);
    if (const auto error = summary.energy.error())
        text += ", energy balance within " + core::rounded_text(100 * *error, 2) + " %";
    return text + "; ";
}

nlohmann::ordered_json end_json(const model::Step& last, const model::Case& model) {
    nlohmann::ordered_json json;
    if (model.path.stages.size() > 1) json["stage"] = model.path.stages[static_cast<std::size_t>(last.stage)].name;
    add_point(json, point_of(last), model);
    for (std::size_t i = 0; i < last.pressures_Pa.size(); ++i)
        json["pressures_Pa"][model.loads[i].name] = last.pressures_Pa[i];
    const auto cavities = model::measured_cavities(model);
    for (std::size_t i = 0; i < last.volumes_m3.size(); ++i) json["volumes_m3"][cavities[i]->name] = last.volumes_m3[i];
    return json;
}

}  // namespace

ProcessTimes process_times() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return {seconds(usage.ru_utime), seconds(usage.ru_stime)};
}

double peak_memory_MB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

MemoryRange expected_memory(long long unknowns, int dimension) {
    constexpr double process_MB = 50, multigrid_from = 5e5;
    const double n = static_cast<double>(std::max(unknowns, 2LL)), dissected = n * std::log2(n);
    if (dimension < 3) return {process_MB + 1.15e-4 * dissected, process_MB + 1.15e-4 * dissected};
    if (n > multigrid_from) return {process_MB + 6.5e-3 * n, process_MB + 1.4e-2 * n};
    return {process_MB + 5e-4 * dissected, process_MB + std::max(5e-4 * dissected, 6e-4 * std::pow(n, 4.0 / 3.0))};
}

std::string start_line(long long unknowns, int dimension) {
    const auto text = [](double MB) {
        return MB < 1000 ? core::rounded_text(std::round(MB / 10) * 10, 3) + " MB"
                         : core::rounded_text(MB / 1000, 2) + " GB";
    };
    const MemoryRange memory = expected_memory(unknowns, dimension);
    const std::string low = text(memory.low_MB), high = text(memory.high_MB);
    return core::counted(unknowns, "unknown") + ", about " + (low == high ? low : low + " to " + high) + " of memory";
}

std::string RemainingTime::text(double share) const {
    constexpr double min_s = 3, min_share = 0.01;  // earlier estimates would be unreliable
    const double spent_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (spent_s < min_s || share - begin_ < min_share || share >= 1) return {};
    const double left_s = spent_s * (1 - share) / (share - begin_);
    constexpr double minute = 60, hour = 3600;
    const auto whole = [](double value) { return core::rounded_text(std::max(1.0, std::round(value)), 4); };
    if (left_s < 1.5 * minute) return ", about " + whole(left_s) + " s left";
    if (left_s < 1.5 * hour) return ", about " + whole(left_s / minute) + " min left";
    return ", about " + whole(left_s / hour) + " h left";
}

std::string summary_line(const SolveSummary& summary, const model::Case& model) {
    return std::string{model::name(summary.end.reason)} + ": " + summary.end.detail + "; " +
           core::counted(summary.steps, model.dynamics ? "row" : "step") + ", " +
           core::counted(summary.end.newton_iterations, "iteration") + ", " +
           core::counted(summary.end.factorizations, "factorization") + "; " +
           (model.dynamics ? motion_text(summary, *model.dynamics) : std::string{}) +
           core::rounded_text(summary.wall_s, 3) + " s";
}

std::vector<std::string> profile_lines(const SolveSummary& summary) {
    if (summary.profile.empty()) return {};
    std::vector<linalg::ProfileRow> rows{{"reading the case, setup", 1, summary.start_s}};
    rows.insert(rows.end(), summary.profile.begin(), summary.profile.end());
    double rest_s = summary.wall_s;
    for (const auto& row : rows) rest_s -= row.seconds;
    rows.push_back({"other", 1, rest_s});
    std::vector<std::string> lines;
    std::array<char, 160> line{};
    const auto put = [&](const char* what, const std::string& calls, double seconds) {
        std::snprintf(line.data(), line.size(), "  %-66s %8s %9.3f s %5.1f %%", what, calls.c_str(), seconds,
                      100.0 * seconds / summary.wall_s);
        lines.emplace_back(line.data());
    };
    lines.emplace_back(summary.ranks > 1 ? "profile of rank 0 of " + std::to_string(summary.ranks) + ":" : "profile:");
    for (const auto& row : rows) put(row.what.c_str(), std::to_string(row.calls), row.seconds);
    put("total", "", summary.wall_s);
    lines.push_back("  peak memory: " + core::rounded_text(summary.peak_memory_MB, 4) + " MB");
    return lines;
}

nlohmann::ordered_json summary_json(const SolveSummary& summary, const model::Case& model) {
    nlohmann::ordered_json json = {{"tool", "solve"},
                                   {"version", version()},
                                   {"revision", revision()},
                                   {"case", model.name},
                                   {"stop_reason", model::name(summary.end.reason)},
                                   {"detail", summary.end.detail},
                                   {"steps", summary.steps},
                                   {"newton_iterations", summary.end.newton_iterations},
                                   {"factorizations", summary.end.factorizations},
                                   {"unknowns", summary.unknowns},
                                   {"linear_solver", summary.linear_solver},
                                   {"ranks", summary.ranks},
                                   {"wall_s", summary.wall_s},
                                   {"cpu_s", summary.cpu_s},
                                   {"peak_memory_MB", summary.peak_memory_MB}};
    add_events(json, summary.end, model, [&](const model::LimitPoint& at) {
        nlohmann::ordered_json point = {{"step", at.step}};
        add_point(point, at, model);
        return point;
    });
    for (const auto& [row, control] : summary.controls)
        json["controls"].push_back({{"from_row", row}, {"control", control}});
    if (const auto error = summary.energy.error()) json["energy_balance_error"] = *error;
    if (model.dynamics) json["dynamics"] = motion_json(summary, *model.dynamics);
    if (summary.accuracy) {
        const AccuracySummary& accuracy = *summary.accuracy;
        json["accuracy"] = {{"tolerance", accuracy.tolerance},
                            {"met", accuracy.met()},
                            {"level", accuracy.level},
                            {"finest_unknowns", accuracy.unknowns}};
        if (accuracy.has_bars) json["accuracy"]["reached"] = accuracy.reached;
        json["accuracy"]["doubts"] = accuracy.doubts;
    }
    for (const auto& row : summary.profile)
        json["profile"].push_back({{"what", row.what}, {"calls", row.calls}, {"seconds", row.seconds}});
    if (summary.last) json["end"] = end_json(*summary.last, model);
    return json;
}

std::vector<std::string> accuracy_lines(const AccuracySummary& accuracy) {
    const auto percent = [](double share) { return core::rounded_text(100 * share, 3) + " %"; };
    std::vector<std::string> lines;
    if (!accuracy.met())
        lines.push_back("the tolerance of " + percent(accuracy.tolerance) + " is not met: " +
                        (accuracy.has_bars ? "the error bars of the load reach " + percent(accuracy.reached)
                                           : "no error bars are available") +
                        "; " + accuracy.end_reason);
    for (const std::string& doubt : accuracy.doubts) lines.push_back("the error bars are less reliable: " + doubt);
    return lines;
}

std::string control_line(const SolveSummary& summary, const model::Case& model) {
    const bool chosen = std::ranges::none_of(
        model.path.stages, [](const model::Stage& stage) { return stage.control == model::Control::automatic; });
    if (chosen || summary.controls.size() < 2) return "";
    std::string line = "path.control auto: " + summary.controls.front().second;
    for (std::size_t i = 1; i < summary.controls.size(); ++i)
        line += ", from row " + std::to_string(summary.controls[i].first) + " on " + summary.controls[i].second;
    return line;
}

std::string stability_line(const SolveSummary& summary) {
    const bool at_the_end = summary.end.reason == model::StopReason::done && summary.last && !summary.last->stable;
    if (!at_the_end || !summary.first_unstable_row) return "";
    if (summary.last->stable_under_control.value_or(false))
        return "the final state is unstable under load control, as are the states from row " +
               std::to_string(*summary.first_unstable_row) + " on; it is stable if the " +
               (summary.controls.empty() ? "controlled quantity" : summary.controls.back().second) + " is controlled";
    return "the final state is unstable, as are the states from row " + std::to_string(*summary.first_unstable_row) +
           " on: a perturbed actuator leaves it; use path.branch: follow to compute the branch it moves to";
}

std::string step_text(const model::Step& step, const model::Case& model) {
    const auto& stages = model.path.stages;
    const std::string stage = stages.size() > 1 ? stages[static_cast<std::size_t>(step.stage)].name + ": " : "";
    const std::string time = step.motion ? time_text(step.motion->time_s) + ", " : "";
    return time + stage + location_text(point_of(step), model);
}

namespace {

/// Fraction of the way from `first`, the value at the start of the stage, to the goal.
double share_of(double value, double first, double goal) {
    return goal == first ? 0 : (value - first) / (goal - first);
}

}  // namespace

double Progress::advance(const model::Step& step) {
    if (!begun_) {
        undeformed_m3_ = step.volume_m3;
        start_ = step;
        begun_ = true;
    } else if (step.stage != last_.stage) {
        start_ = last_;
    }
    last_ = step;
    const auto& stages = model_.path.stages;
    double share = step.load_factor;
    for (const auto& until : stages[static_cast<std::size_t>(step.stage)].until) {
        const auto count = [&](double value, double first) {
            share = std::max(share, share_of(value, first, until.value));
        };
        if (until.quantity == "pressure") count(step.pressure_Pa, start_.pressure_Pa);
        if (until.quantity == "volume_ratio" && step.volume_m3 && start_.volume_m3)
            count(*step.volume_m3 / *undeformed_m3_, *start_.volume_m3 / *undeformed_m3_);
        for (std::size_t i = 0; i < step.outputs.size(); ++i)
            if (model_.outputs[i].name == until.quantity) count(step.outputs[i], start_.outputs[i]);
    }
    share_ = std::max(share_, (step.stage + std::clamp(share, 0.0, 1.0)) / static_cast<double>(stages.size()));
    return share_;
}

}  // namespace soft::cli
