#include "optimize/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "geometry/family.hpp"
#include "geometry/variations.hpp"
#include "mesh/cell_map.hpp"
#include "post/curve.hpp"
#include "post/interpolate.hpp"
#include "post/row_derivatives.hpp"
#include "solver/row_state.hpp"
#include "solver/sensitivities.hpp"

namespace soft::optimize {
namespace {

using Cases = std::vector<std::array<model::Case, 2>>;
constexpr const char* stretch = "stretch_p99";

double rubber_volume_m3(const model::Case& model) {
    return mesh::measure(model.mesh, geometry::measure_of(model)) / model.model_fraction;
}

/// Undeformed, of the first load.
double cavity_volume_m3(const model::Case& model) {
    fem::System system(model, PETSC_COMM_WORLD);
    return system.volumes().has_volume(0) ? solver::undeformed_volumes_m3(system)[0] : 0;
}

/// A solved trial.
struct Solved {
    model::Case model;
    Cases cases;                           ///< of the continuous variables
    std::vector<std::size_t> variable_of;  ///< [case] index of its variable
    std::vector<model::Step> steps;
    model::PathEnd end;
    post::Curve curve;

    [[nodiscard]] double change(std::size_t k) const { return model.parameters[k].higher - model.parameters[k].lower; }
};

/// The goal does not fit its designs, whatever the values of the variables.
class DoesNotFit : public Error {
public:
    DoesNotFit(const std::string& what, const std::string& problem, const std::string& remedy = {})
        : Error(ExitCode::bad_input, what, problem, remedy) {}
};

void check_unit(const std::string& text, core::Dimension dimension, const std::string& what) try {
    static_cast<void>(core::quantity_or_throw(text, dimension, ExitCode::bad_input, what));
} catch (const Error& error) {
    throw DoesNotFit("", error.what());
}

/// The column of a quantity of the curve, and the index of its derivative among those of a row: 0 load, 1 ... outputs, then the stretch;
/// nullopt for the time, which does not depend on the design.
struct Quantity {
    const post::Column* column;
    std::optional<std::size_t> index;
};
Quantity quantity_named(const Solved& solved, const std::string& name, const std::string& what) {
    const post::Column* column = solved.curve.find(name);
    const std::size_t outputs = solved.model.outputs.size();
    if (column != nullptr && column->source == post::Source::load) return {column, 0};
    if (column != nullptr && column->source == post::Source::output) return {column, 1 + column->index};
    if (column != nullptr && name == stretch) return {column, 1 + outputs};
    if (column != nullptr && column->source == post::Source::time) return {column, std::nullopt};
    std::vector<std::string> known{solved.curve.find(post::Source::load)->quantity};
    for (const model::Output& output : solved.model.outputs) known.push_back(output.name);
    known.emplace_back(stretch);
    throw DoesNotFit(what, core::quoted(name) + " is neither the load nor an output", core::did_you_mean(name, known));
}

double slope_of(const model::Step& step, std::size_t index) {
    return index == 0 ? step.tangent_pressure : step.tangent_outputs[index - 1];
}

/// A quantity along the path of a run, with its derivatives at fixed values of another quantity as further columns.
class QuantityOnCurve {
public:
    QuantityOnCurve(const Solved& solved, const Measure& measure) : solved_(solved), curve_(solved.curve) {
        const Quantity quantity = quantity_named(solved, measure.quantity, measure.text),
                       at = quantity_named(solved, measure.at, measure.text);
        if (!quantity.index) throw DoesNotFit(measure.text, "the time cannot be a target", "write it under `at`");
        if (at.index && *at.index > solved.model.outputs.size())
            throw DoesNotFit(measure.text, "`at` needs the load, an output or the time",
                             "write for example at: {pressure: 20 kPa}");
        if (!measure.at_text.empty())  // rows of data have no text of their own
            check_unit(measure.at_text, at.column->dimension, measure.text);
        shown_ = curve_.index_of(*curve_.find(measure.quantity));
        at_ = curve_.index_of(*curve_.find(measure.at));
        first_derivative_ = curve_.columns.size();
        const std::size_t quantities = solved.model.outputs.size() + 2;  // load, outputs, stretch
        for (std::size_t k = 0; k < solved.cases.size(); ++k) {
            post::Column& column = curve_.columns.emplace_back();
            column.jumps = at.index.has_value();
            const auto derivative = [&](std::size_t row) {
                const auto of_row = [&] { return &solved.steps[row].derivatives[k * quantities]; };
                if (!at.index) return of_row()[*quantity.index];
                // In a stage that does not change `at`: about the derivative at the start of the stage that does.
                while (row + 1 < solved.steps.size() && slope_of(solved.steps[row], *at.index) == 0) ++row;
                const double* D = of_row();
                return D[*quantity.index] - post::slope_ratio(*quantity.column, *at.column, row) * D[*at.index];
            };
            for (std::size_t row = 0; row < solved.steps.size(); ++row)
                column.values.push_back(post::with_derivatives(solved.steps, row, derivative));
        }
        path_.emplace(curve_);
    }
    QuantityOnCurve(const QuantityOnCurve&) = delete;
    QuantityOnCurve& operator=(const QuantityOnCurve&) = delete;

    /// Value and gradient where the path reaches the condition's value of `at`: first, for data where the value is nearest to the measured one,
    /// as in post/compare.hpp. Raises `last_row` to the row there.
    [[nodiscard]] Trial::Value value(const Measure& measure, std::optional<double> measured_SI, std::size_t variables,
                                     double& last_row) const {
        const post::Column& at = curve_.columns[at_];
        const auto crossings = path_->crossings(at_, path_->within_reach(at_, post::in_column_unit(at, measure.at_SI)));
        if (crossings.empty()) {
            const auto [lowest, highest] = path_->range(at_);
            const bool has_limit = at.source == post::Source::load && !solved_.end.limit_points.empty();
            throw Error(ExitCode::stopped_early, measure.text,
                        "the path reaches " + measure.at + " " + post::value_text(at, lowest) + " to " +
                            post::value_text(at, highest) + " (" + std::string{model::name(solved_.end.reason)} +
                            (has_limit ? ", past a limit point)" : ")"),
                        has_limit ? "ask for less than its limit load, or start nearer"
                                  : "request a larger load, or start nearer");
        }
        std::vector<double> row = path_->at(crossings.front());
        const double SI_per_unit = curve_.columns[shown_].SI_per_unit;
        const auto off = [&](const std::vector<double>& at_row) {
            return std::abs(at_row[shown_] * SI_per_unit - *measured_SI);
        };
        if (measured_SI)
            for (const double s : std::span(crossings).subspan(1))
                if (std::vector<double> other = path_->at(s); off(other) < off(row)) row = std::move(other);
        last_row = std::max(last_row, row[curve_.index_of(*curve_.find("step"))]);
        Trial::Value value{row[shown_] * SI_per_unit, std::vector<double>(variables)};
        for (std::size_t k = 0; k < solved_.cases.size(); ++k)
            value.gradient[solved_.variable_of[k]] = row[first_derivative_ + k];
        return value;
    }

private:
    const Solved& solved_;
    post::Curve curve_;
    std::size_t shown_ = 0, at_ = 0, first_derivative_ = 0;
    std::optional<post::Path> path_;
};

/// `enough_SI`: a path without limit point that reaches this load counts as having its limit beyond its largest load.
Trial::Value limit_of(const Solved& solved, const Measure& measure, double enough_SI, std::size_t variables) {
    const post::Column& load = *solved.curve.find(post::Source::load);
    if (measure.quantity != load.quantity) throw DoesNotFit(measure.text, "the load of the design is " + load.quantity);
    Trial::Value value{0, std::vector<double>(variables)};
    if (solved.end.limit_points.empty()) {
        for (const model::Step& step : solved.steps) value.value_SI = std::max(value.value_SI, step.pressure_Pa);
        if (value.value_SI >= enough_SI) return value;
        throw Error(ExitCode::stopped_early, measure.text,
                    "the path has none up to " + post::value_text(load, post::in_column_unit(load, value.value_SI)),
                    "request a larger load in the design");
    }
    const model::LimitPoint& point = solved.end.limit_points.front();
    value.value_SI = point.pressure_Pa;
    const model::Step& step = solved.steps[static_cast<std::size_t>(point.step)];
    const std::size_t quantities = solved.model.outputs.size() + 2;
    for (std::size_t k = 0; k < solved.cases.size(); ++k) {
        const double* D = &step.derivatives[k * quantities];
        value.gradient[solved.variable_of[k]] = D[0] - slope_of(step, 0) / slope_of(step, 1) * D[1];
    }
    return value;
}

Trial::Value volume_of(const Solved& solved, double (*volume)(const model::Case&), std::size_t variables) {
    Trial::Value value{volume(solved.model), std::vector<double>(variables)};
    for (std::size_t k = 0; k < solved.cases.size(); ++k)
        value.gradient[solved.variable_of[k]] =
            (volume(solved.cases[k][1]) - volume(solved.cases[k][0])) / solved.change(k);
    return value;
}

Trial::Value sum_of_keys(const design::Design& design, const Goal& goal, const Measure& measure) {
    Trial::Value value{0, std::vector<double>(goal.variables.size())};
    for (const Measure::Term& term : measure.terms) {
        if (!design.values.has(term.key))
            throw DoesNotFit(measure.text, core::quoted(term.key) + " is not a key of the design");
        value.value_SI += term.factor * design.values.number(term.key);
        for (std::size_t i = 0; i < goal.variables.size(); ++i)
            if (goal.variables[i].key == term.key && !goal.variables[i].is_whole) value.gradient[i] += term.factor;
    }
    return value;
}

/// The path ends where its last value is taken, if all are given at values of one quantity that `path.until` knows.
std::optional<design::Override> end_of_path(std::span<const Measure* const> measures, const design::Design& design) {
    const Measure* last = nullptr;
    for (const Measure* measure : measures) {
        if (measure->kind == Measure::Kind::limit) return std::nullopt;
        if (measure->kind != Measure::Kind::curve) continue;
        if (last != nullptr && last->at != measure->at) return std::nullopt;
        if (last == nullptr || std::abs(measure->at_SI) > std::abs(last->at_SI)) last = measure;
    }
    if (last == nullptr || design.path.stages.size() != 1 || design.path.stages.front().time_s) return std::nullopt;
    const bool is_output =
        std::ranges::find(design.outputs, last->at, &design::Design::OutputRequest::name) != design.outputs.end();
    const bool is_pressure = last->at == "pressure" && !design.loads.empty();
    if (!is_output && !is_pressure) return std::nullopt;
    if (is_pressure) check_unit(last->at_text, core::Dimension::pressure, last->text);
    return design::Override{"path.until." + last->at, last->at_text, {}};
}

/// Whether the rows of a measured curve return to values of `at` that they have passed, as beyond a limit point.
bool data_turn_back(const Goal& goal, std::size_t run) {
    const Condition* before = nullptr;
    for (const Condition& row : goal.conditions) {
        if (!row.curve || row.measure.run != run) continue;
        const bool continues = before != nullptr && before->curve == row.curve && before->line < row.line;
        if (continues && std::abs(row.measure.at_SI) < std::abs(before->measure.at_SI)) return true;
        before = &row;
    }
    return false;
}

Solved solve(const Goal& goal, const Run& run, const design::Design& design, const Base& base,
             const MakeContactCheck& contact_check) {
    geometry::Built built = geometry::build_with_figures(design);
    std::vector<std::string> keys;
    Solved solved;
    for (const std::size_t i : run.variables)
        if (!goal.variables[i].is_whole) {
            keys.push_back(goal.variables[i].key);
            solved.variable_of.push_back(i);
        }
    const geometry::Variations varied = geometry::make_variations(design, built, keys, base.source);
    for (const model::Variation& variation : varied.variations) {
        const auto rebuild = [&](const model::Variation::Side& side) {
            mesh::Mesh moved = built.model.mesh;
            moved.points = side.points;
            return geometry::rebuild_case(std::move(moved), side.shape, side.effective_yaml, base.source);
        };
        solved.cases.push_back({rebuild(variation.lower), rebuild(variation.higher)});
        built.model.parameters.push_back(variation.parameter);
    }
    solved.model = std::move(built.model);
    fem::System system(solved.model, PETSC_COMM_WORLD);
    solver::Sensitivities sensitivities(system, solved.cases, solver::WithStretch::yes);
    solver::Listeners listeners{.step = [&](const model::Step& step, Vec) { solved.steps.push_back(step); },
                                .contact = contact_check(system)};
    solved.end = solver::follow_path(system, listeners, nullptr, &sensitivities);
    solved.curve = post::make_curve(solved.model, solved.steps, solved.end);
    return solved;
}

/// Adds the values of the measures that belong to one run to the trial.
void add_run(const Goal& goal, std::size_t index, const Base& base, const std::vector<double>& values,
             const MakeContactCheck& contact_check, Trial& trial) {
    const Run& run = goal.runs[index];
    std::vector<const Measure*> measures;
    for (const Condition& condition : goal.conditions)
        if (condition.measure.run == index) measures.push_back(&condition.measure);
    if (goal.minimize && index == 0) measures.push_back(&*goal.minimize);
    const bool needs_path = goal.stable && index == 0;
    if (measures.empty() && !needs_path) return;

    std::vector<design::Override> overrides = run.set;
    for (const std::size_t i : run.variables)
        overrides.push_back(
            {goal.variables[i].key, goal.variables[i].text_of(values[i]), "vary." + goal.variables[i].key});
    const auto read = [&] {
        return design::read_design(base.text, base.source, geometry::catalogue_keys(), overrides);
    };
    design::Design design = read();
    if (const auto end = end_of_path(measures, design); end && !data_turn_back(goal, index)) {
        overrides.push_back(*end);
        design = read();
    }
    std::optional<Solved> path;
    if (needs_path) path.emplace(solve(goal, run, design, base, contact_check));
    std::map<std::pair<std::string, std::string>, QuantityOnCurve> quantities;
    double last_row = -1;  // at which a value of the curve is taken
    const auto measured = [&](const Measure& measure, double enough_SI, std::optional<double> measured_SI) {
        const std::size_t count = goal.variables.size();
        if (measure.kind == Measure::Kind::keys) return sum_of_keys(design, goal, measure);
        if (!path) path.emplace(solve(goal, run, design, base, contact_check));
        if (measure.kind == Measure::Kind::limit) return limit_of(*path, measure, enough_SI, count);
        if (measure.kind == Measure::Kind::rubber_volume) return volume_of(*path, rubber_volume_m3, count);
        if (measure.kind == Measure::Kind::cavity_volume) return volume_of(*path, cavity_volume_m3, count);
        const auto [quantity, is_new] = quantities.try_emplace(std::pair(measure.quantity, measure.at), *path, measure);
        return quantity->second.value(measure, measured_SI, count, last_row);
    };
    constexpr double never = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        const Condition& condition = goal.conditions[i];
        if (condition.measure.run != index) continue;
        trial.conditions[i] =
            measured(condition.measure, condition.relation == Condition::Relation::above ? condition.value_SI : never,
                     condition.is_data ? std::optional(condition.value_SI) : std::nullopt);
        for (const Measure::Term& term : condition.measure.terms) {
            const auto number = std::ranges::find(design.parameters, term.key, &model::DesignParameter::key);
            if (number == design.parameters.end()) continue;  // zero, or a count
            check_unit(condition.value_text, core::dimension_of(number->unit).value_or(core::Dimension::ratio),
                       term.key);
        }
        const Measure::Kind kind = condition.measure.kind;
        const bool is_of_path = kind == Measure::Kind::curve || kind == Measure::Kind::limit;
        if (is_of_path && !condition.curve)  // that of a file has been read in the unit of its column
            check_unit(condition.value_text, path->curve.find(condition.measure.quantity)->dimension,
                       condition.measure.text);
    }
    if (goal.minimize && index == 0) {
        trial.objective = measured(*goal.minimize, never, std::nullopt);
        if (goal.minimize->kind == Measure::Kind::curve) {
            const post::Column& column = *path->curve.find(goal.minimize->quantity);
            trial.objective_text = post::value_text(column, post::in_column_unit(column, trial.objective.value_SI), 5);
        } else {
            trial.objective_text = core::quantity_text(trial.objective.value_SI, core::Dimension::volume);
        }
    }
    if (!needs_path) return;
    for (std::size_t row = 0; row < path->steps.size(); ++row)
        if (last_row < 0 || static_cast<double>(row) < std::ceil(last_row) + 1)
            trial.is_stable = trial.is_stable && path->steps[row].stable;
}

}  // namespace

Trial evaluate(const Goal& goal, std::span<const Base> bases, const std::vector<double>& values,
               const MakeContactCheck& contact_check) {
    Trial trial;
    trial.conditions.resize(goal.conditions.size());
    try {
        for (std::size_t run = 0; run < goal.runs.size(); ++run)
            add_run(goal, run, bases[run], values, contact_check, trial);
    } catch (const DoesNotFit&) {
        throw;
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input && error.code() != ExitCode::stopped_early) throw;
        trial.failure = error.what();
    }
    return trial;
}

}  // namespace soft::optimize
