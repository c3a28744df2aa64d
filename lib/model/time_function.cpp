#include "model/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soft::model {

namespace {

double ramp_time(const TimeFunction& time_function, double duration_s) {
    return time_function.time_s > 0.0 ? time_function.time_s : duration_s;
}

/// Index of the table's first time later than t.
std::size_t next_entry(const TimeFunction& time_function, double time_s) {
    return static_cast<std::size_t>(std::ranges::upper_bound(time_function.times_s, time_s) -
                                    time_function.times_s.begin());
}

double table_slope(const TimeFunction& time_function, std::size_t next) {
    return (time_function.shares[next] - time_function.shares[next - 1]) /
           (time_function.times_s[next] - time_function.times_s[next - 1]);
}

double omega(const TimeFunction& time_function) { return 2.0 * std::numbers::pi * time_function.frequency_Hz; }

}  // namespace

double share_at(const TimeFunction& time_function, double duration_s, double time_s) {
    switch (time_function.kind) {
        case TimeFunctionKind::ramp: return std::clamp(time_s / ramp_time(time_function, duration_s), 0.0, 1.0);
        case TimeFunctionKind::step: return time_s >= 0.0 ? 1.0 : 0.0;
        case TimeFunctionKind::sine: return std::sin(omega(time_function) * time_s);
        case TimeFunctionKind::table: break;
    }
    const std::size_t next = next_entry(time_function, time_s);
    if (next == 0) return time_function.shares.front();
    if (next == time_function.times_s.size()) return time_function.shares.back();
    return time_function.shares[next - 1] +
           (time_s - time_function.times_s[next - 1]) * table_slope(time_function, next);
}

double share_rate(const TimeFunction& time_function, double duration_s, double time_s) {
    switch (time_function.kind) {
        case TimeFunctionKind::ramp:
            return time_s >= 0.0 && time_s < ramp_time(time_function, duration_s)
                       ? 1.0 / ramp_time(time_function, duration_s)
                       : 0.0;
        case TimeFunctionKind::step: return 0.0;
        case TimeFunctionKind::sine: return omega(time_function) * std::cos(omega(time_function) * time_s);
        case TimeFunctionKind::table: break;
    }
    const std::size_t next = next_entry(time_function, time_s);
    return next == 0 || next == time_function.times_s.size() ? 0.0 : table_slope(time_function, next);
}

std::vector<double> kinks(const TimeFunction& time_function, double duration_s) {
    std::vector<double> times;
    if (time_function.kind == TimeFunctionKind::ramp) times = {ramp_time(time_function, duration_s)};
    if (time_function.kind == TimeFunctionKind::table) times = time_function.times_s;
    std::erase_if(times, [&](double time) { return time <= 0.0 || time >= duration_s; });
    return times;
}

std::vector<double> kink_times(const Case& input) {
    std::vector<double> times;
    const auto add = [&](const auto& loads) {
        for (const auto& load : loads)
            for (const double time : kinks(load.time_function, input.dynamics->duration_s)) times.push_back(time);
    };
    add(input.loads);
    add(input.dead_loads);
    add(input.motions);
    std::ranges::sort(times);
    const auto repeated = std::ranges::unique(times);
    times.erase(repeated.begin(), repeated.end());
    return times;
}

double shortest_change_s(const TimeFunction& time_function, double duration_s) {
    double shortest = duration_s;
    if (time_function.kind == TimeFunctionKind::ramp)
        shortest = std::min(shortest, ramp_time(time_function, duration_s));
    if (time_function.kind == TimeFunctionKind::sine && time_function.frequency_Hz > 0.0)
        shortest = std::min(shortest, 0.25 / time_function.frequency_Hz);
    for (std::size_t i = 1; time_function.kind == TimeFunctionKind::table && i < time_function.times_s.size(); ++i)
        shortest = std::min(shortest, time_function.times_s[i] - time_function.times_s[i - 1]);
    return shortest;
}

}  // namespace soft::model
