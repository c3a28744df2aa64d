/// Bodies in motion: free flight, the breathing sphere, supply lines, the slow limit.
#include <gtest/gtest.h>

#include "../fem/block_mesh.hpp"
#include "../solver/sphere.hpp"
#include "breathing_sphere.hpp"
#include "core/error.hpp"
#include "fem/mass.hpp"
#include "motion_bench.hpp"

namespace soft::solver {
namespace {

using model::Dynamics;
using model::Integrator;

constexpr double density = 1000.0;

/// A plate that reaches the end of a bar at rest with the velocity v sends a wave of the stress rho c v into it, c^2 = E / rho, until it
/// returns from the fixed end. The plate moves by twice its distance to the bar.
TEST(Motion, AMovingObstacleSendsAWaveIntoABar) {
    constexpr int cells = 50;
    constexpr double length_m = bar_length_m, speed_m_s = 0.05, height_m = length_m / cells;
    const double wave_m_s = std::sqrt(bar_modulus_Pa / bar_density), there_and_back_s = 2 * length_m / wave_m_s;
    const double gap_m = speed_m_s * there_and_back_s, reaches_s = there_and_back_s;
    for (const Integrator integrator : {Integrator::generalized_alpha, Integrator::hht, Integrator::newmark,
                                        Integrator::ark4, Integrator::heun, Integrator::central_difference}) {
        auto input = bar_case(cells, 0.0, ramp_time_function());
        input.dead_loads.clear();
        input.obstacles = {{"plate", model::Plane{{length_m + gap_m, 0, 0}, {-1, 0, 0}}}};
        input.motions = {{"plate", {-2 * gap_m, 0, 0}, ramp_time_function(2 * reaches_s)}};
        input.outputs = {{"push", "", {-1, 0, 0}, model::Measure::force, "", {}, "plate"},
                         {"way", "", {-1, 0, 0}, model::Measure::displacement, "", {}, "plate"}};
        input.contact.distance = 0.01;
        input.path.stages = {full_load(input, {})};
        input.dynamics = Dynamics{.integrator = integrator,
                                  .duration_s = 2.1 * reaches_s,
                                  .accuracy = 1e-5,
                                  .stiffness_damping_s = 2e-6,
                                  .rows = 100'000};
        if (integrator == Integrator::central_difference || integrator == Integrator::heun)
            input.dynamics->step_s = 2e-6;
        const auto moved = move(input);
        ASSERT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
        double impulse = 0, last_s = 0;
        const double from_s = reaches_s + 0.1 * there_and_back_s, to_s = reaches_s + 0.9 * there_and_back_s;
        for (const auto& step : moved.steps) {
            const double t = step.motion->time_s;
            EXPECT_NEAR(step.pressure_Pa, std::min(t / (2 * reaches_s), 1.0), 1e-12);  // the load factor
            EXPECT_NEAR(step.outputs[1], 2 * gap_m * step.pressure_Pa, 1e-12);
            if (t < reaches_s - 0.05 * there_and_back_s) {
                EXPECT_EQ(step.outputs[0], 0.0);
            }
            impulse += -step.outputs[0] * std::max(0.0, std::min(t, to_s) - std::max(last_s, from_s));
            last_s = t;
        }
        const auto& energies = *moved.last().motion;
        const double gained_J = energies.kinetic_energy_J + energies.stored_energy_J + energies.damping_work_J;
        EXPECT_NEAR(gained_J / energies.load_work_J, 1, 0.01);
        EXPECT_NEAR(impulse / (to_s - from_s) / (bar_density * wave_m_s * speed_m_s * height_m), 1, 0.02);
    }
}

// An unsupported soft incompressible square, pulled at one edge, deforms and rotates. Its centre of mass moves by x = F t^2 / 2 m,
// the time integral of its momentum F t over the mass.
TEST(Motion, AFreeBodyHasTheMomentumOfItsLoads) {
    auto input = block_case(mesh::CellType::quad9, model::Kinematics::plane_strain, model::Formulation::mixed,
                            {.n = 2, .shake = 0.1});
    input.materials = {sample_material(true)};
    input.materials[0].density_kg_m3 = density;
    input.mesh.facet_sets.clear();
    name_boundary(input.mesh, [](const mesh::Point& p) { return p[0] > 1.0 - 1e-9 ? "end" : "rest"; });
    const std::array<double, 3> traction{0.05 * sample_mu_Pa, 0.03 * sample_mu_Pa, 0.0};
    input.dead_loads = {{"end", model::DeadLoadKind::traction, traction, step_time_function()}};
    input.path.stages = {full_load(input, {})};
    input.dynamics = Dynamics{.duration_s = 0.3, .step_s = 0.01};
    fem::System system(input, PETSC_COMM_WORLD);
    const auto M = fem::consistent_mass(system);
    std::array<linalg::Vector, 2> ones{system.make_vector(), system.make_vector()},
        weights{system.make_vector(), system.make_vector()};
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
            if (const auto dof = system.dofs().displacement[2 * node + i];
                dof >= system.dofs().begin && dof < system.dofs().end)
                SOFT_PETSC(VecSetValue(ones[i], dof, 1.0, INSERT_VALUES));
        SOFT_PETSC(VecAssemblyBegin(ones[i]));
        SOFT_PETSC(VecAssemblyEnd(ones[i]));
        SOFT_PETSC(MatMult(M, ones[i], weights[i]));
    }
    double turned = 0, largest = 0;
    const auto end = integrate_motion(
        system, {.step = [&](const model::Step& step, Vec x) {
            const double t = step.motion->time_s;
            for (std::size_t i = 0; i < 2; ++i) {
                const double exact = 0.5 * traction[i] * t * t;  // m = density of 1 m^2, the edge 1 m long
                EXPECT_NEAR(linalg::dot(weights[i], x), exact, 1e-8 * 0.5 * traction[0] * 0.09);
            }
            turned = std::max(turned, step.max_stretch);
            largest = step.motion->kinetic_energy_J;
        }});
    EXPECT_EQ(end.reason, model::StopReason::done) << end.detail;
    EXPECT_GT(turned, 1.02);
    EXPECT_GT(largest, 0.0);
}

/// Half the sphere, from rest under a sudden pressure of `share` x mu.
model::Case breathing_case(double share, double duration) {
    auto input = sphere_case(3, 6);
    input.materials[0].density_kg_m3 = density;
    input.loads[0].time_function = step_time_function();
    input.path.stages = {full_load(input, {share * sample_mu_Pa})};
    input.dynamics = Dynamics{.duration_s = duration};
    return input;
}

/// Inner stretch at the end by the equation of motion of the sphere in sphere.hpp.
double breathing_stretch(double share, double duration) {
    const auto elastic_Pa = [](double stretch) { return sample_mu_Pa * solver::sphere_pressure(stretch); };
    return breathing_stretches({0.01, 0.02, density}, share * sample_mu_Pa, elastic_Pa, duration, 1).back();
}

constexpr double breathing_s = 3e-3;  // more than one period of the sphere

/// Inner stretch at the end of the mesh's motion.
double breathing_end(Integrator integrator, int steps) {
    auto input = breathing_case(0.4, breathing_s);
    input.dynamics->integrator = integrator;
    input.dynamics->step_s = breathing_s / steps;
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
    return solver::inner_stretch(moved.last());
}

// The incompressibility constraint is satisfied at every step, and the order is that of the method.
TEST(Motion, TheIncompressibleSphereFollowsItsEquationOfMotion) {
    const double exact = breathing_stretch(0.4, breathing_s), limit = breathing_end(Integrator::ark4, 100);
    EXPECT_NEAR(limit, exact, 3e-4);  // 18 cells; their error, not that of the steps
    struct Wanted {
        Integrator integrator;
        double order;
    };
    for (const auto& [integrator, order] :
         {Wanted{Integrator::generalized_alpha, 2}, Wanted{Integrator::hht, 2}, Wanted{Integrator::newmark, 2}}) {
        const double coarse = std::abs(breathing_end(integrator, 50) - limit),
                     fine = std::abs(breathing_end(integrator, 100) - limit);
        EXPECT_GT(std::log2(coarse / fine), order - 0.2) << int(integrator);
        EXPECT_LT(fine, 1e-3) << int(integrator);
    }
    EXPECT_NEAR(breathing_end(Integrator::rosenbrock, 100), limit, 1e-4);  // its order falls below 3 under a constraint
    EXPECT_NEAR(breathing_end(Integrator::implicit_euler, 400), limit, 2e-3);
}

TEST(Motion, AdaptiveStepsFollowTheSphere) {
    auto input = breathing_case(0.4, breathing_s);
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
    EXPECT_NEAR(solver::inner_stretch(moved.last()), breathing_stretch(0.4, breathing_s), 5e-3);
    EXPECT_LT(moved.steps.size(), 300u);
    const auto& m = *moved.last().motion;
    EXPECT_NEAR((m.kinetic_energy_J + m.stored_energy_J) / m.load_work_J, 1.0, 1e-2);
}

// The work of a constant pressure is p (V - V0) of the whole sphere.
TEST(Motion, WorkAndEnergiesAreThoseOfTheWholeBody) {
    auto input = breathing_case(0.4, breathing_s / 2);
    input.dynamics->step_s = breathing_s / 400;
    const auto moved = move(input);
    const auto& last = moved.last();
    const double work = 0.4 * sample_mu_Pa * (*last.volume_m3 - *moved.steps.front().volume_m3);
    EXPECT_NEAR(last.motion->load_work_J / work, 1.0, 1e-4);
    EXPECT_NEAR((last.motion->kinetic_energy_J + last.motion->stored_energy_J) / work, 1.0, 2e-3);
}

// A ramp of 1 s follows the static states: its start leaves an oscillation of the undamped body with the amplitude 1 / (w t) of the
// load at t, 0.06 % or less after 0.6 s (w above 2700 1/s). Steps of 20 ms do not resolve this oscillation and damp it.
TEST(Motion, ASlowRampFollowsTheStaticPath) {
    auto input = breathing_case(0.6, 1.0);
    input.loads[0].time_function = ramp_time_function();
    for (const double step_s : {0.0, 0.02}) {
        input.dynamics->step_s = step_s;
        const auto moved = move(input);
        EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
        for (const auto& step : moved.steps) {
            if (step.motion->time_s < (step_s == 0.0 ? 0.6 : 0.2)) continue;
            EXPECT_NEAR(step.pressure_Pa / (sample_mu_Pa * solver::sphere_pressure(solver::inner_stretch(step))), 1.0,
                        1e-3)
                << step.motion->time_s;
        }
        EXPECT_NEAR(moved.last().tangent_pressure, 0.0, 1e-9);  // the ramp ends with the motion
    }
}

// A ramp so slow that the pressure is 2e-8 to 4e-7 of the modulus in the first steps: a residual of 1e-9 of its force is below the
// rounding of the stress, which is eps times the modulus. At this time the wall still moves like a free mass,
// m a'' = 4 pi A^2 p t / T with m of breathing_sphere.hpp: dV/dt = (4 pi A^2)^2 p t^2 / (2 T m).
TEST(Motion, LoadsNearRoundingMoveTheBody) {
    constexpr double ramp_s = 1.0;
    for (const auto integrator : {Integrator::generalized_alpha, Integrator::hht, Integrator::newmark,
                                  Integrator::implicit_euler, Integrator::ark4, Integrator::rosenbrock}) {
        auto input = breathing_case(0.4, ramp_s);
        input.loads[0].time_function = ramp_time_function();
        input.dynamics->integrator = integrator;
        input.dynamics->step_s = 5e-8;
        input.path.stages[0].until = {{"steps", 20.0}};
        const auto moved = move(input);
        EXPECT_EQ(moved.end.reason, model::StopReason::done) << int(integrator) << moved.end.detail;
        const double t = moved.last().motion->time_s, area = 4.0 * std::numbers::pi * 1e-4;
        const double m = area * density * 0.01 * (1.0 - 0.5);
        const double flow = area * area * 0.4 * sample_mu_Pa * t * t / (2.0 * ramp_s * m);
        EXPECT_NEAR(moved.last().tangent_volume / flow, 1.0, 0.1) << int(integrator);
    }
}

// A bar with dominant damping C = b K: all its modes creep alike, u = u_end (1 - exp(-t/b)). The load is applied suddenly and
// accelerates the last cell far more than any step resolves.
TEST(Motion, AStepOnAHeavilyDampedBarCreeps) {
    constexpr double traction_Pa = 10.0, end_m = traction_Pa * bar_length_m / bar_modulus_Pa;
    for (const auto integrator : {Integrator::generalized_alpha, Integrator::hht, Integrator::newmark}) {
        for (const double b : {1.0, 0.03})
            for (const double step_s : {0.0, 5e-3}) {
                auto input = bar_case(24, traction_Pa, step_time_function());
                input.dynamics =
                    Dynamics{.integrator = integrator, .duration_s = 5.0, .step_s = step_s, .stiffness_damping_s = b};
                const auto moved = move(input);
                ASSERT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
                double damped = 0;
                for (const auto& step : moved.steps) {
                    const double t = step.motion->time_s, creep = 1.0 - std::exp(-t / b);
                    const double allowed = step_s > 0.0 ? std::pow(step_s / b, 2) : 2e-3;  // second order
                    EXPECT_NEAR(step.outputs[0] / end_m, creep, allowed) << int(integrator) << ' ' << b << ' ' << t;
                    EXPECT_GE(step.motion->damping_work_J, damped * (1.0 - 1e-9)) << int(integrator) << ' ' << b;
                    damped = step.motion->damping_work_J;
                }
            }
    }
}

/// A sphere so stiff that its volume is constant, isothermal gas: dp/dt = (source - p) / (resistance (V + D) / ambient).
model::Case line_case(double time_constant_s) {
    auto input = sphere_case(1, 2);
    input.materials[0].density_kg_m3 = density;
    input.materials[0].constants["mu"] = {1e10};  // the volume changes by p / mu, 1e-5 of the capacity
    input.loads[0].time_function = step_time_function();
    input.loads[0].gas.dead_volume_m3 = 2e-6;
    input.path.stages = {full_load(input, {3e4})};
    fem::System system(input, PETSC_COMM_WORLD);
    const double volume = system.volumes().of_load(0, system.make_vector(), nullptr);
    input.loads[0].line = model::SupplyLine{time_constant_s * 101325.0 / (volume + 2e-6)};
    return input;
}

TEST(Motion, ARigidCavityFillsWithResistanceTimesCapacity) {
    constexpr double tau = 0.05;
    struct Wanted {
        Integrator integrator;
        double error;
    };
    for (const auto& [integrator, error] :
         {Wanted{Integrator::generalized_alpha, 1e-4}, Wanted{Integrator::newmark, 1e-4},
          Wanted{Integrator::ark4, 3e-5}, Wanted{Integrator::rosenbrock, 3e-5},
          Wanted{Integrator::implicit_euler, 1e-2}}) {
        auto input = line_case(tau);
        input.dynamics = Dynamics{.integrator = integrator, .duration_s = 3.0 * tau, .step_s = tau / 50};
        const auto moved = move(input);
        EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
        for (const auto& step : moved.steps) {
            const double share = std::exp(-step.motion->time_s / tau);
            EXPECT_NEAR(step.pressure_Pa / 3e4, 1.0 - share, error) << int(integrator) << " " << step.motion->time_s;
            EXPECT_NEAR(step.tangent_pressure * tau / 3e4, share, 2.0 * error) << int(integrator);
        }
    }
}

// A soft body on a supply line: the gas in the cavity equals the inflow through the resistance.
TEST(Motion, ALineKeepsTheMassBalanceOfItsGas) {
    auto input = breathing_case(0.4, 0.1);
    input.loads[0].line = model::SupplyLine{5e8};
    input.dynamics->integrator = Integrator::ark4;
    input.dynamics->step_s = 5e-4;
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
    const auto mass = [](const model::Step& step) {
        return 1.204 * (1.0 + step.pressure_Pa / 101325.0) * *step.volume_m3;
    };
    double inflow = 0, before = 0;
    for (std::size_t i = 1; i < moved.steps.size(); ++i) {  // trapezoidal
        const double now = 1.204 / 5e8 * 0.5 *
                           (2.0 * 0.4 * sample_mu_Pa - moved.steps[i].pressure_Pa - moved.steps[i - 1].pressure_Pa);
        inflow += now * (moved.steps[i].motion->time_s - moved.steps[i - 1].motion->time_s);
        before = mass(moved.steps[i]) - mass(moved.steps[0]);
    }
    EXPECT_GT(before, 0.1 * mass(moved.steps[0]));
    EXPECT_NEAR(inflow / before, 1.0, 1e-3);
}

TEST(Motion, RejectsUnsupportedCases) {
    const auto refused = [](const model::Case& input, const std::string& word) {
        try {
            (void)move(input);
            ADD_FAILURE() << word << " not refused";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    };
    auto weightless = breathing_case(0.4, 1e-3);
    weightless.materials[0].density_kg_m3.reset();
    refused(weightless, "density");
    auto by_volume = breathing_case(0.4, 1e-3);
    by_volume.path.stages[0].supplies = {{model::Prescription::volume_ratio, 2.0}};
    refused(by_volume, "pressure");
    auto mixed = breathing_case(0.4, 1e-3);
    mixed.dynamics->integrator = Integrator::central_difference;
    refused(mixed, "pressure unknown");
    auto moving = bar_case(2, 0.0, step_time_function());
    moving.dead_loads.clear();
    moving.motions = {{"end", {1e-3, std::nullopt, std::nullopt}}};
    moving.path.stages = {full_load(moving, {})};
    moving.dynamics = Dynamics{.duration_s = 1e-3};
    refused(moving, "displacement of a face");
}

}  // namespace
}  // namespace soft::solver
