#include "solver/bordered_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fem/element_levels.hpp"
#include "fem/mass.hpp"
#include "linalg/matrix_rows.hpp"
#include "model/cavity_surface.hpp"

namespace soft::solver {

namespace {

/// Step of differences in time, of the shortest relaxation time or the step; and of the time itself, which has 16 digits.
constexpr double time_difference = 1e-5, time_digits = 1e-10;

/// More unknowns than this share, or than this number, are not eliminated last: their front would take longer than the iterations.
constexpr double share_of_rims = 0.02, most_on_rims = 1000;

model::SolverSettings with_choice(const fem::System& system, model::SolverSettings settings) {
    settings.linear = fem::choose_linear(settings.linear, system.input(), system.dofs().total, symmetry_of(system));
    return settings;
}

/// Of the stiffness of pressures on surfaces with a free edge. On several ranks, which would each need the whole matrix, and where there
/// are so many that they would fill the factor, the iterations correct what LDL^T ignores.
std::vector<PetscInt> unsymmetric_unknowns(fem::System& system, const model::SolverSettings& settings, Mat K) {
    int ranks = 1;
    MPI_Comm_size(system.comm(), &ranks);
    if (settings.linear.method != model::LinearMethod::automatic || !system.has_symmetric_tangent() || ranks > 1)
        return {};
    auto levels = fem::no_loads(system.input());
    std::iota(levels.pressures_Pa.begin(), levels.pressures_Pa.end(), 1.0);  // equal ones may cancel at a common edge
    const linalg::Vector R = system.make_vector();
    system.assembler().load_forces(system.make_vector(), levels, R, K);
    auto found = linalg::unsymmetric_unknowns(K);
    const double most = std::min(most_on_rims, share_of_rims * static_cast<double>(system.dofs().total));
    if (static_cast<double>(found.size()) > most) found.clear();
    return found;
}

}  // namespace

linalg::Symmetry symmetry_of(const fem::System& system) {
    return system.has_symmetric_tangent() ? linalg::Symmetry::symmetric : linalg::Symmetry::general;
}

BorderedSystem::BorderedSystem(fem::System& fem_system, const model::SolverSettings& given)
    : system(fem_system),
      settings(with_choice(fem_system, given)),
      K(fem_system.make_matrix()),
      linear(K, symmetry_of(fem_system), settings.linear, settings.threads,
             unsymmetric_unknowns(fem_system, settings, K)),
      R(fem_system.make_vector()),
      R_of_forces_(fem_system.make_vector()) {
    const bool matrix_free = settings.linear.method == model::LinearMethod::jacobian_free;
    fem::configure_preconditioner(linear, system, K);
    if (matrix_free || given.tangent == model::TangentSource::finite_difference)
        differences_.emplace(system, K, given.tangent);
    if (matrix_free) linear.set_operator(differences_->jacobian());
}

void BorderedSystem::set_loads(const StageLoads& loads) {
    loads_ = &loads;
    const std::size_t count = loads.free_supplies().size() + 1;
    for (auto* list : {&force_vectors_, &columns, &gradients_})
        while (list->size() < count) list->push_back(system.make_vector());
    forces.clear();
    for (std::size_t k = 0; k + 1 < count; ++k) forces.push_back({loads.unit_pressure(k), force_vectors_[k]});
    forces.push_back({loads.rate(), force_vectors_[count - 1]});
    factor_is_recent = columns_are_recent = false;
    assembled_at_.reset();
    loads_move_ = std::ranges::any_of(loads.rate().motions, [](double rate) { return rate != 0.0; });
}

Mat BorderedSystem::matrix_for(Assemble what) {
    if (what == Assemble::tangent && (loads_move_ || settings.tangent == model::TangentSource::exact)) return K;
    if (!loads_move_) return nullptr;
    if (spare_ == nullptr) spare_ = system.make_matrix();
    return spare_;
}

fem::Evaluation BorderedSystem::evaluate_at(const State& state, Assemble what) {
    const auto levels = loads_->levels(state.load_factor, state.pressures_Pa);
    const Mat matrix = matrix_for(what);
    const auto evaluation = system.evaluate(state.x, levels, R, matrix, forces);
    has_time_force_ = false;
    if (evaluation.pattern_grew && matrix == K) pattern_changed();
    assembled_at_.reset();
    if (drag_ > 0.0)
        add_drag(state, matrix);
    else if (matrix == K && evaluation.admissible())
        assembled_at_ = copy_of(state);
    if (loads_->rate().time_s > 0.0 && system.internal().shortest_time_s() > 0.0) linalg::copy(R, R_of_forces_);
    return evaluation;
}

/// A one-sided difference in time at fixed unknowns, which the state at the start of a step allows too.
void BorderedSystem::add_time_force(const State& state) {
    const double duration_s = loads_->rate().time_s, shortest_s = system.internal().shortest_time_s();
    if (duration_s == 0.0 || shortest_s == 0.0 || has_time_force_) return;
    has_time_force_ = true;
    const auto levels = loads_->levels(state.load_factor, state.pressures_Pa);
    const double step_s = levels.time_s - system.internal().start_time_s();
    const double delta_s = std::max(time_difference * std::max(shortest_s, step_s), time_digits * levels.time_s);
    auto later = levels;
    later.time_s += delta_s;
    static_cast<void>(system.evaluate(state.x, later, R, nullptr));
    linalg::add(R, -1.0, R_of_forces_);
    linalg::add(forces.back().out, -duration_s / delta_s, R);
    system.prescribe(levels);
}

void BorderedSystem::set_drag(double drag, Vec origin) {
    drag_ = drag;
    if (drag_ == 0.0) return;
    drag_origin_ = copy_of(origin);
    if (drag_weights_ != nullptr) return;
    drag_weights_ = fem::displacement_mask(system);
    const linalg::Vector undeformed = system.make_vector(), diagonal = system.make_vector();
    static_cast<void>(system.evaluate(undeformed, fem::no_loads(system.input()), R, K));
    SOFT_PETSC(MatGetDiagonal(K, diagonal));
    const double unknowns = linalg::dot(drag_weights_, drag_weights_);
    SOFT_PETSC(VecScale(drag_weights_, linalg::dot(diagonal, drag_weights_) / unknowns));
    assembled_at_.reset();
}

void BorderedSystem::add_drag(const State& state, Mat matrix) {
    const linalg::Vector force = copy_of(state.x);
    linalg::add(force, -1.0, drag_origin_);
    SOFT_PETSC(VecPointwiseMult(force, force, drag_weights_));
    linalg::add(R, drag_, force);
    if (matrix == nullptr) return;
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i) {
        double weight = 0;
        SOFT_PETSC(VecGetValues(drag_weights_, 1, &i, &weight));
        if (weight > 0.0) SOFT_PETSC(MatSetValue(matrix, i, i, drag_ * weight, ADD_VALUES));
    }
    SOFT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    SOFT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

/// The linear solver and others keep the handle of K.
void BorderedSystem::pattern_changed() {
    couplings_ = system.contact().couplings();
    spare_ = {};
    linear.pattern_changed();
    if (differences_) differences_.emplace(system, K, settings.tangent);
    if (settings.linear.method == model::LinearMethod::jacobian_free) linear.set_operator(differences_->jacobian());
    factor_is_recent = false;
    assembled_at_.reset();
}

void BorderedSystem::couple_contact(const State& state) {
    system.prescribe(loads_->levels(state.load_factor, state.pressures_Pa));
    system.contact().couple(state.x);
    if (system.contact().couplings() == couplings_) return;
    system.renew(K);
    pattern_changed();
}

double BorderedSystem::share_without_crossing(const State& from, const State& to) {
    return system.contact().share_without_crossing(from.x, loads_->levels(from.load_factor, from.pressures_Pa), to.x,
                                                   loads_->levels(to.load_factor, to.pressures_Pa));
}

bool BorderedSystem::passes_through_obstacle(const State& from, const State& to) {
    return system.contact().passes_through_obstacle(from.x, loads_->levels(from.load_factor, from.pressures_Pa), to.x,
                                                    loads_->levels(to.load_factor, to.pressures_Pa));
}

/// A finite-difference tangent evaluates the system at other states afterwards.
bool BorderedSystem::is_assembled_at(const State& state) const {
    if (!assembled_at_ || differences_ || state.load_factor != assembled_at_->load_factor ||
        state.pressures_Pa != assembled_at_->pressures_Pa)
        return false;
    PetscBool same = PETSC_FALSE;
    SOFT_PETSC(VecEqual(state.x, assembled_at_->x, &same));
    return same == PETSC_TRUE;
}

/// F = I + grad u is rounded like positions are: the last digit is that of a displacement of the cell's size.
double BorderedSystem::change_by_digits(const State& state, const fem::LoadLevels& levels) {
    const model::Case& input = system.input();
    const double nodes = static_cast<double>(input.mesh.points.size());
    const double cell_m = mesh::extent_m(input.mesh) / std::pow(nodes, 1.0 / input.mesh.dimension);
    const linalg::Vector nearby = copy_of(state.x);
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i) {
        double value = 0;
        SOFT_PETSC(VecGetValues(state.x, 1, &i, &value));
        const double digit = std::numeric_limits<double>::epsilon() * (std::abs(value) + cell_m);
        SOFT_PETSC(VecSetValue(nearby, i, value + (i % 3 == 0 ? -digit : digit), INSERT_VALUES));
    }
    SOFT_PETSC(VecAssemblyBegin(nearby));
    SOFT_PETSC(VecAssemblyEnd(nearby));
    static_cast<void>(system.evaluate(state.x, levels, R, nullptr));
    const linalg::Vector change = copy_of(R);
    static_cast<void>(system.evaluate(nearby, levels, R, nullptr));
    linalg::add(change, -1.0, R);
    assembled_at_.reset();
    return linalg::norm(change);
}

void BorderedSystem::differentiate(const State& state) {
    if (!differences_) return;
    const auto levels = loads_->levels(state.load_factor, state.pressures_Pa);
    differences_->set_base(state.x, levels, R);
    if (settings.tangent == model::TangentSource::finite_difference) differences_->tangent(state.x, levels, K);
}

std::optional<NewtonEnd> BorderedSystem::factorize() {
    factor = linear.factorize();
    factor_is_recent = factor.succeeded;
    if (factor.succeeded) return std::nullopt;
    if (linear.is_krylov()) return NewtonEnd::linear_solver;
    return settings.linear.method == model::LinearMethod::cholmod ? NewtonEnd::not_definite : NewtonEnd::singular;
}

/// With LinearMethod::automatic, a solve that still fails after a successful factorisation means a singular tangent.
NewtonEnd BorderedSystem::solve_failure() const {
    return settings.linear.method == model::LinearMethod::automatic ? NewtonEnd::singular : NewtonEnd::linear_solver;
}

void BorderedSystem::evaluate_rows(const Constraint& target, const State& state) {
    const auto& free = loads_->free_supplies();
    supply.clear();
    volume_by_load_factor_.clear();
    const auto& motions = loads_->rate().motions;
    for (std::size_t k = 0; k < free.size(); ++k) {
        std::vector<double> by_motion(motions.size(), 0.0);
        const double volume = system.volumes().of_load(free[k], state.x, gradients_[k], by_motion);
        supply.push_back(loads_->equation(k, volume, state.pressures_Pa[k], state.load_factor));
        volume_by_load_factor_.push_back(std::inner_product(by_motion.begin(), by_motion.end(), motions.begin(), 0.0));
    }
    constraint = evaluate(target, system, *loads_, state, gradients_[free.size()]);
}

std::vector<double> BorderedSystem::rows_times(Vec x) const {
    std::vector<double> product;
    for (std::size_t k = 0; k < supply.size(); ++k)
        product.push_back(supply[k].by_volume * linalg::dot(gradients_[k], x));
    product.push_back(linalg::dot(gradients_[supply.size()], x));
    return product;
}

void BorderedSystem::subtract_rows(const std::vector<double>& factors, Vec by_x) const {
    for (std::size_t k = 0; k < supply.size(); ++k) linalg::add(by_x, -factors[k] * supply[k].by_volume, gradients_[k]);
    linalg::add(by_x, -factors[supply.size()], gradients_[supply.size()]);
}

void BorderedSystem::fill_border() {
    const int n = static_cast<int>(forces.size()), last = n - 1;
    by_loads = linalg::SmallMatrix(n);
    for (std::size_t k = 0; k < supply.size(); ++k) {
        const int row = static_cast<int>(k);
        by_loads.at(row, row) = supply[k].by_pressure;
        by_loads.at(row, last) = supply[k].by_load_factor + supply[k].by_volume * volume_by_load_factor_[k];
        by_loads.at(last, row) = constraint.by_pressures[k];
    }
    by_loads.at(last, last) = constraint.by_load_factor;
    border = by_loads;
    for (int j = 0; j < n; ++j) {
        const auto column = rows_times(columns[static_cast<std::size_t>(j)]);
        for (int i = 0; i < n; ++i) border.at(i, j) += column[static_cast<std::size_t>(i)];
    }
}

bool BorderedSystem::solve_columns(const SolveOne& solve) {
    columns_are_recent = false;
    for (std::size_t j = 0; j < forces.size(); ++j) {
        if (linalg::norm(forces[j].out) == 0.0) {  // the load factor changes only volumes or masses
            SOFT_PETSC(VecZeroEntries(columns[j]));
            continue;
        }
        if (!solve(forces[j].out, columns[j]).usable()) return false;
    }
    columns_are_recent = true;
    return true;
}

}  // namespace soft::solver
