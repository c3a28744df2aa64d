/// The parts of the bordered system at a state: residual, tangent, rows, columns.
#include <algorithm>
#include <numeric>

#include "fem/element_levels.hpp"
#include "solver/newton.hpp"

namespace soft::solver {

namespace {

model::SolverSettings with_choice(const fem::System& system, model::SolverSettings settings) {
    settings.linear = fem::choose_linear(settings.linear, system.input(), system.dofs().total);
    return settings;
}

}  // namespace

linalg::Symmetry symmetry_of(const fem::System& system) {
    return system.has_symmetric_tangent() ? linalg::Symmetry::symmetric : linalg::Symmetry::general;
}

Newton::Newton(fem::System& system, const model::SolverSettings& settings)
    : system_(system),
      settings_(with_choice(system, settings)),
      K_(system.make_matrix()),
      solver_(K_, symmetry_of(system), settings_.linear),
      R_(system.make_vector()),
      correction_(system.make_vector()) {
    const bool matrix_free = settings_.linear.method == model::LinearMethod::jacobian_free;
    fem::configure_preconditioner(solver_, system, K_);
    if (matrix_free || settings.tangent == model::TangentSource::finite_difference)
        differences_.emplace(system, K_, settings.tangent);
    if (matrix_free) solver_.set_operator(differences_->jacobian());
    if (settings.newton != model::NewtonMethod::bfgs) return;
    minus_R_before_ = system.make_vector();
    load_change_ = system.make_vector();
}

void Newton::set_loads(const StageLoads& loads) {
    loads_ = &loads;
    const std::size_t count = loads.free_supplies().size() + 1;
    for (auto* list : {&forces_, &columns_, &gradients_})
        while (list->size() < count) list->push_back(system_.make_vector());
    wanted_.clear();
    for (std::size_t k = 0; k + 1 < count; ++k) wanted_.push_back({loads.unit_pressure(k), forces_[k]});
    wanted_.push_back({loads.rate(), forces_[count - 1]});
    factor_is_recent_ = false;
    assembled_at_.reset();
    const auto& motions = loads.rate().motions;
    loads_move_ = std::ranges::any_of(motions, [](double rate) { return rate != 0.0; });
    if (rounding_N_ == 0.0)
        rounding_N_ = change_by_digits({system_.make_vector(), 0.0, {}}, fem::no_loads(system_.input()));
}

Mat Newton::matrix_for(Assemble what) {
    if (what == Assemble::tangent && (loads_move_ || settings_.tangent == model::TangentSource::exact)) return K_;
    if (!loads_move_) return nullptr;
    if (spare_ == nullptr) spare_ = system_.make_matrix();
    return spare_;
}

fem::Evaluation Newton::evaluate_at(const State& state, Assemble what) {
    const auto levels = loads_->levels(state.load_factor, state.pressures_Pa);
    const Mat matrix = matrix_for(what);
    const auto evaluation = system_.evaluate(state.x, levels, R_, matrix, wanted_);
    assembled_at_.reset();
    if (matrix == K_ && evaluation.admissible()) {
        assembled_at_ = copy_of(state);
    }
    return evaluation;
}

/// A finite-difference tangent evaluates the system at other states afterwards.
bool Newton::is_assembled_at(const State& state) const {
    if (!assembled_at_ || differences_ || state.load_factor != assembled_at_->load_factor ||
        state.pressures_Pa != assembled_at_->pressures_Pa)
        return false;
    PetscBool same = PETSC_FALSE;
    SOFT_PETSC(VecEqual(state.x, assembled_at_->x, &same));
    return same == PETSC_TRUE;
}

void Newton::differentiate(const State& state) {
    if (!differences_) return;
    const auto levels = loads_->levels(state.load_factor, state.pressures_Pa);
    differences_->set_base(state.x, levels, R_);
    if (settings_.tangent == model::TangentSource::finite_difference) differences_->tangent(state.x, levels, K_);
}

std::optional<NewtonEnd> Newton::linearize(const State& state) {
    differentiate(state);
    factor_ = solver_.factorize();
    factor_is_recent_ = factor_.succeeded;
    if (!factor_.succeeded) return factor_failure();
    return std::nullopt;
}

NewtonEnd Newton::factor_failure() const {
    if (solver_.is_krylov()) return NewtonEnd::linear_solver;
    return settings_.linear.method == model::LinearMethod::cholmod ? NewtonEnd::not_definite : NewtonEnd::singular;
}

/// With LinearMethod::automatic, a solve that still fails after a successful factorisation means a singular tangent.
NewtonEnd Newton::solve_failure() const {
    return settings_.linear.method == model::LinearMethod::automatic ? NewtonEnd::singular : NewtonEnd::linear_solver;
}

void Newton::evaluate_rows(const Constraint& constraint, const State& state) {
    const auto& free = loads_->free_supplies();
    supply_.clear();
    volume_by_load_factor_.clear();
    const auto& motions = loads_->rate().motions;
    for (std::size_t k = 0; k < free.size(); ++k) {
        std::vector<double> by_motion(motions.size(), 0.0);
        const double volume = system_.volumes().of_load(free[k], state.x, gradients_[k], by_motion);
        supply_.push_back(loads_->equation(k, volume, state.pressures_Pa[k], state.load_factor));
        volume_by_load_factor_.push_back(std::inner_product(by_motion.begin(), by_motion.end(), motions.begin(), 0.0));
    }
    constraint_ = evaluate(constraint, system_, *loads_, state, gradients_[free.size()]);
}

std::vector<double> Newton::rows_times(Vec x) const {
    std::vector<double> product;
    for (std::size_t k = 0; k < supply_.size(); ++k)
        product.push_back(supply_[k].by_volume * linalg::dot(gradients_[k], x));
    product.push_back(linalg::dot(gradients_[supply_.size()], x));
    return product;
}

void Newton::fill_border() {
    const int n = static_cast<int>(wanted_.size()), last = n - 1;
    border_ = linalg::SmallMatrix(n);
    for (int j = 0; j < n; ++j) {
        const auto column = rows_times(columns_[static_cast<std::size_t>(j)]);
        for (int i = 0; i < n; ++i) border_.at(i, j) = column[static_cast<std::size_t>(i)];
    }
    for (std::size_t k = 0; k < supply_.size(); ++k) {
        const int row = static_cast<int>(k);
        border_.at(row, row) += supply_[k].by_pressure;
        border_.at(row, last) += supply_[k].by_load_factor + supply_[k].by_volume * volume_by_load_factor_[k];
        border_.at(last, row) += constraint_.by_pressures[k];
    }
    border_.at(last, last) += constraint_.by_load_factor;
}

bool Newton::solve_columns(const SolveOne& solve) {
    for (std::size_t j = 0; j < wanted_.size(); ++j) {
        if (linalg::norm(wanted_[j].out) == 0.0) {  // the load factor changes only volumes or masses
            SOFT_PETSC(VecZeroEntries(columns_[j]));
            continue;
        }
        if (!solve(wanted_[j].out, columns_[j]).usable()) return false;
    }
    return true;
}

}  // namespace soft::solver
