// The paper's rod: homogeneous uniaxial states with the closed form, on one coarse mesh of hexahedra or tetrahedra.
#include <gtest/gtest.h>

#include <cmath>

#include "run_design.hpp"

namespace soft::verification {
namespace {

/// Cauchy stress of W = mu/2 (I1bar - 3) + kappa/2 (J - 1)^2 at an axial stretch l: the lateral stretch follows from zero
/// lateral stress, mu/3 J^-5/3 (a^2 - l^2) + kappa (J - 1) = 0 with J = l a^2, solved by bisection.
double split_law_stress_Pa(double l, double mu_Pa, double kappa_Pa) {
    double low = 0.5 / std::sqrt(l), high = 2.0 / std::sqrt(l);
    const auto lateral = [&](double a) {
        const double J = l * a * a;
        return mu_Pa / 3.0 * std::pow(J, -5.0 / 3.0) * (a * a - l * l) + kappa_Pa * (J - 1.0);
    };
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (lateral(middle) < 0 ? low : high) = middle;
    }
    const double a = 0.5 * (low + high), J = l * a * a;
    return 2.0 * mu_Pa / 3.0 * std::pow(J, -5.0 / 3.0) * (l * l - a * a) + kappa_Pa * (J - 1.0);
}

TEST(Rod, ClosedFormHasTheStrainsOfTheSpecification) {   // mu 0.2069 MPa, kappa 20.69 MPa, 0.25 t MPa
    EXPECT_NEAR(split_law_stress_Pa(2.57712, 0.2069e6, 20.69e6), 1.25e6, 10.0);
    EXPECT_NEAR(split_law_stress_Pa(6.63390, 0.2069e6, 20.69e6), 7.5e6, 60.0);
}

class RodCells : public ::testing::TestWithParam<const char*> {};

TEST_P(RodCells, NearlyIncompressibleFollowsTheSplitLaw) {
    const auto run = run_design("rod.yaml", {"material.mu=0.2069 MPa", "material.kappa=20.69 MPa",
                                             "loads.end.pressure=-7.5 MPa", std::string("mesh.cells=") + GetParam()});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const double l = 1.0 + 10.0 * run.steps[i].outputs_m.at(0);   // 100 mm long
        EXPECT_NEAR(-run.steps[i].pressure_Pa / split_law_stress_Pa(l, 0.2069e6, 20.69e6), 1.0, 1e-6);
    }
    EXPECT_NEAR(run.output_mm(), 563.390, 0.01);   // the specification's strain at t = 30, %
}

TEST_P(RodCells, IncompressibleFollowsTheNeoHookeanClosedForm) {
    const auto run = run_design("rod.yaml", {"material.mu=0.2069 MPa", "material.kappa=incompressible",
                                             "loads.end.pressure=-7.5 MPa", std::string("mesh.cells=") + GetParam()});
    for (const auto& step : run.steps) {
        const double l = 1.0 + 10.0 * step.outputs_m.at(0);
        EXPECT_NEAR(-step.pressure_Pa, 0.2069e6 * (l * l - 1.0 / l), 1e-6 * 7.5e6);
    }
    EXPECT_NEAR(run.output_mm(), 503.449, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Verification, RodCells, ::testing::Values("auto", "simplices"),
                         [](const auto& cells) { return std::string(cells.param); });

}  // namespace
}  // namespace soft::verification
