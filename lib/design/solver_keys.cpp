#include "design/solver_keys.hpp"

#include "design/setting.hpp"

namespace soft::design {
namespace {

using model::LinearMethod, model::LineSearch, model::NewtonMethod, model::Preconditioner, model::Predictor;
using model::StepRule, model::TangentSource;
using Linear = model::LinearSettings;
using Solver = model::SolverSettings;

constexpr Range tolerance{1e-14, 1e-2};

Settings<Solver> newton_settings() {
    return {
        number("residual_tolerance", &Solver::residual_tolerance, tolerance,
               "equilibrium is reached when the residual is below this share of the nodal forces"),
        choice("newton", &Solver::newton,
               {{"full", NewtonMethod::full}, {"modified", NewtonMethod::modified}, {"bfgs", NewtonMethod::bfgs}},
               "full: new tangent in every iteration; modified: in the first iteration of a step only; bfgs: that "
               "tangent with BFGS updates"),
        choice("line_search", &Solver::line_search,
               {{"backtracking", LineSearch::backtracking}, {"secant", LineSearch::secant}, {"none", LineSearch::none}},
               "step length along a correction: backtracking halves it until the residual decreases, secant finds "
               "the zero of the residual along it, none takes the full step"),
        choice("tangent", &Solver::tangent,
               {{"exact", TangentSource::exact}, {"finite-difference", TangentSource::finite_difference}},
               "exact derivatives, or differences of the residual"),
        count("newton_limit", &Solver::newton_limit, {1, 1000},
              "maximum number of Newton iterations before a step is cut"),
        flag("scaling", &Solver::scaling, "pressure unknowns are scaled to the size of displacements")};
}

Settings<Solver> linear_settings() {
    Settings<Solver> settings;
    const Settings<Linear> linear{
        choice("linear", &Linear::method,
               {{"auto", LinearMethod::automatic},
                {"mumps-ldlt", LinearMethod::mumps_ldlt},
                {"mumps-lu", LinearMethod::mumps_lu},
                {"superlu-dist", LinearMethod::superlu_dist},
                {"cholmod", LinearMethod::cholmod},
                {"krylov", LinearMethod::krylov},
                {"jacobian-free", LinearMethod::jacobian_free}},
               "solver of the linear systems; auto is LDL^T, mumps-lu where the tangent is not symmetric, and "
               "krylov with multigrid for compact solids of more than 500,000 unknowns"),
        choice("preconditioner", &Linear::preconditioner,
               {{"lu", Preconditioner::lu},
                {"asm-lu", Preconditioner::asm_lu},
                {"asm-ilu", Preconditioner::asm_ilu},
                {"asm-boomeramg", Preconditioner::asm_boomeramg},
                {"boomeramg", Preconditioner::boomeramg},
                {"gamg", Preconditioner::gamg},
                {"multigrid", Preconditioner::multigrid},
                {"jacobi", Preconditioner::jacobi},
                {"none", Preconditioner::none}},
               "preconditioner of krylov and jacobian-free; asm is additive Schwarz with one block per rank"),
        number("linear_tolerance", &Linear::tolerance, {1e-14, 0.5},
               "krylov and jacobian-free stop when the residual is below this share of the right-hand side"),
        count(
            "linear_limit", &Linear::iteration_limit, {1, 1e5},
            "maximum number of iterations of krylov and jacobian-free, which then return their best correction so far")};
    for (const Setting<Linear>& setting : linear) settings.push_back(inside(&Solver::linear, setting));
    settings.push_back(count("threads", &Solver::threads, {0, 256},
                             "threads of element loops and factorisations; 0: all cores, one on several ranks or in a "
                             "batch; the results do not depend on it"));
    return settings;
}

Settings<Solver> step_settings() {
    return {
        choice("steps", &Solver::steps,
               {{"error-adaptive", StepRule::error_adaptive},
                {"iteration-adaptive", StepRule::iteration_adaptive},
                {"constant", StepRule::constant}},
               "step-size control: by the predictor error, by the Newton iterations of the previous step, or "
               "constant (first_step)"),
        choice("predictor", &Solver::predictor,
               {{"cubic", Predictor::cubic}, {"tangent", Predictor::tangent}, {"none", Predictor::none}},
               "start of a step: on the cubic through the last two states, on the tangent at the last state, or at "
               "the last state"),
        number(
            "first_step", &Solver::first_step, share,
            "first step as a share of the full load; error-adaptive: up to 25 times as long where the path is smooth"),
        number("max_step", &Solver::max_step, {0, 1},
               "maximum step as a share of the path so far; 0: chosen by the solver"),
        number("min_step", &Solver::min_step, share,
               "a step cut below this share of the first step ends the path (of an arc length: a thousandth of it)"),
        count("wanted_iterations", &Solver::wanted_iterations, {1, 100},
              "target number of Newton iterations per step (iteration-adaptive)"),
        count("step_limit", &Solver::step_limit, {1, 1e6},
              "maximum number of steps; the path then ends with stop reason step_limit"),
        number("step_accuracy", &Solver::step_accuracy, share,
               "target relative error of the predictor (error-adaptive); a smaller value gives smaller steps")};
}

const Settings<Solver>& solver_settings() {
    static const Settings<Solver> settings = [] {
        Settings<Solver> all = newton_settings();
        for (const auto& part : {linear_settings(), step_settings()}) all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return settings;
}

}  // namespace

std::vector<Key> solver_keys() { return keys_of(solver_settings(), "solver"); }

model::SolverSettings solver_of(const Values& values) {
    const Solver solver = read_settings(solver_settings(), values, "solver");
    const bool krylov =
        solver.linear.method == LinearMethod::krylov || solver.linear.method == LinearMethod::jacobian_free;
    // The default value is accepted, because every effective design contains it.
    if (!krylov && solver.linear.preconditioner != Linear{}.preconditioner)
        throw values.refuse("solver.preconditioner",
                            "linear: " + values.text("solver.linear") + " takes no preconditioner",
                            "linear: krylov or jacobian-free, or leave it out");
    return solver;
}

}  // namespace soft::design
