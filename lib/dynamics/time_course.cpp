#include "dynamics/time_course.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soft::dynamics {

using model::Course;

namespace {

double ramp_time(const model::TimeCourse& course, double duration_s) {
    return course.time_s > 0.0 ? course.time_s : duration_s;
}

/// Index of the table's first time beyond t.
std::size_t next_entry(const model::TimeCourse& course, double time_s) {
    return static_cast<std::size_t>(std::ranges::upper_bound(course.times_s, time_s) - course.times_s.begin());
}

double table_slope(const model::TimeCourse& course, std::size_t next) {
    return (course.shares[next] - course.shares[next - 1]) / (course.times_s[next] - course.times_s[next - 1]);
}

double omega(const model::TimeCourse& course) { return 2.0 * std::numbers::pi * course.frequency_Hz; }

}  // namespace

double share_at(const model::TimeCourse& course, double duration_s, double time_s) {
    switch (course.kind) {
        case Course::ramp: return std::clamp(time_s / ramp_time(course, duration_s), 0.0, 1.0);
        case Course::step: return time_s >= 0.0 ? 1.0 : 0.0;
        case Course::sine: return std::sin(omega(course) * time_s);
        case Course::table: break;
    }
    const std::size_t next = next_entry(course, time_s);
    if (next == 0) return course.shares.front();
    if (next == course.times_s.size()) return course.shares.back();
    return course.shares[next - 1] + (time_s - course.times_s[next - 1]) * table_slope(course, next);
}

double share_rate(const model::TimeCourse& course, double duration_s, double time_s) {
    switch (course.kind) {
        case Course::ramp:
            return time_s >= 0.0 && time_s < ramp_time(course, duration_s) ? 1.0 / ramp_time(course, duration_s) : 0.0;
        case Course::step: return 0.0;
        case Course::sine: return omega(course) * std::cos(omega(course) * time_s);
        case Course::table: break;
    }
    const std::size_t next = next_entry(course, time_s);
    return next == 0 || next == course.times_s.size() ? 0.0 : table_slope(course, next);
}

std::vector<double> kinks(const model::TimeCourse& course, double duration_s) {
    std::vector<double> times;
    if (course.kind == Course::ramp) times = {ramp_time(course, duration_s)};
    if (course.kind == Course::table) times = course.times_s;
    std::erase_if(times, [&](double time) { return time <= 0.0 || time >= duration_s; });
    return times;
}

double shortest_change_s(const model::TimeCourse& course, double duration_s) {
    double shortest = duration_s;
    if (course.kind == Course::ramp) shortest = std::min(shortest, ramp_time(course, duration_s));
    if (course.kind == Course::sine && course.frequency_Hz > 0.0)
        shortest = std::min(shortest, 0.25 / course.frequency_Hz);
    for (std::size_t i = 1; course.kind == Course::table && i < course.times_s.size(); ++i)
        shortest = std::min(shortest, course.times_s[i] - course.times_s[i - 1]);
    return shortest;
}

}  // namespace soft::dynamics
