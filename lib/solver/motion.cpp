#include "solver/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solver/motion_follower.hpp"

namespace soft::solver {

using model::Integrator;
using model::StopReason;

namespace {

/// Adaptive steps: the first step relative to the shortest change of the loads; the step after a kink relative to the one before it.
constexpr double first_share = 1e-3, share_after_kink = 0.1;
constexpr double growth_without_estimate = 2.0, max_step_growth = 2.0, min_step_factor = 0.3, rejection = 1.5;
/// The size of the motion is at least this fraction of the linear response.
constexpr double size_share = 0.1;
/// But where obstacles stop the body, which may fall freely before, at most the motion by this many contact distances.
constexpr double distances_in_size = 10;
/// And at least this fraction of the motion of an obstacle, which may reach the body late.
constexpr double size_share_of_obstacles = 0.01;
/// Steps of the starting method before generalised alpha (see the header): as many as its error estimate needs.
constexpr int steps_of_starter = 3;
/// Explicit steps relative to the stable step, which is estimated repeatedly because stretching stiffens the body: more often where it
/// has changed by more than `much_change` since the last estimate, less often where by less than `little_change`.
constexpr double stable_share = 0.9;
constexpr int first_steps_between_estimates = 4, max_steps_between_estimates = 50;
constexpr double much_change = 0.03, little_change = 0.01;
/// A user-selected step is kept up to this fraction of the stable one: a margin for stiffening before the next estimate.
constexpr double nearly_unstable = 0.97;
constexpr int explicit_step_limit = 1'000'000;
/// Times that differ by less than this fraction of a step are equal.
constexpr double same_time = 1e-6;

/// Calls `use` with the integrator in use.
template <class Method, class Use>
void with_method(Method& method, Use&& use) {
    std::visit(
        [&](auto& made) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(made)>, std::monostate>) use(made);
        },
        method);
}

}  // namespace

MotionFollower::MotionFollower(fem::System& system, const solver::Listeners& listeners)
    : system_(system),
      input_(system.input()),
      dynamics_(dynamics_of(input_)),
      settings_(input_.solver),
      listeners_(listeners),
      explicit_(is_explicit(dynamics_.integrator)),
      equations_(system, explicit_ ? MassKind::lumped : MassKind::consistent) {
    const auto& levels = input_.path.stages[0].motions;
    moves_obstacles_ = std::ranges::any_of(levels, [](double level) { return level != 0.0; });
}

model::PathEnd MotionFollower::run() {
    start();
    append();  // row 0 is the state at rest, also if the motion has already ended
    while (!finished_) advance();
    end_.factorizations = stage_ ? stage_->factorizations() : 0;
    return std::move(end_);
}

void MotionFollower::make_method() {
    switch (dynamics_.integrator) {
        case Integrator::generalized_alpha:
        case Integrator::hht:
        case Integrator::newmark: {
            const auto parameters = alpha_parameters(dynamics_.integrator, dynamics_.spectral_radius);
            error_constant_ = parameters.error_constant();
            method_.emplace<GeneralizedAlpha>(equations_, *stage_, parameters);
            break;
        }
        case Integrator::ark4:
            order_ = 3;
            method_.emplace<Dirk>(equations_, *stage_);
            break;
        case Integrator::implicit_euler:
            order_ = 1;
            error_constant_ = 0.5;
            method_.emplace<TsIntegrator>(equations_, &*stage_, dynamics_.integrator);
            break;
        case Integrator::rosenbrock: method_.emplace<TsIntegrator>(equations_, &*stage_, dynamics_.integrator); break;
        case Integrator::heun:
        case Integrator::explicit_euler:
            method_.emplace<TsIntegrator>(equations_, nullptr, dynamics_.integrator);
            break;
        case Integrator::central_difference: method_.emplace<CentralDifference>(equations_); break;
    }
}

void MotionFollower::start() {
    last_ = equations_.rest();
    next_ = copy_of(last_);
    if (explicit_)
        stable_.emplace(equations_, dynamics_.integrator);
    else
        stage_.emplace(equations_);
    make_method();
    is_free_of_stress_ = !system_.has_initial_stress();
    choose_first_step();
    if (explicit_)
        (void)explicit_acceleration(equations_, last_);
    else if (!start_acceleration(equations_, *stage_, step_s_, last_))
        throw Error(ExitCode::bad_input, "materials", "the body at rest has a singular mass and stiffness",
                    "check the densities and moduli of the materials");
    with_method(method_, [&](auto& method) { method.start(last_); });
    const bool at_once = linalg::norm(last_.load_force) > 0.0;
    if (std::holds_alternative<GeneralizedAlpha>(method_) && at_once && dynamics_.stiffness_damping_s > 0.0)
        starter_.emplace(equations_, *stage_);
}

void MotionFollower::choose_first_step() {
    const double duration = dynamics_.duration_s;
    const int intervals = std::max(dynamics_.rows - 1, 1);  // row 0 is one of them
    row_interval_s_ = duration / intervals;
    next_row_s_ = 0.0;
    kinks_ = model::kink_times(input_);
    if (is_constant()) {
        step_s_ = std::min(dynamics_.step_s, duration);
        row_interval_s_ = step_s_ * std::ceil(std::ceil(duration / step_s_ * (1.0 - same_time)) / intervals);
    } else {
        step_s_ = round_step_size(first_share * shortest_change_s(input_));
    }
    if (explicit_) {
        update_stable_step();
        if (is_constant() && step_s_ > stable_step_s_)
            throw Error(ExitCode::bad_input, "dynamics.step",
                        "an explicit step of " + short_text(step_s_) + " s exceeds the stable step of this body, " +
                            short_text(stable_step_s_) + " s",
                        "use at most " + short_text(stable_share * stable_step_s_) + " s, or remove the key");
    } else if (!is_constant()) {
        const double free = size_share * norm_of_linear_response(),
                     stopped = distances_in_size * norm_of_rigid_motion(system_.contact().distance_m());
        size_ = std::max(input_.obstacles.empty() || stopped == 0.0 ? free : std::min(free, stopped),
                         size_share_of_obstacles * norm_of_obstacle_motion());
    }
    first_step_s_ = step_s_;
}

/// Of (K0 + M / duration^2)^-1 f to all loads at their full level; 0 where it does not exist.
double MotionFollower::norm_of_linear_response() {
    const double duration = dynamics_.duration_s;
    if (!stage_->factorize(last_.x, fem::no_loads(input_), 0.0, 1.0 / (duration * duration))) return 0;
    (void)equations_.evaluate(last_.x, full_levels(input_), nullptr);
    const linalg::Vector force = copy_of(equations_.load_force()), response = linalg::duplicate(last_.x);
    std::vector<double> none;
    const bool is_solved =
        stage_->solve_linear(force, std::vector<LineRow>(equations_.lines().count()), response, none);
    return is_solved ? equations_.displacement_norm(response) : 0;
}

/// The norm of the displacements of a body that moves with the fastest obstacle.
double MotionFollower::norm_of_obstacle_motion() const {
    double largest_m = 0;
    for (std::size_t i = 0; i < input_.motions.size(); ++i) {
        double square = 0;
        for (const auto& component : input_.motions[i].displacement_m) square += std::pow(component.value_or(0.0), 2);
        largest_m = std::max(largest_m, std::abs(input_.path.stages[0].motions[i]) * std::sqrt(square));
    }
    return norm_of_rigid_motion(largest_m);
}

/// The norm of the displacements of a body that moves by this length.
double MotionFollower::norm_of_rigid_motion(double length_m) const {
    return length_m * linalg::norm(equations_.mask()) / std::sqrt(static_cast<double>(system_.dofs().dimension));
}

/// An automatic explicit step follows the stable step; a user-selected one is shortened where the body has become too stiff for it.
void MotionFollower::update_stable_step() {
    const double before_s = std::exchange(stable_step_s_, stable_->estimate(last_));
    if (!(stable_step_s_ > settings_.min_step * first_step_s_))  // also true for NaN
        return finish(
            StopReason::diverged,
            "the stable step has fallen to " + short_text(stable_step_s_) + " s at " + short_text(last_.time_s) +
                " s, from " + short_text(first_step_s_) +
                " s: the body stretches and stiffens without bound, or the explicit integration has become unstable");
    const double change = std::abs(stable_step_s_ - before_s) / stable_step_s_;
    if (rows_ == 0)
        between_estimates_ = first_steps_between_estimates;
    else if (change > much_change)
        between_estimates_ = std::max(between_estimates_ / 4, 1);
    else if (change < little_change)
        between_estimates_ = std::min(between_estimates_ * 2, max_steps_between_estimates);
    next_estimate_ = steps_ + between_estimates_;
    const double own = round_step_size(stable_share * stable_step_s_);
    const bool keeps = is_constant() && (rows_ == 0 || dynamics_.step_s <= nearly_unstable * stable_step_s_);
    if (is_constant() && !keeps && step_s_ == dynamics_.step_s)
        listeners_.report("the stable step has fallen to " + short_text(stable_step_s_) + " s: the step becomes " +
                          short_text(own) + " s");
    step_s_ = keeps ? std::min(dynamics_.step_s, dynamics_.duration_s) : own;
    if (rows_ == 0)
        listeners_.report("highest frequency " + short_text(stable_->frequency()) + " rad/s, stable step " +
                          short_text(stable_step_s_) + " s");
    const double steps = (dynamics_.duration_s - last_.time_s) / step_s_;
    if (steps_ == 0 && steps > explicit_step_limit)
        finish(StopReason::step_limit, "the motion needs " + short_text(steps) + " explicit steps of " +
                                           short_text(step_s_) + " s, more than a million; use an implicit integrator");
}

/// Where an obstacle moves: not so long that surfaces could pass through each other unseen.
double MotionFollower::limited_by_obstacles(double step_s) {
    const linalg::Vector ahead = linalg::duplicate(last_.x);
    SOFT_PETSC(VecWAXPY(ahead, step_s, last_.v, last_.x));
    const auto pressures = equations_.lines().pressures(last_.x, last_.masses_kg);
    return step_s * system_.contact().share_without_crossing(last_.x, levels_of(last_), ahead,
                                                             equations_.levels(last_.time_s + step_s, pressures));
}

double MotionFollower::next_step() {
    const double longest = longest_step();
    return moves_obstacles_ ? limited_by_obstacles(longest) : longest;
}

double MotionFollower::longest_step() const {
    double target = dynamics_.duration_s;
    const auto kink = std::ranges::upper_bound(kinks_, last_.time_s);
    if (!is_constant() && kink != kinks_.end()) target = std::min(target, *kink);
    const double left = target - last_.time_s;
    if (step_s_ * (1.0 + same_time) >= left) return left;
    return !is_constant() && 2.0 * step_s_ > left ? 0.5 * left : step_s_;
}

std::optional<StepResult> MotionFollower::attempt(double step_s) {
    StepResult result;
    if (starter_)
        result = starter_->attempt(last_, step_s, next_);
    else
        with_method(method_, [&](auto& method) { result = method.attempt(last_, step_s, next_); });
    iterations_since_row_ += result.newton.iterations;
    end_.newton_iterations += result.newton.iterations;
    if (result.newton.end == NewtonEnd::converged) return result;
    handle_failure(result.newton, step_s);
    return std::nullopt;
}

void MotionFollower::advance() {
    const int limit = explicit_ ? explicit_step_limit : settings_.step_limit;
    if (steps_ >= limit)
        return finish(StopReason::step_limit,
                      core::counted(limit, "step") + (limit == 1 ? " was" : " were") + " not enough" +
                          (explicit_ ? "; use an implicit integrator" : "; increase solver.step_limit"));
    const double h = next_step();
    const auto result = attempt(h);
    if (!result) return;
    const auto error = relative_error(*result, h);
    if (is_adaptive() && error && *error > rejection * dynamics_.accuracy) {
        listeners_.report("step of " + short_text(h) + " s has a relative error of " + short_text(*error) +
                          ": repeated with a shorter step");
        adapt(error, h);
        if (step_s_ < settings_.min_step * first_step_s_)
            finish(StopReason::diverged,
                   "no step meets dynamics.accuracy at " + short_text(last_.time_s) + " s; increase dynamics.accuracy");
        return;
    }
    if (!refuses_crossing(h)) accept(h, error);
}

void MotionFollower::accept(double step_s, std::optional<double> error) {
    if (!starter_) with_method(method_, [](auto& method) { method.accept(); });
    ++steps_;
    integrate_energies(last_, next_);
    if (is_adaptive() && error_constant_ > 0.0) {
        history_.push_front({last_.time_s, copy_of(last_.x)});
        if (history_.size() > static_cast<std::size_t>(order_)) history_.pop_back();
    }
    size_ = std::max(size_, equations_.displacement_norm(next_.x));
    std::swap(last_, next_);
    if (!system_.internal().is_empty() || system_.contact().has_friction()) {
        system_.prescribe(levels_of(last_));
        system_.accept_step(last_.x);
    }
    if (starter_ && steps_ == steps_of_starter) {
        starter_.reset();
        with_method(method_, [&](auto& method) { method.start(last_); });
    }
    if (std::abs(dynamics_.duration_s - last_.time_s) <= same_time * step_s) last_.time_s = dynamics_.duration_s;
    if (is_constant() && !explicit_) step_s_ = std::min(dynamics_.step_s, 2.0 * step_s_);
    if (explicit_ && steps_ >= next_estimate_) update_stable_step();
    if (is_adaptive()) adapt(error, step_s);
    bool at_a_kink = false;  // which interpolation needs to know
    for (const double kink : kinks_)
        if (std::abs(kink - last_.time_s) <= same_time * step_s) {
            at_a_kink = true;
            last_.time_s = kink;
            if (!is_constant()) step_s_ = round_step_size(share_after_kink * step_s_);
            history_.clear();  // a difference across a kink does not approximate a derivative
        }
    const bool ends = last_.time_s >= dynamics_.duration_s;
    if (ends || at_a_kink || last_.time_s >= next_row_s_ - same_time * row_interval_s_) append();
    if (finished_) return;
    for (const auto& until : input_.path.stages[0].until)
        if (until.quantity == "steps" && steps_ >= static_cast<int>(until.value)) {
            if (!ends && rows_ > 0 && last_row_->state.load_factor * dynamics_.duration_s < last_.time_s) append();
            if (!finished_) finish(StopReason::done, "number of steps reached");
            return;
        }
    if (ends && !finished_) finish(StopReason::done, "time of " + short_text(dynamics_.duration_s) + " s reached");
}

std::optional<double> MotionFollower::relative_error(const StepResult& result, double step_s) {
    if (!is_adaptive()) return std::nullopt;
    const double size = std::max(size_, equations_.displacement_norm(next_.x));
    if (result.error_m) return *result.error_m / size;
    if (error_constant_ == 0.0 || history_.size() < static_cast<std::size_t>(order_)) return std::nullopt;
    std::vector<std::pair<double, Vec>> positions{{next_.time_s, next_.x}, {last_.time_s, last_.x}};
    for (const auto& position : history_) positions.emplace_back(position.time_s, position.x);
    linalg::Vector difference = linalg::duplicate(next_.x);
    double factorial = 1;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < positions.size(); ++j)
            if (j != i) weight *= step_s / (positions[i].first - positions[j].first);
        linalg::add(difference, weight, positions[i].second);
        if (i > 0) factorial *= static_cast<double>(i);
    }
    return error_constant_ * factorial * equations_.displacement_norm(difference) / size;
}

void MotionFollower::adapt(std::optional<double> error, double step_s) {
    double factor = growth_without_estimate;
    if (error) {
        factor = 0.9 * std::pow(dynamics_.accuracy / std::max(*error, 1e-15), 1.0 / (order_ + 1));
        factor = std::clamp(factor, min_step_factor, max_step_growth);
    }
    step_s_ = round_step_size(factor * step_s);
    first_step_s_ = std::max(first_step_s_, step_s);
}

model::PathEnd integrate_motion(fem::System& system, const solver::Listeners& listeners) {
    return MotionFollower(system, listeners).run();
}

}  // namespace soft::solver
