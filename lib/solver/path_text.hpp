#pragma once
/// Text for the states and locations of a path, for messages: kPa, mm and mL, six digits.
#include <string>

#include "solver/newton.hpp"
#include "solver/stepping.hpp"

namespace soft::solver {

[[nodiscard]] std::string short_text(double value);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"
[[nodiscard]] std::string state_text(const PathPoint& point, const model::Case& input);

/// "in cell 12 at x = 3.1 mm, r = 2 mm of the undeformed part"
[[nodiscard]] std::string location_text(mesh::Index cell, const model::Case& input);

/// "step of 0.1 failed (an element inverted, ...): cut to 0.04"
[[nodiscard]] std::string attempt_text(double step, double next, const NewtonResult& result);

/// ", predictor error 1e-3 (load 1e-4), 3 iterations, unstable modes 0"
[[nodiscard]] std::string row_text(const PathPoint& point, const PredictorError& error, int iterations);

}  // namespace soft::solver
