#include "work.hpp"

#include <cmath>

namespace soft::verification {

std::vector<double> work_J(const Run& run) {
    std::vector<double> work{0.0};
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const auto &a = run.steps[i - 1], &b = run.steps[i];
        const double h = *b.volume_m3 - *a.volume_m3;
        const double slope_a = a.tangent_pressure / a.tangent_volume, slope_b = b.tangent_pressure / b.tangent_volume;
        work.push_back(work.back() + 0.5 * h * (a.pressure_Pa + b.pressure_Pa) + h * h / 12.0 * (slope_a - slope_b));
    }
    return work;
}

Row work_row(const Run& run) {
    constexpr double noticeable = 0.01;
    const auto work = work_J(run);
    std::size_t worst = run.steps.size() - 1;
    const auto error = [&](std::size_t i) { return std::abs(run.energy_J[i] / work[i] - 1); };
    for (std::size_t i = 1; i < run.steps.size(); ++i)
        if (work[i] > noticeable * work.back() && error(i) > error(worst)) worst = i;
    return {.quantity = "stored energy at the largest difference from the work [mJ]",
            .reference = 1e3 * work[worst],
            .source = "integral of p dV",
            .ours = 1e3 * run.energy_J[worst],
            .mesh = run.mesh,
            .seconds = run.seconds};
}

}  // namespace soft::verification
