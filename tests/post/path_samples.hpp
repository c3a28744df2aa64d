#pragma once
/// A path with a closed form: the incompressible neo-Hookean thick sphere, inner radius 1 m, outer radius 2 m, mu 1 Pa.
///   p/mu = [2/l + 1/(2 l^4)] at l_b minus at l_a,   l_b^3 = 1 + (l_a^3 - 1)/8,
/// (verification.md: 0.551869 at l_a = 1.25, 0.755433 at 1.5, 0.806927 at 2; limit point 0.816424 at l_a = 1.8281).
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"
#include "post/curve.hpp"

namespace soft::post::test {

inline double sphere_pressure_Pa(double stretch_a) {
    const auto g = [](double l) { return 2 / l + 1 / (2 * std::pow(l, 4)); };
    return g(std::cbrt(1 + (std::pow(stretch_a, 3) - 1) / 8)) - g(stretch_a);
}

/// Analytical derivative: g' = -2/l^2 - 2/l^5 and dl_b/dl_a = l_a^2 / (8 l_b^2).
inline double sphere_pressure_slope_Pa(double stretch_a) {
    const auto slope = [](double l) { return -2 / (l * l) - 2 / std::pow(l, 5); };
    const double stretch_b = std::cbrt(1 + (std::pow(stretch_a, 3) - 1) / 8);
    return slope(stretch_b) * stretch_a * stretch_a / (8 * stretch_b * stretch_b) - slope(stretch_a);
}

inline double ball_m3(double radius_m) { return 4 * std::numbers::pi / 3 * std::pow(radius_m, 3); }

/// A case with one cavity, loaded by default, and the given displacement outputs.
enum class Loaded { cavity, face, nothing };
inline model::Case sample_case(const std::vector<std::string>& outputs = {}, Loaded loaded = Loaded::cavity) {
    model::Case model;
    model.cavities = {{"cavity", "inner", {}, {}}};
    if (loaded == Loaded::cavity) model.loads.push_back({"cavity", {"cavity"}, true, {}});
    if (loaded == Loaded::face) model.loads.push_back({"outside", {"outer"}, true, {}});
    for (const std::string& name : outputs) model.outputs.push_back({name, "tip", {1, 0, 0}});
    model.path.stages.resize(1);
    return model;
}

/// The case of the closed form: output 0 is the growth of the inner radius.
inline const model::Case growth = sample_case({"growth"});

enum class Slopes { recorded, missing };

/// Rows evenly spaced in the inner stretch; output 0 is the growth of the inner radius [m].
inline std::vector<model::Step> sphere_path(int rows, double last_stretch, Slopes slopes = Slopes::recorded) {
    constexpr double limit_stretch = 1.8281;
    std::vector<model::Step> steps;
    for (int row = 0; row < rows; ++row) {
        const double stretch = 1 + (last_stretch - 1) * row / (rows - 1);
        model::Step step;
        step.pressure_Pa = sphere_pressure_Pa(stretch);
        step.volume_m3 = ball_m3(stretch);
        step.outputs = {stretch - 1};
        step.tangent_outputs = {0};
        if (slopes == Slopes::recorded) {
            const double speed = 1 + 0.7 * row;  // the scale of the slopes is arbitrary at each row
            step.tangent_pressure = speed * sphere_pressure_slope_Pa(stretch);
            step.tangent_volume = speed * 4 * std::numbers::pi * stretch * stretch;
            step.tangent_outputs = {speed};
        }
        step.stable = stretch < limit_stretch;
        step.stretch_p99 = stretch;
        step.max_stretch = stretch;
        steps.push_back(step);
    }
    return steps;
}

inline std::size_t index_of(const Curve& curve, std::string_view quantity) {
    return static_cast<std::size_t>(curve.find(quantity) - curve.columns.data());
}

}  // namespace soft::post::test
