#include "solve_summary.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.hpp"

namespace soft::cli {

namespace {

double seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

std::string millimetres(double value_m) { return core::rounded_text(1e3 * value_m, 6) + " mm"; }

}  // namespace

void measure_process(SolveSummary& summary) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    summary.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    summary.peak_memory_MB = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string summary_line(const SolveSummary& summary) {
    return std::string{solution::name(summary.end.reason)} + ": " + summary.end.detail + "; " +
           std::to_string(summary.steps) + " steps, " + std::to_string(summary.end.newton_iterations) + " iterations, " +
           std::to_string(summary.end.factorizations) + " factorizations; " + std::to_string(summary.unknowns) +
           " unknowns, " + core::rounded_text(summary.wall_s, 3) + " s";
}

nlohmann::ordered_json summary_json(const SolveSummary& summary, const model::Case& model) {
    nlohmann::ordered_json json = {{"tool", "solve"}, {"version", version()}, {"revision", revision()},
                                   {"case", model.name}, {"stop_reason", solution::name(summary.end.reason)},
                                   {"detail", summary.end.detail}, {"steps", summary.steps},
                                   {"newton_iterations", summary.end.newton_iterations},
                                   {"factorizations", summary.end.factorizations}, {"unknowns", summary.unknowns},
                                   {"ranks", summary.ranks}, {"wall_s", summary.wall_s}, {"cpu_s", summary.cpu_s},
                                   {"peak_memory_MB", summary.peak_memory_MB},
                                   {"limit_points", nlohmann::ordered_json::array()}};
    for (const auto& limit : summary.end.limit_points) {
        nlohmann::ordered_json point = {{"step", limit.step}, {"pressure_Pa", limit.pressure_Pa}};
        if (limit.volume_m3) point["volume_m3"] = *limit.volume_m3;
        for (std::size_t i = 0; i < limit.outputs_m.size(); ++i)
            point[model.outputs[i].name + "_m"] = limit.outputs_m[i];
        json["limit_points"].push_back(std::move(point));
    }
    return json;
}

std::string step_text(const solution::Step& step, const model::Case& model) {
    std::string text = core::rounded_text(1e-3 * step.pressure_Pa, 5) + " kPa";
    for (std::size_t i = 0; i < step.outputs_m.size(); ++i)
        text += ", " + model.outputs[i].name + " " + millimetres(step.outputs_m[i]);
    if (step.volume_m3) text += ", volume " + core::rounded_text(1e6 * *step.volume_m3, 6) + " mL";
    return text;
}

double share_done(const solution::Step& first, const solution::Step& step, const model::Case& model) {
    double share = step.load_factor;
    for (const auto& until : model.path.until) {
        if (until.quantity == "volume_ratio" && step.volume_m3 && until.value != 1.0)
            share = std::max(share, (*step.volume_m3 / *first.volume_m3 - 1.0) / (until.value - 1.0));
        for (std::size_t i = 0; i < step.outputs_m.size(); ++i)
            if (model.outputs[i].name == until.quantity && until.value != 0.0)
                share = std::max(share, step.outputs_m[i] / until.value);
    }
    return std::clamp(share, 0.0, 1.0);
}

}  // namespace soft::cli
