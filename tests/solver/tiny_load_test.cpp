/// Loads so small that strains are lost in the rounding of positions: the response is linear and takes few steps.
#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"

namespace soft::solver {
namespace {

model::Case with_pressure(model::Case input, double pressure_Pa) {
    input.path.stages[0].supplies = {{model::Prescription::pressure, pressure_Pa}};
    return input;
}

/// The last row of a path that is done within a few steps and conserves energy.
model::Step end_of(const model::Case& input, const std::string& what) {
    const auto path = run(input);
    EXPECT_EQ(path.end.reason, model::StopReason::done) << what << path.end.detail;
    EXPECT_LE(path.steps.size(), 5u) << what;
    const auto& last = path.steps.back();
    EXPECT_NEAR(last.energies->load_work_J / last.energies->stored_J, 1, 1e-3) << what;
    return last;
}

/// Young's modulus E = 9 kappa mu / (3 kappa + mu), 3 mu where the rubber is incompressible.
TEST(TinyLoads, StretchABlockByHookesLaw) {
    for (const double kappa : {0.0, 100 * sample_mu_Pa})
        for (const double pressure : {-1e-6, 1e-4, -1e-2, 0.1, -1.0}) {
            const auto input = with_pressure(box_case(2, kappa == 0.0), pressure);
            const double E = kappa > 0 ? 9 * kappa * sample_mu_Pa / (3 * kappa + sample_mu_Pa) : 3 * sample_mu_Pa;
            const std::string what = std::to_string(pressure) + " Pa: ";
            const auto last = end_of(input, what);
            EXPECT_NEAR(last.outputs[0] / (-pressure / E * 0.01), 1, 1e-4) << what;
            EXPECT_NEAR(last.energies->stored_J / (0.5 * pressure * pressure / E * 1e-6), 1, 1e-3) << what;
            EXPECT_TRUE(last.stable) << what;
        }
}

/// Radial displacement of the inner wall of a thick incompressible sphere: p A B^3 / (4 mu (B^3 - A^3)); dV = 4 pi A^2 u.
TEST(TinyLoads, InflateASphereByLamesSolution) {
    constexpr double A = 0.01, B = 0.02;
    const double u_by_p = A * B * B * B / (4 * sample_mu_Pa * (B * B * B - A * A * A)), pi = std::acos(-1.0);
    for (const auto control : {model::Control::automatic, model::Control::volume, model::Control::arc_length})
        for (const double pressure : {1e-6, -1e-3, 0.1, 1.0}) {
            auto input = with_pressure(sphere_case(2, 8), pressure);
            input.path.stages[0].control = control;
            const std::string what = std::to_string(pressure) + " Pa: ";
            const auto last = end_of(input, what);
            const double dV = 4 * pi * A * A * u_by_p * pressure;  // half of p dV is stored
            EXPECT_NEAR(last.energies->stored_J / (0.5 * pressure * dV), 1, 3e-3) << what;
        }
}

}  // namespace
}  // namespace soft::solver
