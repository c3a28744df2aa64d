#include "fit/history_stress.hpp"

#include <cmath>

#include "material/point_history.hpp"

namespace soft::fit {
namespace {

/// Largest change of the stretch in one step of the model.
constexpr double max_step = 0.02;

/// Nominal stress: the pressure removes the stress of the free third direction.
double nominal_Pa(const material::SymmetricTensor& S, const std::array<double, 3>& l) {
    return l[0] * S[0] - S[2] * l[2] * l[2] / l[0];
}

}  // namespace

std::array<double, 3> stretches_of(Mode mode, double l) {
    switch (mode) {
        case Mode::equibiaxial: return {l, l, 1 / (l * l)};
        case Mode::planar: return {l, 1, 1 / l};
        default: return {l, 1 / std::sqrt(l), 1 / std::sqrt(l)};
    }
}

std::vector<double> stress_of_test(const material::AnyRubber& rubber, const TestCurve& test) {
    const material::Inelastic& inelastic = *material::inelastic_of(rubber);
    std::vector<double> history(material::history_size(inelastic), 0.0), next = history, stress_Pa;
    double time_s = test.time_s.front(), l = 1;
    for (std::size_t row = 0; row < test.stretch.size(); ++row) {
        const double change = test.stretch[row] - l, dt = test.time_s[row] - time_s;
        const int steps = 1 + static_cast<int>(std::abs(change) / max_step);
        const auto coefficients = material::step_coefficients(inelastic, dt / steps);
        for (int k = 1; k <= steps; ++k) {
            const auto at = stretches_of(test.mode, l + change * k / steps);
            const auto step =
                material::advance(rubber, coefficients, {}, {at[0], 0, 0, 0, at[1], 0, 0, 0, at[2]}, history, next);
            std::swap(history, next);
            if (k == steps) stress_Pa.push_back(nominal_Pa(step.stress, at));
        }
        l = test.stretch[row];
        time_s = test.time_s[row];
    }
    return stress_Pa;
}

}  // namespace soft::fit
