#pragma once
/// The share f(t) of a load in a dynamic case (TimeFunction), f = 0 before time 0.
/// Tested by model/time_function_test.
#include <vector>

#include "model/case.hpp"

namespace soft::model {

/// The value at time t; at a jump, the value after it. A ramp without its own time takes `duration_s`.
[[nodiscard]] double share_at(const TimeFunction& time_function, double duration_s, double time_s);

/// df/dt; at a kink the slope after it, 0 for a jump.
[[nodiscard]] double share_rate(const TimeFunction& time_function, double duration_s, double time_s);

/// Times within (0, duration) at which the slope jumps, ascending: a step that spans one loses its order.
[[nodiscard]] std::vector<double> kinks(const TimeFunction& time_function, double duration_s);

/// Those of all loads of a dynamic case, each once.
[[nodiscard]] std::vector<double> kink_times(const Case& input);

/// The shortest time in which the time function changes substantially (a ramp, a quarter of a sine's period, the shortest interval of
/// a table); the duration for a step.
[[nodiscard]] double shortest_change_s(const TimeFunction& time_function, double duration_s);

}  // namespace soft::model
