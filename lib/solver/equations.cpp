#include "solver/equations.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solver/constraint.hpp"

namespace soft::solver {

namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& problem, const std::string& remedy) {
    throw Error(ExitCode::bad_input, key, problem, remedy);
}

/// Throws Error (bad_input) for a case that cannot move in time.
fem::System& checked(fem::System& system) {
    const model::Case& input = system.input();
    if (input.path.stages.size() != 1)
        refuse("path", "a dynamic case has a single stage", "remove path.stages or dynamics");
    const auto& stage = input.path.stages[0];
    if (input.loads.empty() && input.dead_loads.empty() && input.motions.empty())
        refuse("loads", "no load acts on the body", "set loads.cavity.pressure");
    for (std::size_t load = 0; load < input.loads.size(); ++load)
        if (stage.supplies.at(load).what != model::Prescription::pressure)
            refuse("loads." + input.loads[load].name, "a dynamic case can prescribe only pressures",
                   "set a pressure with a time_function, or a supply line of the cavity");
    for (std::size_t i = 0; i < input.motions.size(); ++i)
        if (stage.motions.at(i) != 0.0 && !model::moves_obstacle(input, input.motions[i]))
            refuse("loads." + input.motions[i].face, "a dynamic case cannot prescribe the displacement of a face",
                   "use a force, or move an obstacle");
    return system;
}

/// Source pressures where there are lines, else cavity pressures.
template <class Share>
fem::LoadLevels shared_levels(const model::Case& input, Share&& share) {
    const auto& stage = input.path.stages[0];
    fem::LoadLevels levels = fem::no_loads(input);
    for (std::size_t i = 0; i < input.loads.size(); ++i)
        levels.pressures_Pa[i] = stage.supplies[i].value * share(input.loads[i].time_function);
    for (std::size_t i = 0; i < input.dead_loads.size(); ++i)
        levels.dead_loads[i] = stage.dead_loads.at(i) * share(input.dead_loads[i].time_function);
    for (std::size_t i = 0; i < input.motions.size(); ++i)
        levels.motions[i] = stage.motions.at(i) * share(input.motions[i].time_function);
    return levels;
}

/// The levels of all loads but the motions.
fem::LoadLevels forces_of(fem::LoadLevels levels) {
    std::ranges::fill(levels.motions, 0.0);
    return levels;
}

}  // namespace

const model::Dynamics& dynamics_of(const model::Case& input) {
    if (!input.dynamics) refuse("dynamics", "the case is not dynamic", "set dynamics.duration");
    if (!(input.dynamics->duration_s > 0.0))
        refuse("dynamics.duration", "the duration is not positive", "set a time above zero, for example 0.1 s");
    return *input.dynamics;
}

MotionState copy_of(const MotionState& state) {
    return {state.time_s,     copy_of(state.x),          copy_of(state.v),
            copy_of(state.a), copy_of(state.load_force), state.masses_kg};
}

void fill_with_waves(Vec out) {
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(VecGetOwnershipRange(out, &begin, &end));
    for (PetscInt i = begin; i < end; ++i)
        SOFT_PETSC(VecSetValue(out, i, std::sin(1.0 + 12.9898 * static_cast<double>(i)), INSERT_VALUES));
    linalg::assemble(out);
}

fem::LoadLevels full_levels(const model::Case& input) {
    return forces_of(shared_levels(input, [](const model::TimeFunction&) { return 1.0; }));
}

double shortest_change_s(const model::Case& input) {
    const double duration_s = dynamics_of(input).duration_s;
    double shortest = duration_s;
    (void)shared_levels(input, [&](const model::TimeFunction& time_function) {
        shortest = std::min(shortest, model::shortest_change_s(time_function, duration_s));
        return 0.0;
    });
    return shortest;
}

SupplyLines::SupplyLines(fem::System& system) : system_(system) {
    const model::Case& input = system.input();
    for (std::size_t load = 0; load < input.loads.size(); ++load) {
        const auto& line = input.loads[load].line;
        if (!line) continue;
        if (!system.volumes().has_volume(load) || !(line->resistance_Pa_s_m3 > 0.0))
            refuse("loads." + input.loads[load].name, "a supply line needs a cavity and a resistance above zero",
                   "set line.resistance, or remove the line");
        const double source_Pa = input.path.stages[0].supplies[load].value;
        lines_.push_back({load, input.loads[load].gas, source_Pa, line->resistance_Pa_s_m3});
    }
}

std::vector<double> SupplyLines::masses_at_rest_kg() const {
    const linalg::Vector rest = system_.make_vector();
    std::vector<double> masses;
    for (std::size_t k = 0; k < lines_.size(); ++k)
        masses.push_back(gas_mass_kg(lines_[k].gas, volume(k, rest, nullptr), 0.0));
    return masses;
}

double SupplyLines::volume(std::size_t k, Vec x, Vec gradient) const {
    return system_.volumes().of_load(lines_.at(k).load, x, gradient);
}

/// dP/dV = -n (P + a) / (V + D), dP/dm = n (P + a) / m of the polytropic gas.
SupplyLines::GasPressure SupplyLines::pressure(std::size_t k, double volume_m3, double mass_kg) const {
    const model::Gas& gas = lines_.at(k).gas;
    const double value = solver::gas_pressure_Pa(gas, volume_m3, mass_kg),
                 absolute = gas.exponent * (value + gas.ambient_Pa);
    return {value, -absolute / (volume_m3 + gas.dead_volume_m3), absolute / mass_kg};
}

std::vector<double> SupplyLines::pressures(Vec x, std::span<const double> masses_kg) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < lines_.size(); ++k)
        values.push_back(pressure(k, volume(k, x, nullptr), masses_kg[k]).value_Pa);
    return values;
}

double SupplyLines::conductance(std::size_t k) const {
    return lines_.at(k).gas.ambient_density_kg_m3 / lines_.at(k).resistance_Pa_s_m3;
}

double SupplyLines::flow(std::size_t k, double time_s, double pressure_Pa) const {
    const Line& line = lines_.at(k);
    const double share =
        share_at(system_.input().loads[line.load].time_function, dynamics_of(system_.input()).duration_s, time_s);
    return conductance(k) * (share * line.source_Pa - pressure_Pa);
}

std::vector<double> SupplyLines::flows(double time_s, std::span<const double> pressures_Pa) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < lines_.size(); ++k) values.push_back(flow(k, time_s, pressures_Pa[k]));
    return values;
}

std::vector<double> SupplyLines::pressure_rates(const MotionState& state) const {
    const linalg::Vector gradient = linalg::duplicate(state.x);
    std::vector<double> rates;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
        const double volume_m3 = volume(k, state.x, gradient), growth = linalg::dot(gradient, state.v);
        const auto gas = pressure(k, volume_m3, state.masses_kg[k]);
        rates.push_back(gas.by_volume * growth + gas.by_mass * flow(k, state.time_s, gas.value_Pa));
    }
    return rates;
}

MotionEquations::MotionEquations(fem::System& system, MassKind kind)
    : system_(system),
      input_(system.input()),
      dynamics_(dynamics_of(input_)),
      lines_(checked(system)),
      mask_(fem::displacement_mask(system)),
      R_(system.make_vector()),
      load_force_(system.make_vector()),
      scratch_(system.make_vector()) {
    if (kind == MassKind::lumped && system.dofs().pressures > 0)
        refuse("dynamics.integrator",
               "explicit integrators do not support cells with pressure unknowns, which have no mass",
               "use formulation: f-bar or displacement with a bulk modulus, or an implicit integrator");
    for (std::size_t k = 0; k < lines_.count(); ++k) line_forces_.push_back(system.make_vector());
    if (kind == MassKind::lumped)
        lumped_ = fem::lumped_mass(system);
    else
        M_ = fem::consistent_mass(system);
    if (dynamics_.stiffness_damping_s != 0.0) make_damping();
}

/// Without contact, whose stiffness does not damp. Removes the rows and columns of pressure unknowns: see the header.
void MotionEquations::make_damping() {
    K0_ = system_.make_matrix();
    const linalg::Vector undeformed = system_.make_vector();
    const bool rests = system_.contact().rests();
    system_.contact().set_resting(true);
    (void)system_.evaluate(undeformed, fem::no_loads(input_), R_, K0_);
    system_.contact().set_resting(rests);
    std::vector<PetscInt> pressures;
    const PetscScalar* has_mass = nullptr;
    SOFT_PETSC(VecGetArrayRead(mask_, &has_mass));
    for (PetscInt i = 0; i < system_.dofs().end - system_.dofs().begin; ++i)
        if (has_mass[i] == 0.0) pressures.push_back(system_.dofs().begin + i);
    SOFT_PETSC(VecRestoreArrayRead(mask_, &has_mass));
    SOFT_PETSC(MatSetOption(K0_, MAT_KEEP_NONZERO_PATTERN, PETSC_TRUE));
    SOFT_PETSC(
        MatZeroRowsColumns(K0_, static_cast<PetscInt>(pressures.size()), pressures.data(), 0.0, nullptr, nullptr));
}

MotionState MotionEquations::rest() const {
    return {0.0,
            system_.make_vector(),
            system_.make_vector(),
            system_.make_vector(),
            system_.make_vector(),
            lines_.masses_at_rest_kg()};
}

fem::LoadLevels MotionEquations::levels(double time_s, std::span<const double> line_pressures_Pa) const {
    fem::LoadLevels levels = shared_levels(input_, [&](const model::TimeFunction& time_function) {
        return share_at(time_function, dynamics_.duration_s, time_s);
    });
    for (std::size_t k = 0; k < lines_.count(); ++k) levels.pressures_Pa[lines_.load(k)] = line_pressures_Pa[k];
    levels.time_s = time_s;
    return levels;
}

fem::LoadLevels MotionEquations::rates(double time_s, std::span<const double> line_rates) const {
    fem::LoadLevels rates = shared_levels(input_, [&](const model::TimeFunction& time_function) {
        return share_rate(time_function, dynamics_.duration_s, time_s);
    });
    for (std::size_t k = 0; k < lines_.count(); ++k) rates.pressures_Pa[lines_.load(k)] = line_rates[k];
    return rates;
}

fem::Evaluation MotionEquations::evaluate(Vec x, const fem::LoadLevels& levels, Mat K) {
    std::vector<fem::LoadColumn> columns{{forces_of(levels), load_force_}};
    for (std::size_t k = 0; k < lines_.count() && K != nullptr; ++k) {
        fem::LoadLevels unit = fem::no_loads(input_);
        unit.pressures_Pa[lines_.load(k)] = 1.0;
        columns.push_back({std::move(unit), line_forces_[k]});
    }
    return system_.evaluate(x, levels, R_, K, columns);
}

void MotionEquations::add_inertia(Vec out, double factor, Vec a) const {
    if (M_.get() != nullptr)
        SOFT_PETSC(MatMult(M_, a, scratch_));
    else
        SOFT_PETSC(VecPointwiseMult(scratch_, lumped_, a));
    linalg::add(out, factor, scratch_);
}

void MotionEquations::add_damping(Vec out, double factor, Vec v) const {
    if (dynamics_.mass_damping_1_s != 0.0) add_inertia(out, factor * dynamics_.mass_damping_1_s, v);
    if (K0_.get() == nullptr) return;
    SOFT_PETSC(MatMult(K0_, v, scratch_));
    linalg::add(out, factor * dynamics_.stiffness_damping_s, scratch_);
}

void MotionEquations::add_matrices(Mat K, double by_velocity, double by_acceleration) const {
    linalg::add(K, by_acceleration + by_velocity * dynamics_.mass_damping_1_s, M_);
    if (K0_.get() != nullptr) linalg::add(K, by_velocity * dynamics_.stiffness_damping_s, K0_);
}

double kinetic_energy(const MotionEquations& equations, Vec v) {
    const linalg::Vector momentum = linalg::duplicate(v);
    equations.add_inertia(momentum, 1.0, v);
    return 0.5 * linalg::dot(momentum, v);
}

double MotionEquations::displacement_norm(Vec x) const {
    SOFT_PETSC(VecPointwiseMult(scratch_, mask_, x));
    return linalg::norm(scratch_);
}

}  // namespace soft::solver
