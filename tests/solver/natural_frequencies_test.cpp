/// Natural frequencies against closed forms: bars in a homogeneous state, the breathing of a sphere, and beams with equal pairs.
#include "solver/natural_frequencies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../fem/block_mesh.hpp"
#include "bench.hpp"
#include "core/error.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

using std::numbers::pi;

constexpr double density = 1080.0;

double signed_frequency_Hz(double eigenvalue) {
    return std::copysign(std::sqrt(std::abs(eigenvalue)), eigenvalue) / (2.0 * pi);
}

/// Bar along x, 1 m long and thin, of 4 x 4 quad4 cells in plane strain between two sliding planes, fixed at x = 0 and pulled by
/// `traction_Pa` at x = 1 m: uniaxial strain in a homogeneous state.
model::Case bar(double traction_Pa, int frequencies) {
    auto input =
        block_case(mesh::CellType::quad4, model::Kinematics::plane_strain, model::Formulation::displacement, {.n = 4});
    for (auto& point : input.mesh.points) point[1] *= 0.02;
    input.mesh.facet_sets.clear();
    name_boundary(input.mesh, [](const mesh::Point& p) {
        if (p[0] < 1e-9) return "fixed";
        return p[0] > 1 - 1e-9 ? "end" : "side";
    });
    input.supports = {{"fixed", {true, false, false}}, {"side", {false, true, false}}};
    input.materials[0].density_kg_m3 = density;
    input.materials[0].bulk_modulus_Pa = 2 * sample_mu_Pa;
    input.dead_loads = {{"end", model::DeadLoadKind::traction, {traction_Pa, 0, 0}}};
    input.outputs = {{"elongation", "end", {1, 0, 0}}};
    input.path.stages = {full_load(input, {})};
    input.path.frequencies = frequencies;
    input.solver.max_step = 0.5;
    input.solver.first_step = 0.005;
    return input;
}

/// Longitudinal mode j = 1, 2 ... of a bar of n linear elements of length h with consistent mass (standing wave of wave number
/// k = (2 j - 1) pi / 2 L): (2 pi f)^2 = 6 A / (rho h^2) (1 - cos kh) / (2 + cos kh). A: tangent modulus of uniaxial strain at the
/// stretch l, d/dl of P = 2 mu / 3 (l^(1/3) - l^(-5/3)) + kappa (l - 1) (derived here from W = mu/2 (I1 J^(-2/3) - 3) + kappa/2 (J - 1)^2).
double bar_frequency_Hz(double stretch, int mode) {
    constexpr double h = 0.25, kappa = 2 * sample_mu_Pa;
    const double modulus =
        2.0 / 9.0 * sample_mu_Pa * (std::pow(stretch, -2.0 / 3.0) + 5.0 * std::pow(stretch, -8.0 / 3.0)) + kappa;
    const double kh = 0.5 * (2 * mode - 1) * pi * h;
    return signed_frequency_Hz(6.0 * modulus / (density * h * h) * (1.0 - std::cos(kh)) / (2.0 + std::cos(kh)));
}

TEST(NaturalFrequencies, AreThoseOfAStretchedBar) {
    for (const double traction_Pa : {0.8 * sample_mu_Pa, -0.4 * sample_mu_Pa}) {
        const auto path = run(bar(traction_Pa, 2));
        ASSERT_EQ(path.end.reason, model::StopReason::done);
        ASSERT_GT(path.steps.size(), 3u);
        EXPECT_GT(std::abs(path.steps.back().outputs[0]), 0.1);
        for (const auto& step : path.steps) {
            ASSERT_EQ(step.frequencies_Hz.size(), 2u);
            for (int mode = 1; mode <= 2; ++mode) {
                const double exact = bar_frequency_Hz(1.0 + step.outputs[0], mode);
                EXPECT_NEAR(step.frequencies_Hz[static_cast<std::size_t>(mode) - 1], exact, 1e-8 * exact);
            }
        }
    }
}

/// Linearised equation of motion of the incompressible sphere (tests/solver/breathing_sphere.hpp) at constant pressure:
///   (2 pi f)^2 = p'(l) / (rho A a (1 - a / b)),     a = l A, b^3 = B^3 + a^3 - A^3, p the static pressure at the inner stretch l.
double breathing_frequency_Hz(double la) {
    constexpr double A = 0.01, B = 0.02;
    const double lb = std::cbrt(1.0 + (la * la * la - 1.0) / 8.0), a = la * A, b = lb * B;
    const auto slope = [](double l) {
        return -2.0 / (l * l) - 2.0 / (l * l * l * l * l);
    };  // of the terms of sphere_pressure
    const double by_stretch = sample_mu_Pa * (slope(lb) * la * la / (8.0 * lb * lb) - slope(la));
    return signed_frequency_Hz(by_stretch / (density * A * a * (1.0 - a / b)));
}

/// The sphere is filled to twice its stretch, past its pressure maximum.
model::Case filled_sphere(int frequencies) {
    auto input = sphere_case(4, 6);
    input.materials[0].density_kg_m3 = density;
    input.path.stages[0].supplies = {{model::Prescription::volume_ratio, 12.0}};
    input.path.frequencies = frequencies;
    return input;
}

double nearest(const std::vector<double>& frequencies, double value) {
    return *std::ranges::min_element(frequencies, {}, [&](double f) { return std::abs(f - value); });
}

TEST(NaturalFrequencies, OfASphereAreNegativeBeyondThePressureMaximum) {
    const auto path = run(filled_sphere(6));
    ASSERT_EQ(path.end.reason, model::StopReason::done);
    ASSERT_EQ(path.end.limit_points.size(), 1u);
    const double scale = breathing_frequency_Hz(1.0);
    int stable = 0, unstable = 0;
    for (const auto& step : path.steps) {
        const double exact = breathing_frequency_Hz(inner_stretch(step));
        const auto& found = step.frequencies_Hz;
        EXPECT_TRUE(std::ranges::is_sorted(found));
        // Near the maximum f is the root of a small difference: its square has the accuracy of the mesh.
        const double breathing = nearest(found, exact);
        EXPECT_NEAR(breathing * std::abs(breathing), exact * std::abs(exact), 1e-3 * scale * scale)
            << inner_stretch(step);
        ++(exact > 0.0 ? stable : unstable);
        if (exact < -0.1 * scale) {
            EXPECT_LT(found[0], 0.0);
            EXPECT_GT(found[1], 0.0);
        }
    }
    EXPECT_GT(stable, 5);
    EXPECT_GT(unstable, 3);
    const auto& top = path.steps[static_cast<std::size_t>(path.end.limit_points[0].step)];
    EXPECT_LT(std::abs(top.frequencies_Hz[0]), 0.03 * scale);
    EXPECT_NEAR(nearest(path.steps.front().frequencies_Hz, scale), scale, 1e-4 * scale);
}

TEST(NaturalFrequencies, FewerAreTheFirstOfMore) {
    const auto few = run(filled_sphere(1)), many = run(filled_sphere(6));
    ASSERT_EQ(few.steps.size(), many.steps.size());
    for (std::size_t i = 0; i < few.steps.size(); ++i)
        EXPECT_NEAR(few.steps[i].frequencies_Hz[0], many.steps[i].frequencies_Hz[0],
                    1e-6 * std::abs(many.steps[i].frequencies_Hz[1]));
}

/// A beam of square section bends in two directions alike.
TEST(NaturalFrequencies, OfASquareBeamComeInPairs) {
    auto input = box_case(2, true);
    for (auto& point : input.mesh.points) point[0] *= 6.0;
    input.supports = {{"fixed", {true, true, true}}};
    input.materials[0].density_kg_m3 = density;
    fem::System system(input, PETSC_COMM_WORLD);
    const linalg::Vector rest = system.make_vector();
    std::vector<double> frequencies[4];
    for (int count = 1; count <= 4; ++count)
        frequencies[count - 1] = NaturalFrequencies(system, count).evaluate(rest, fem::no_loads(input));
    const auto& four = frequencies[3];
    EXPECT_NEAR(four[1] / four[0], 1.0, 1e-9);
    EXPECT_GT(four[2], 2.0 * four[1]);
    for (const auto& fewer : frequencies)
        for (std::size_t i = 0; i < fewer.size(); ++i) EXPECT_NEAR(fewer[i] / four[i], 1.0, 1e-9);
}

TEST(NaturalFrequencies, AreRefusedWhereTheyDoNotExist) {
    const auto refusal = [](const model::Case& input) -> std::string {
        try {
            (void)run(input);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            return error.what();
        }
        return "accepted";
    };
    auto input = bar(1e3, 3);
    input.solver.linear.method = model::LinearMethod::krylov;
    EXPECT_NE(refusal(input).find("path.frequencies: natural frequencies need a factorisation"), std::string::npos);
    input = bar(1e3, 3);
    input.materials[0].density_kg_m3.reset();
    EXPECT_NE(refusal(input).find("need the density"), std::string::npos);
    input = bar(1e3, 36);  // 4 x 5 free components along x, 3 x 5 across
    EXPECT_NE(refusal(input).find("36 exceeds the number of displacement unknowns (35)"), std::string::npos);
}

}  // namespace
}  // namespace soft::solver
