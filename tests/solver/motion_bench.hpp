#pragma once
/// Small bodies in motion with closed-form solutions.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../fem/sample_cases.hpp"
#include "../model/time_functions.hpp"
#include "fem/system.hpp"
#include "solver/motion.hpp"

namespace soft::solver {

using model::ramp_time_function, model::sine_time_function, model::step_time_function;

struct Moved {
    std::vector<model::Step> steps;
    model::PathEnd end;
    std::vector<std::string> log;
    [[nodiscard]] const model::Step& last() const { return steps.back(); }
    [[nodiscard]] double end_value() const { return steps.back().outputs.at(0); }
};

inline Moved move(const model::Case& input) {
    fem::System system(input, PETSC_COMM_WORLD);
    Moved result;
    result.end = integrate_motion(system, {.step = [&](const model::Step& step, Vec) { result.steps.push_back(step); },
                                           .log = [&](const std::string& line) { result.log.push_back(line); }});
    return result;
}

inline constexpr double bar_length_m = 0.01, bar_density = 1000.0;
inline constexpr double bar_modulus_Pa = 1e5;  // of uniaxial strain: kappa + 4/3 mu

/// A bar of `cells` square quad4 cells along x in plane strain, 10 mm long, fixed in y everywhere, so that it moves only in x, under
/// uniaxial strain. Fixed at x = 0, a traction of `traction_Pa` at its end, output "elongation" there.
inline model::Case bar_case(int cells, double traction_Pa, const model::TimeFunction& time_function) {
    model::Case input;
    input.kinematics = model::Kinematics::plane_strain;
    input.formulation = model::Formulation::displacement;
    auto& mesh = input.mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    const double h = bar_length_m / cells;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i <= cells; ++i) mesh.points.push_back({h * i, h * j, 0.0});
    for (int i = 0; i < cells; ++i)
        mesh::add_cell(
            mesh, mesh::CellType::quad4,
            std::array{mesh::Index{i}, mesh::Index{i} + 1, mesh::Index{cells} + i + 2, mesh::Index{cells} + i + 1}, 0);
    name_boundary(mesh, [&](const mesh::Point& p) {
        if (p[0] < 1e-9) return "fixed";
        return p[0] > bar_length_m - 1e-9 ? "end" : "side";
    });
    input.supports = {{"fixed", {true, false, false}}, {"side", {false, true, false}}};
    model::Material material;
    material.name = "rubber";
    material.law = "linear-elastic";
    material.constants["mu"] = {0.3 * bar_modulus_Pa};
    material.bulk_modulus_Pa = 0.6 * bar_modulus_Pa;
    material.density_kg_m3 = bar_density;
    input.materials = {material};
    input.dead_loads = {{"end", model::DeadLoadKind::traction, {traction_Pa, 0, 0}, time_function}};
    input.outputs = {{"elongation", "end", {1, 0, 0}}};
    input.path.stages = {full_load(input, {})};
    return input;
}

/// One cell: a mass on a spring, K = E A / L with M = rho A L / 3 (consistent) or rho A L / 2 (lumped).
inline double oscillator_frequency(model::Integrator integrator) {
    using model::Integrator;
    const bool lumped = integrator == Integrator::heun || integrator == Integrator::explicit_euler ||
                        integrator == Integrator::central_difference;
    return std::sqrt((lumped ? 2.0 : 3.0) * bar_modulus_Pa / bar_density) / bar_length_m;
}

}  // namespace soft::solver
