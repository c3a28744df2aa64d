#pragma once
/// Time functions of loads for tests.
#include "model/case.hpp"

namespace soft::model {

inline TimeFunction step_time_function() {
    TimeFunction time_function;
    time_function.kind = TimeFunctionKind::step;
    return time_function;
}
/// time 0: as long as the motion
inline TimeFunction ramp_time_function(double time_s = 0.0) {
    TimeFunction time_function;
    time_function.time_s = time_s;
    return time_function;
}
inline TimeFunction sine_time_function(double frequency_Hz) {
    TimeFunction time_function;
    time_function.kind = TimeFunctionKind::sine;
    time_function.frequency_Hz = frequency_Hz;
    return time_function;
}

}  // namespace soft::model
