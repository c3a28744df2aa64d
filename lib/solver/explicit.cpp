#include "solver/explicit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace soft::solver {

namespace {

constexpr int power_iterations = 200;
constexpr double power_tolerance = 1e-4;  // relative change of the squared frequency between iterations
constexpr int bisections = 60;

/// The larger |R(h s)| of the two roots s = w (-z +- sqrt(z^2 - 1)).
double amplification(model::Integrator integrator, double omega, double zeta, double h) {
    const std::complex<double> root = std::sqrt(std::complex<double>(zeta * zeta - 1.0));
    double worst = 0;
    for (const double sign : {1.0, -1.0}) {
        const std::complex<double> s = h * omega * (-zeta + sign * root);
        worst = std::max(worst, std::abs(integrator == model::Integrator::heun ? 1.0 + s + 0.5 * s * s : 1.0 + s));
    }
    return worst;
}

}  // namespace

double longest_stable_step_s(model::Integrator integrator, double duration_s, double omega, double zeta) {
    const double central = 2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta);
    if (integrator == model::Integrator::central_difference) return central;
    const auto grows = [&](double h) { return amplification(integrator, omega, zeta, h) > std::exp(h / duration_s); };
    // Bisection is valid: beyond the stable interval the amplification only increases.
    double stable = 0, unstable = 4.0 / omega;
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (stable + unstable);
        (grows(middle) ? unstable : stable) = middle;
    }
    return stable;
}

fem::Evaluation explicit_acceleration(MotionEquations& equations, MotionState& state) {
    const auto pressures = equations.lines().pressures(state.x, state.masses_kg);
    const auto evaluation = equations.evaluate(state.x, equations.levels(state.time_s, pressures), nullptr);
    linalg::copy(equations.load_force(), state.load_force);
    linalg::copy(equations.residual(), state.a);
    equations.add_damping(state.a, 1.0, state.v);
    SOFT_PETSC(VecScale(state.a, -1.0));
    SOFT_PETSC(VecPointwiseDivide(state.a, state.a, equations.lumped_mass()));
    return evaluation;
}

CentralDifference::CentralDifference(MotionEquations& equations) : equations_(equations) {}

void CentralDifference::start(const MotionState&) {}

StepResult CentralDifference::attempt(const MotionState& last, double step_s, MotionState& next) {
    const double h = step_s, alpha = equations_.dynamics().mass_damping_1_s;
    linalg::copy(last.v, next.v);
    linalg::add(next.v, 0.5 * h, last.a);
    linalg::copy(last.x, next.x);
    linalg::add(next.x, h, next.v);
    next.time_s = last.time_s + h;
    // Heun's method for the gas masses.
    next.masses_kg = last.masses_kg;
    const auto before = equations_.lines().flows(last.time_s, equations_.lines().pressures(last.x, last.masses_kg));
    for (std::size_t k = 0; k < before.size(); ++k) next.masses_kg[k] += h * before[k];
    const auto after = equations_.lines().flows(next.time_s, equations_.lines().pressures(next.x, next.masses_kg));
    for (std::size_t k = 0; k < before.size(); ++k)
        next.masses_kg[k] = last.masses_kg[k] + 0.5 * h * (before[k] + after[k]);
    const auto evaluation = explicit_acceleration(equations_, next);
    // So far with alpha v(1/2); correct to a1 = ... - alpha v1 = ... - alpha (v(1/2) + h/2 a1).
    SOFT_PETSC(VecScale(next.a, 1.0 / (1.0 + 0.5 * alpha * h)));
    linalg::add(next.v, 0.5 * h, next.a);
    StepResult result;
    result.newton.min_jacobian = evaluation.min_jacobian;
    result.newton.worst_cell = evaluation.worst_cell;
    if (!evaluation.admissible())
        result.newton.end = NewtonEnd::inverted;
    else if (!std::isfinite(linalg::norm(next.v)))
        result.newton.end = NewtonEnd::not_finite;
    return result;
}

StableStep::StableStep(MotionEquations& equations, model::Integrator integrator)
    : equations_(equations),
      integrator_(integrator),
      K_(equations.system().make_matrix()),
      mode_(equations.system().make_vector()),
      image_(equations.system().make_vector()) {
    fill_with_waves(mode_);  // the highest mode changes sign from node to node; this vector has a component along it
}

double StableStep::estimate(const MotionState& state) {
    const auto pressures = equations_.lines().pressures(state.x, state.masses_kg);
    (void)equations_.evaluate(state.x, equations_.levels(state.time_s, pressures), K_);
    double square = 0;
    for (int i = 0; i < power_iterations; ++i) {
        SOFT_PETSC(MatMult(K_, mode_, image_));
        const double next =
            0.5 * linalg::dot(mode_, image_) / kinetic_energy(equations_, mode_);  // Rayleigh's quotient
        SOFT_PETSC(VecPointwiseDivide(image_, image_, equations_.lumped_mass()));
        SOFT_PETSC(VecScale(image_, 1.0 / linalg::norm(image_)));
        std::swap(mode_, image_);
        const bool settled = std::abs(next - square) <= power_tolerance * std::abs(next);
        square = next;
        if (settled) break;
    }
    omega_ = std::sqrt(std::abs(square));  // negative where a compressed body is unstable: then the growth rate
    SOFT_PETSC(VecZeroEntries(image_));
    equations_.add_damping(image_, 1.0, mode_);
    const double zeta = 0.25 * linalg::dot(mode_, image_) / (omega_ * kinetic_energy(equations_, mode_));
    return longest_stable_step_s(integrator_, equations_.dynamics().duration_s, omega_, zeta);
}

}  // namespace soft::solver
