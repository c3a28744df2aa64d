#include "design/solver_keys.hpp"

#include "core/text.hpp"
#include "design/words.hpp"

namespace soft::design {
namespace {

using model::LinearMethod, model::LineSearch, model::NewtonMethod, model::Preconditioner, model::Predictor;
using model::StepRule, model::TangentSource;

constexpr std::array newton_words{Word<NewtonMethod>{"full", NewtonMethod::full},
                                  Word<NewtonMethod>{"modified", NewtonMethod::modified},
                                  Word<NewtonMethod>{"bfgs", NewtonMethod::bfgs}};
constexpr std::array line_search_words{Word<LineSearch>{"backtracking", LineSearch::backtracking},
                                       Word<LineSearch>{"secant", LineSearch::secant},
                                       Word<LineSearch>{"none", LineSearch::none}};
constexpr std::array tangent_words{Word<TangentSource>{"exact", TangentSource::exact},
                                   Word<TangentSource>{"finite-difference", TangentSource::finite_difference}};
constexpr std::array linear_words{Word<LinearMethod>{"auto", LinearMethod::automatic},
                                  Word<LinearMethod>{"mumps-ldlt", LinearMethod::mumps_ldlt},
                                  Word<LinearMethod>{"mumps-lu", LinearMethod::mumps_lu},
                                  Word<LinearMethod>{"superlu-dist", LinearMethod::superlu_dist},
                                  Word<LinearMethod>{"cholmod", LinearMethod::cholmod},
                                  Word<LinearMethod>{"krylov", LinearMethod::krylov},
                                  Word<LinearMethod>{"jacobian-free", LinearMethod::jacobian_free}};
constexpr std::array preconditioner_words{Word<Preconditioner>{"lu", Preconditioner::lu},
                                          Word<Preconditioner>{"asm-lu", Preconditioner::asm_lu},
                                          Word<Preconditioner>{"asm-ilu", Preconditioner::asm_ilu},
                                          Word<Preconditioner>{"asm-boomeramg", Preconditioner::asm_boomeramg},
                                          Word<Preconditioner>{"boomeramg", Preconditioner::boomeramg},
                                          Word<Preconditioner>{"gamg", Preconditioner::gamg},
                                          Word<Preconditioner>{"multigrid", Preconditioner::multigrid},
                                          Word<Preconditioner>{"jacobi", Preconditioner::jacobi},
                                          Word<Preconditioner>{"none", Preconditioner::none}};
constexpr std::array step_words{Word<StepRule>{"error-adaptive", StepRule::error_adaptive},
                                Word<StepRule>{"iteration-adaptive", StepRule::iteration_adaptive},
                                Word<StepRule>{"constant", StepRule::constant}};
constexpr std::array predictor_words{Word<Predictor>{"cubic", Predictor::cubic},
                                     Word<Predictor>{"tangent", Predictor::tangent},
                                     Word<Predictor>{"none", Predictor::none}};

constexpr const char *linear_path = "solver.linear", *preconditioner_path = "solver.preconditioner";

template <class Enum, std::size_t count>
Key choice(std::string_view path, const std::array<Word<Enum>, count>& table, Enum fallback, std::string_view meaning) {
    return {.path = std::string{path},
            .kind = Kind::choice,
            .fallback = word_for(table, fallback),
            .meaning = std::string{meaning},
            .choices = words_of(table)};
}

Key number(std::string path, double fallback, std::string meaning, double min, double max) {
    return {.path = std::move(path),
            .kind = Kind::ratio,
            .fallback = core::number_text(fallback),
            .meaning = std::move(meaning),
            .min = min,
            .max = max};
}

/// A key for a number in (0, 1].
Key share(std::string path, double fallback, std::string meaning) {
    Key key = number(std::move(path), fallback, std::move(meaning), 0, 1);
    key.min_open = true;
    return key;
}

Key count(std::string path, int fallback, std::string meaning, double max) {
    return {.path = std::move(path),
            .kind = Kind::count,
            .fallback = std::to_string(fallback),
            .meaning = std::move(meaning),
            .min = 1,
            .max = max};
}

std::vector<Key> newton_keys(const model::SolverSettings& defaults) {
    return {
        number("solver.residual_tolerance", defaults.residual_tolerance,
               "equilibrium is reached when the residual is below this share of the nodal forces", 1e-14, 1e-2),
        choice(
            "solver.newton", newton_words, defaults.newton,
            "full: new tangent in every iteration; modified: in the first iteration of a step only; bfgs: that tangent with "
            "BFGS updates"),
        choice("solver.line_search", line_search_words, defaults.line_search,
               "step length along a correction: backtracking halves it until the residual decreases, secant finds "
               "the zero of the residual along it, none takes the full step"),
        choice("solver.tangent", tangent_words, defaults.tangent, "exact derivatives, or differences of the residual"),
        count("solver.newton_limit", defaults.newton_limit, "maximum number of Newton iterations before a step is cut",
              1000),
        {.path = "solver.scaling",
         .kind = Kind::flag,
         .fallback = defaults.scaling ? "true" : "false",
         .meaning = "pressure unknowns are scaled to the size of displacements"},
    };
}

std::vector<Key> linear_keys(const model::SolverSettings& defaults) {
    return {
        choice(
            linear_path, linear_words, defaults.linear.method,
            "solver of the linear systems; auto is mumps-ldlt, mumps-lu where the tangent is not symmetric, and krylov with "
            "multigrid for solids of more than 500,000 unknowns"),
        choice(preconditioner_path, preconditioner_words, defaults.linear.preconditioner,
               "preconditioner of krylov and jacobian-free; asm is additive Schwarz with one block per rank"),
        number("solver.linear_tolerance", defaults.linear.tolerance,
               "krylov and jacobian-free stop when the residual is below this share of the right-hand side", 1e-14,
               0.5),
        count(
            "solver.linear_limit", defaults.linear.iteration_limit,
            "maximum number of iterations of krylov and jacobian-free, which then return their best correction so far",
            1e5),
        count("solver.threads", defaults.threads,
              "threads per rank in the loops over the elements; the results do not depend on it", 256),
    };
}

std::vector<Key> step_keys(const model::SolverSettings& defaults) {
    return {
        choice(
            "solver.steps", step_words, defaults.steps,
            "step-size control: by the predictor error, by the Newton iterations of the previous step, or constant (first_step)"),
        choice(
            "solver.predictor", predictor_words, defaults.predictor,
            "start of a step: on the cubic through the last two states, on the tangent at the last state, or at the last state"),
        share("solver.first_step", defaults.first_step, "first step as a share of the full load"),
        number("solver.max_step", defaults.max_step,
               "maximum step as a share of the path so far; 0: chosen by the solver", 0, 1),
        share("solver.min_step", defaults.min_step,
              "a step cut below this share of the first step ends the path (of an arc length: a thousandth of it)"),
        count("solver.wanted_iterations", defaults.wanted_iterations,
              "target number of Newton iterations per step (iteration-adaptive)", 100),
        count("solver.step_limit", defaults.step_limit,
              "maximum number of steps; the path then ends with stop reason step_limit", 1e6),
        share("solver.step_accuracy", defaults.step_accuracy,
              "target relative error of the predictor (error-adaptive); a smaller value gives smaller steps"),
    };
}

}  // namespace

std::vector<Key> solver_keys() {
    const model::SolverSettings defaults;
    std::vector<Key> keys = newton_keys(defaults);
    for (auto part : {linear_keys(defaults), step_keys(defaults)}) keys.insert(keys.end(), part.begin(), part.end());
    return keys;
}

model::SolverSettings solver_of(const Values& values) {
    const auto meant = [&](const auto& table, const char* path) { return value_of_word(table, values.text(path)); };
    model::SolverSettings solver;
    solver.residual_tolerance = values.number("solver.residual_tolerance");
    solver.newton = meant(newton_words, "solver.newton");
    solver.line_search = meant(line_search_words, "solver.line_search");
    solver.tangent = meant(tangent_words, "solver.tangent");
    solver.newton_limit = values.count("solver.newton_limit");
    solver.linear.method = meant(linear_words, linear_path);
    const bool krylov =
        solver.linear.method == LinearMethod::krylov || solver.linear.method == LinearMethod::jacobian_free;
    const Preconditioner usual = solver.linear.preconditioner;
    solver.linear.preconditioner = meant(preconditioner_words, preconditioner_path);
    // The default value is accepted, because every effective design contains it.
    if (!krylov && solver.linear.preconditioner != usual)
        throw values.refuse(preconditioner_path, "linear: " + values.text(linear_path) + " takes no preconditioner",
                            "linear: krylov or jacobian-free, or leave it out");
    solver.linear.tolerance = values.number("solver.linear_tolerance");
    solver.linear.iteration_limit = values.count("solver.linear_limit");
    solver.scaling = values.text("solver.scaling") == "true";
    solver.threads = values.count("solver.threads");
    solver.steps = meant(step_words, "solver.steps");
    solver.predictor = meant(predictor_words, "solver.predictor");
    solver.first_step = values.number("solver.first_step");
    solver.max_step = values.number("solver.max_step");
    solver.min_step = values.number("solver.min_step");
    solver.wanted_iterations = values.count("solver.wanted_iterations");
    solver.step_limit = values.count("solver.step_limit");
    solver.step_accuracy = values.number("solver.step_accuracy");
    return solver;
}

}  // namespace soft::design
