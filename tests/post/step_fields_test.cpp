#include "post/step_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fields_samples.hpp"

namespace soft::post {
namespace {

using mesh::CellType;
using model::Formulation;
using model::Kinematics;
using namespace test;

constexpr double mu = 2e5;

struct Combination {
    CellType type;
    Formulation formulation;
};
constexpr std::array<Combination, 9> solids{{{CellType::hex27, Formulation::mixed},
                                             {CellType::tet10, Formulation::mixed},
                                             {CellType::wedge18, Formulation::mixed},
                                             {CellType::hex8, Formulation::f_bar},
                                             {CellType::hex8, Formulation::displacement},
                                             {CellType::tet4, Formulation::displacement},
                                             {CellType::wedge6, Formulation::displacement},
                                             {CellType::tet10, Formulation::displacement},
                                             {CellType::hex27, Formulation::displacement}}};

model::Case block(CellType type, Formulation formulation, Kinematics kinematics = Kinematics::solid, int n = 2) {
    model::Case made = block_case(type, kinematics, formulation, {.n = n, .shake = 0.2});
    made.materials = {neo_hookean(mu, formulation == Formulation::mixed ? std::nullopt : std::optional{50 * mu})};
    return made;
}

TEST(StepFields, OfUniaxialTensionAreTheExactStressesEverywhere) {
    // incompressible neo-Hookean: sigma = mu (l^2 - 1/l) along the pull, 0 across it; W = mu/2 (l^2 + 2/l - 3)
    const double l = 1.8, t = 1 / std::sqrt(l);
    const Tensor F{l, 0, 0, 0, t, 0, 0, 0, t};
    const double pull = mu * (l * l - 1 / l), p = -mu * (t * t - (l * l + 2 * t * t) / 3);
    for (const auto& [type, formulation] : solids) {
        SCOPED_TRACE(mesh::topology(type).name);
        const auto sampled = sample(block(type, formulation), linear(F), [p](const Point&) { return p; });
        for (const LocalState& state : all_states(sampled)) {
            expect_tensor(state.deformation_gradient, F, 1e-12);
            // without a pressure unknown the stress at J = 1 is purely deviatoric
            const double side = formulation == Formulation::mixed ? 0.0 : -pull / 3;
            expect_tensor(state.cauchy_Pa, {pull + side, 0, 0, 0, side, 0, 0, 0, side}, 1e-7 * pull);
            expect_tensor(state.first_piola_Pa, {(pull + side) / l, 0, 0, 0, side / t, 0, 0, 0, side / t}, 1e-7 * pull);
            EXPECT_NEAR(state.energy_J_m3, 0.5 * mu * (l * l + 2 / l - 3), 1e-9 * mu);
            EXPECT_NEAR(state.jacobian, 1.0, 1e-12);
        }
    }
}

TEST(StepFields, OfSimpleShearHaveTheExactNormalStressDifference) {
    // sigma_12 = mu g, sigma_11 - sigma_22 = mu g^2 (Rivlin), P = sigma F^-T
    const double g = 0.6;
    for (const auto& [type, formulation] : solids) {
        SCOPED_TRACE(mesh::topology(type).name);
        const auto sampled = sample(block(type, formulation), linear({1, g, 0, 0, 1, 0, 0, 0, 1}));
        for (const LocalState& state : all_states(sampled)) {
            EXPECT_NEAR(state.cauchy_Pa[1], mu * g, 1e-8 * mu);
            EXPECT_NEAR(state.cauchy_Pa[3], mu * g, 1e-8 * mu);
            EXPECT_NEAR(state.cauchy_Pa[0] - state.cauchy_Pa[4], mu * g * g, 1e-8 * mu);
            EXPECT_NEAR(state.first_piola_Pa[0], state.cauchy_Pa[0] - g * state.cauchy_Pa[1], 1e-8 * mu);
        }
    }
}

TEST(StepFields, ARigidRotationHasNoStress) {
    const double c = std::cos(0.9), s = std::sin(0.9);
    for (const auto& [type, formulation] : solids)
        for (const LocalState& state :
             all_states(sample(block(type, formulation), linear({c, -s, 0, s, c, 0, 0, 0, 1})))) {
            expect_tensor(state.cauchy_Pa, {}, 1e-8 * mu);
            EXPECT_NEAR(principal_stretches(state.deformation_gradient).stretch[0], 1.0, 1e-12);
        }
}

TEST(StepFields, TheKrakenLawHasAnInitialStressAndNoEnergy) {
    auto model = block(CellType::hex27, Formulation::displacement);
    model.materials[0].law = "kraken";  // sigma = kappa (J - 1) I + mu b
    const double kappa = 50 * mu, a = 1.02;
    for (const LocalState& state : all_states(sample(model, linear(identity_tensor))))
        expect_tensor(state.cauchy_Pa, {mu, 0, 0, 0, mu, 0, 0, 0, mu}, 1e-9 * kappa);
    const double swollen = kappa * (a * a * a - 1) + mu * a * a;
    for (const LocalState& state : all_states(sample(model, linear({a, 0, 0, 0, a, 0, 0, 0, a}))))
        expect_tensor(state.first_piola_Pa, {swollen * a * a, 0, 0, 0, swollen * a * a, 0, 0, 0, swollen * a * a},
                      1e-9 * kappa);
    EXPECT_FALSE(has_energy(model));
    EXPECT_TRUE(has_energy(block(CellType::hex27, Formulation::mixed)));
}

TEST(StepFields, OfABodyOfRevolutionIncludeTheHoopStretch) {
    // x = a X, r = b R: F = diag(a, b, b) in (x, r, hoop)
    const double b = 1.3, a = 1 / (b * b);
    for (const CellType type : {CellType::quad9, CellType::triangle6}) {
        const auto sampled =
            sample(block(type, Formulation::mixed, Kinematics::axisymmetric), linear({a, 0, 0, 0, b, 0, 0, 0, 1}));
        double volume = 0;
        for (const double part : sampled.fields.point_volumes_m3) volume += part;
        EXPECT_NEAR(volume, std::numbers::pi * (2.0 * 2.0 - 1.0), 1e-9);  // 0 < x < 1, 1 < r < 2
        for (const LocalState& state : all_states(sampled)) {
            expect_tensor(state.deformation_gradient, {a, 0, 0, 0, b, 0, 0, 0, b}, 1e-12);
            EXPECT_NEAR(state.cauchy_Pa[8] - state.cauchy_Pa[0], mu * (b * b - a * a), 1e-8 * mu);
        }
    }
}

/// Largest nodal error for an inflated tube in plane strain, r^2 = R^2 + c, against its exact stresses: the hoop stretch is
/// l = r/R, sigma_hoop - sigma_r = mu (l^2 - 1/l^2), and the radial stress follows from a stress-free outer wall.
double tube_error(CellType type, Formulation formulation, int n) {
    const double c = 0.8;
    const auto radius = [c](double R) { return std::sqrt(R * R + c); };
    // sigma_r = mu (ln(R/r) + R^2/(2 r^2)) + constant: the integral of (sigma_hoop - sigma_r)/r over r
    const auto radial = [&](double R) {
        const auto primitive = [&](double Q) {
            return mu * (std::log(Q / radius(Q)) + 0.5 * Q * Q / (radius(Q) * radius(Q)));
        };
        return primitive(2.0) - primitive(R);
    };
    auto model = block(type, formulation, Kinematics::axisymmetric, n);
    const auto pressure = [&](const Point& X) {  // p = sigma_r - dev sigma_r
        const double l = radius(X[1]) / X[1], trace = l * l + 1 / (l * l) + 1;
        return -radial(X[1]) - mu * (1 / (l * l) - trace / 3);
    };
    const auto sampled = sample(
        model,
        [&](const Point& X) {
            return Point{X[0], radius(X[1]), 0};
        },
        pressure);
    double worst = 0;
    for (std::size_t k = 0; k < sampled.region_points.size(); ++k) {
        const double R = model.mesh.point(sampled.region_points.node[k])[1], l = radius(R) / R;
        const Tensor& sigma = sampled.fields.nodes[k].cauchy_Pa;
        worst = std::max(worst, std::abs(sigma[8] - sigma[4] - mu * (l * l - 1 / (l * l))) / mu);
        if (formulation == Formulation::mixed) worst = std::max(worst, std::abs(sigma[4] + radial(R)) / mu);
    }
    return worst;
}

TEST(StepFields, NodalStressesOfAnInflatedTubeConverge) {
    for (const CellType type : {CellType::quad9, CellType::triangle6}) {
        const double coarse = tube_error(type, Formulation::mixed, 8), fine = tube_error(type, Formulation::mixed, 16);
        EXPECT_GT(std::log2(coarse / fine), 1.7) << mesh::topology(type).name << " " << coarse << " " << fine;
        EXPECT_LT(fine, 0.02);
    }
    const double coarse = tube_error(CellType::quad4, Formulation::f_bar, 8),
                 fine = tube_error(CellType::quad4, Formulation::f_bar, 16);
    EXPECT_GT(std::log2(coarse / fine), 0.85) << coarse << " " << fine;
}

TEST(StepFields, ALinearFieldIsExactAtTheNodes) {
    // u quadratic on cells that represent it: F is linear
    model::Case model =
        block_case(CellType::tet10, Kinematics::solid, Formulation::displacement, {.n = 2, .shake = 0.2});
    model.materials = {neo_hookean(mu, 50 * mu)};
    const auto sampled = sample(model, [](const Point& X) {
        return Point{X[0] + 0.1 * X[0] * X[1], X[1] + 0.05 * X[2] * X[2], X[2]};
    });
    for (std::size_t k = 0; k < sampled.region_points.size(); ++k) {
        const Point& X = model.mesh.point(sampled.region_points.node[k]);
        expect_tensor(sampled.fields.nodes[k].deformation_gradient,
                      {1 + 0.1 * X[1], 0.1 * X[0], 0, 0, 1, 0.1 * X[2], 0, 0, 1}, 1e-12);
    }
}

TEST(StepFields, EachRegionKeepsItsStressAtAnInterface) {
    for (const Formulation formulation : {Formulation::displacement, Formulation::mixed}) {
        auto model = block(CellType::hex27, formulation);
        model.mesh.region_names = {"rubber", "stiff"};
        for (mesh::Index cell = 0; cell < model.mesh.cell_count(); ++cell)
            model.mesh.cell_regions[static_cast<std::size_t>(cell)] =
                model.mesh.point(model.mesh.cell_nodes(cell)[26])[0] > 0.5;
        model.materials.push_back(model.materials[0]);
        model.materials[1].name = "stiff";
        model.materials[1].constants["mu"] = {5 * mu};
        const double g = 0.6;
        // the result file contains the mean of both sides on the interface, which must not affect the cells
        const auto sampled = sample(model, linear({1, 0, 0, g, 1, 0, 0, 0, 1}), [](const Point& X) {
            return std::abs(X[0] - 0.5) < 1e-9 ? 60e3 : X[0] > 0.5 ? 100e3 : 20e3;
        });
        std::size_t twice = 0;
        for (std::size_t k = 0; k < sampled.region_points.size(); ++k) {
            const bool stiff = sampled.region_points.region[k] == 1;
            const auto& state = sampled.fields.nodes[k];
            EXPECT_NEAR(state.cauchy_Pa[1], (stiff ? 5 : 1) * mu * g, 1e-8 * mu);
            if (formulation == Formulation::mixed) {
                EXPECT_NEAR(-pressure_Pa(state.cauchy_Pa), stiff ? 100e3 : 20e3, 1e-4 * mu);
            }
            twice += k > 0 && sampled.region_points.node[k] == sampled.region_points.node[k - 1];
        }
        EXPECT_EQ(twice, 25U);  // 5 x 5 nodes on the interface
    }
}

TEST(StepFields, AMismatchedOrInvertedStateIsRefused) {
    const auto model = block(CellType::hex27, Formulation::mixed);
    const RegionPoints region_points = make_region_points(model.mesh);
    const std::vector<double> u(3 * model.mesh.points.size()), p(model.mesh.points.size());
    EXPECT_THROW(static_cast<void>(step_fields(model, region_points, {std::span{u}.first(3), p})), Error);
    EXPECT_THROW(static_cast<void>(step_fields(model, region_points, {u, {}})), Error);
    std::vector<double> inverted(u.size());
    for (std::size_t node = 0; node < p.size(); ++node) inverted[3 * node] = -2 * model.mesh.points[node][0];
    EXPECT_THROW(static_cast<void>(step_fields(model, region_points, {inverted, p})), Error);
}

}  // namespace
}  // namespace soft::post
