#include "solver/sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

namespace {

/// Of the value of a parameter: the error of a one-sided difference is about 30 times this fraction of the derivative.
constexpr double small_change = 2e-6;
/// Corrections of a derivative at the moved states, and the relative correction after which none follows.
constexpr int max_passes = 4;
constexpr double accurate_pass = 1e-5;
/// Share of the largest energy by which softened rubber may be unloaded and still counts as loaded. Where a state returns, the moved states
/// return too: both branches have the same derivative, but rounding must not mix them. For the tangent, and for the systems between which a
/// derivative is a difference, over their relative change.
constexpr double loading_margin = 3e-5, margin_by_change = 20;
/// Of the value that a goal prescribes.
constexpr double goal_tolerance = 1e-6;
/// Of the displacements: the difference for the slope of a goal that has none.
constexpr double goal_difference = 1e-6;

Error singular(const std::string& what) {
    return {ExitCode::bad_input, "--sensitivity", what, "generate the case without sensitivities"};
}

/// The goal at which a row ends its stage; nullptr for other rows.
const Goal* reached_goal(const PathState& path, const PathPoint& point) {
    for (const Goal& goal : path.goals)
        if (std::abs(value_of(goal.constraint, point) - goal.target) <= goal_tolerance * std::abs(goal.target))
            return &goal;
    return nullptr;
}

/// A function of the corresponding numbers of two starts.
StageStart combine(StageStart a, const StageStart& b, const auto& function) {
    for (const auto list : {&StageStart::pressures_Pa, &StageStart::volumes_m3, &StageStart::masses_kg,
                            &StageStart::dead_loads, &StageStart::motions})
        std::ranges::transform(a.*list, b.*list, (a.*list).begin(), function);
    return a;
}

/// direction += factor x other
std::vector<double> quotient(const std::vector<double>& after, const std::vector<double>& before, double change) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < after.size(); ++i) slopes.push_back((after[i] - before[i]) / change);
    return slopes;
}

/// Leading load, outputs and stretch; angles continue from those of `point`.
std::vector<double> values_at(fem::System& system, const StageLoads& loads, const State& state, const PathPoint& point,
                              WithStretch stretch) {
    system.prescribe(loads.levels(state.load_factor, state.pressures_Pa));
    std::vector<double> values{leading_of(system.input(), loads, state)};
    for (std::size_t i = 0; i < point.outputs.size(); ++i) {
        const double value = system.outputs().value(i, state.x, nullptr);
        const bool wraps = model::is_angle(system.input().outputs[i].measure);
        values.push_back(wraps ? std::remainder(value - point.outputs[i], 2.0 * std::numbers::pi) : value);
    }
    if (stretch == WithStretch::yes) values.push_back(system.fields().stretches(state.x).p99);
    return values;
}

}  // namespace

/// One of the two systems between which a derivative is a difference.
struct Sensitivities::Side {
    double change = 0;  ///< of the value
    fem::System* system = nullptr;
    const StageLoads* loads = nullptr;
};

/// Residual and equations of the supplies.
struct Sensitivities::End {
    linalg::Vector R;
    std::vector<double> equations;
};

struct Sensitivities::Parameter {
    /// A system that is made when it is needed first.
    struct Varied {
        double change = 0;
        const model::Case* input = nullptr;
        std::optional<model::Case> without_contact = {};  ///< while nothing touches: saves the contact surface
        std::unique_ptr<fem::System> system = {};
        std::vector<double> undeformed_volumes_m3 = {};
        int stage = -1;
        std::optional<StageLoads> loads = {};
    };
    std::array<Varied, 2> varied;
    double margin = 0;                          ///< for loading, see loading_margin
    bool is_rough = false;                      ///< a difference to one side is not accurate enough
    bool moves_nodes_only = false;              ///< the forces of the cells depend on it by the nodes alone
    std::array<std::optional<State>, 2> moved;  ///< with internal variables, the states of both systems at the row
    StageStart start_slope = {};                ///< derivative of the start of the next stage

    [[nodiscard]] Side side(std::size_t which, const PathState& path, const PathPoint& point, const fem::System& base) {
        Varied& at = varied[which];
        if (!at.system || (at.without_contact && point.touches)) {
            at.system.reset();  // it refers to the case
            at.without_contact.reset();
            if (!point.touches && at.input->obstacles.empty() && base.internal().is_empty()) {
                at.without_contact = *at.input;
                at.without_contact->path.contact = model::Contact::ignore;
            }
            at.system = std::make_unique<fem::System>(at.without_contact ? *at.without_contact : *at.input, base.comm(),
                                                      base.dofs().cell_rank);
            at.system->internal().set_margin(margin);
            at.undeformed_volumes_m3 = solver::undeformed_volumes_m3(*at.system);
        }
        if (at.stage != path.stage) {
            at.stage = path.stage;
            at.loads.emplace(*at.input, at.stage,
                             at.stage == 0
                                 ? unloaded(*at.input, at.undeformed_volumes_m3)
                                 : combine(path.loads->start(), start_slope,
                                           [&](double start, double slope) { return start + at.change * slope; }),
                             at.undeformed_volumes_m3);
        }
        let_contact_rest(*at.system, point, point);
        return {at.change, at.system.get(), &*at.loads};
    }
};

Sensitivities::Sensitivities(const fem::System& base, std::span<const std::array<model::Case, 2>> variations,
                             WithStretch stretch)
    : base_(base), stretch_(stretch), shape_gradient_(base.discretization()) {
    may_use_adjoints_ = stretch == WithStretch::no && variations.size() > base.input().outputs.size() + 1 &&
                        fem::has_shape_gradient(base.discretization()) &&
                        std::ranges::none_of(base.input().outputs, [](const model::Output& output) {
                            return model::is_reaction(output.measure) && output.obstacle.empty();
                        });
    // A face that is moved acts through the cells, and by another distance if a parameter changes its motion or the start of a stage.
    const bool moves_a_face = !std::ranges::all_of(
        base.input().motions, [&](const model::Motion& motion) { return model::moves_obstacle(base.input(), motion); });
    // Where displacements alone carry a large bulk modulus, its parts of the derivative nearly cancel, and errors of second order do not.
    const bool is_stiff = base.input().formulation != model::Formulation::mixed;
    for (std::size_t i = 0; i < variations.size(); ++i) {
        const model::DesignParameter& of = base.input().parameters[i];
        parameters_.emplace_back();
        parameters_.back().varied[0] = {.change = of.lower - of.value, .input = &variations[i][0]};
        parameters_.back().is_rough = is_stiff || of.higher - of.value > small_change * std::abs(of.value);
        parameters_.back().moves_nodes_only =
            !moves_a_face && std::ranges::all_of(variations[i], [&](const model::Case& side) {
                return side.materials == base.input().materials;
            });
        parameters_.back().margin =
            margin_by_change * std::max(of.value - of.lower, of.higher - of.value) / std::abs(of.value);
        parameters_.back().varied[1] = {.change = of.higher - of.value, .input = &variations[i][1]};
    }
}

Sensitivities::~Sensitivities() = default;

Sensitivities::End Sensitivities::evaluate_at(Side& side, const State& state, Cells cells, Vec known) const {
    End end{linalg::duplicate(state.x), {}};
    const fem::LoadLevels levels = side.loads->levels(state.load_factor, state.pressures_Pa);
    if (known != nullptr)
        linalg::copy(known, end.R);
    else if (cells == Cells::yes)
        static_cast<void>(side.system->evaluate(state.x, levels, end.R, nullptr));
    else
        side.system->assembler().load_forces(state.x, levels, end.R);
    const auto& free = side.loads->free_supplies();
    for (std::size_t k = 0; k < free.size(); ++k) {
        const double volume = side.system->volumes().of_load(free[k], state.x, nullptr);
        end.equations.push_back(side.loads->equation(k, volume, state.pressures_Pa[k], state.load_factor).value);
    }
    return end;
}

PathTangent Sensitivities::direction_between(Newton& newton, const End& before, const End& after, double change) {
    linalg::add(before.R, -1.0, after.R);
    SOFT_PETSC(VecScale(before.R, 1.0 / change));  // -dR/dtheta
    auto direction = newton.bordered_solve(before.R, quotient(before.equations, after.equations, change));
    if (!direction) throw singular("the linear system of a derivative is not solved");
    return std::move(*direction);
}

std::vector<Sensitivities::Adjoint> Sensitivities::adjoints_at(Newton& newton, const PathState& path,
                                                               const PathPoint& point) {
    fem::System& system = newton.system();
    const StageLoads& loads = *path.loads;
    std::vector<Adjoint> adjoints;
    const linalg::Vector by_x = linalg::duplicate(point.state.x);
    const auto add = [&](std::vector<double> by_pressures, double by_load_factor) {
        by_pressures.push_back(by_load_factor);
        auto adjoint = newton.adjoint_solve(by_x, by_pressures);
        if (adjoint) adjoints.push_back({std::move(*adjoint), {}});
        return adjoint.has_value();
    };
    std::vector<double> leading;
    for (std::size_t k = 0; k < loads.free_supplies().size(); ++k)
        leading.push_back(leading_of(system.input(), loads.unit_pressure(k), 0.0));
    bool all = add(leading, leading_of(system.input(), loads.rate(), 1.0));
    for (std::size_t i = 0; i < point.outputs.size() && all; ++i) {
        const auto value =
            solver::evaluate({.kind = ConstraintKind::output, .index = i}, system, loads, point.state, by_x);
        all = add(value.by_pressures, value.by_load_factor);
    }
    if (!all) return {};
    if (std::ranges::none_of(parameters_, &Parameter::moves_nodes_only)) return adjoints;
    std::vector<Vec> psis;
    for (const Adjoint& adjoint : adjoints) psis.push_back(adjoint.of.psi);
    auto gradients = shape_gradient_.evaluate(point.state.x, point.levels, psis);
    for (std::size_t k = 0; k < adjoints.size(); ++k) adjoints[k].by_position = std::move(gradients[k]);
    return adjoints;
}

double Sensitivities::through_state(const Adjoint& adjoint, const Side& lower, const End& before, const Side& higher,
                                    const End& after, Cells cells) {
    double change = linalg::dot(adjoint.of.psi, after.R) - linalg::dot(adjoint.of.psi, before.R);
    for (std::size_t k = 0; k < adjoint.of.mu.size(); ++k)
        change += adjoint.of.mu[k] * (after.equations[k] - before.equations[k]);
    const auto &low = lower.system->input().mesh.points, &high = higher.system->input().mesh.points;
    for (std::size_t node = 0; node < low.size() && cells == Cells::no; ++node)
        change += dot(adjoint.by_position[node], difference(high[node], low[node]));
    return -change / (higher.change - lower.change);
}

void Sensitivities::correct_at_moved_states(Newton& newton, const State& state, Side& lower, Side& higher,
                                            PathTangent& direction) const {
    const double change = higher.change - lower.change;
    for (int pass = 0; pass < max_passes; ++pass) {
        const End before = evaluate_at(lower, moved(state, lower.change, direction)),
                  after = evaluate_at(higher, moved(state, higher.change, direction));
        const PathTangent missing = direction_between(newton, before, after, change);
        add(direction, 1.0, missing);
        if (linalg::norm(missing.x) <= accurate_pass * linalg::norm(direction.x)) return;
    }
}

PathPoint Sensitivities::moved_point(const Side& side, const PathPoint& point, const PathTangent& direction) {
    const std::size_t supplies = point.state.pressures_Pa.size();
    PathPoint at{moved(point.state, side.change, direction),
                 {linalg::duplicate(point.state.x), 0, std::vector(supplies, 0.0), {}, 0}};
    SOFT_PETSC(VecZeroEntries(at.tangent.x));
    read_values(*side.system, *side.loads, &point, at);
    return at;
}

double Sensitivities::slope_at(const Goal& goal, const PathPoint& point, const Side& base) {
    if (goal.has_slope) return slope_of(goal.constraint, point);
    Side before = base, after = base;
    after.change = goal_difference * linalg::norm(point.state.x) / linalg::norm(point.tangent.x);
    before.change = -after.change;
    return (value_of(goal.constraint, moved_point(after, point, point.tangent)) -
            value_of(goal.constraint, moved_point(before, point, point.tangent))) /
           (after.change - before.change);
}

void Sensitivities::move_to_goal(const Goal& goal, const PathPoint& point, const Side& base, const Side& lower,
                                 const Side& higher, PathTangent& direction) {
    const double by_parameter = (value_of(goal.constraint, moved_point(higher, point, direction)) -
                                 value_of(goal.constraint, moved_point(lower, point, direction))) /
                                (higher.change - lower.change);
    const double back = -by_parameter / slope_at(goal, point, base);
    add(direction, back, point.tangent);
}

void Sensitivities::evaluate(Corrector& corrector, const PathState& path, const PathPoint& point, model::Step& step) {
    if (!path.loads->changes() && !last_.empty()) {  // the same state again
        step.derivatives = last_;
        return;
    }
    const Corrector::Memory memory = corrector.memory();
    Newton& newton = corrector.newton();
    const auto& stages = corrector.input().path.stages;
    const bool in_time = stages[static_cast<std::size_t>(path.stage)].time_s.has_value(),
               stage_follows = path.stage + 1 < static_cast<int>(stages.size()),
               has_memory = !base_.internal().is_empty(), softens = base_.internal().soften();
    // Forces of contact are so stiff that a difference at a fixed state misses them.
    const bool measures_contact = std::ranges::any_of(
        corrector.input().outputs, [](const model::Output& output) { return !output.obstacle.empty(); });
    const Goal* goal = stage_follows || softens ? reached_goal(path, point) : nullptr;
    Constraint along{ConstraintKind::arc, 0, point.state.x, point.tangent.x};
    const bool is_at_rest = linalg::norm(point.tangent.x) == 0.0;  // an obstacle approaches, or has left
    if (in_time || model::holds_load(step) || is_at_rest) along = {};
    // A stage that loads softened rubber again may end where it ended before: beyond it the rubber is softer than before it.
    else if (softens && goal != nullptr && goal->has_slope)
        along = goal->constraint;
    const auto set_margin = [&](double share) {
        corrector.system().internal().set_margin(share);
        if (softens) newton.forget_assembly();
    };
    set_margin(loading_margin);
    if (!newton.tangent(along, point.state)) throw singular("the tangent of a row is singular");
    Side base{0, &corrector.system(), &*path.loads};
    const bool needs_states = !may_use_adjoints_ || point.touches || (goal != nullptr && stage_follows);
    const auto adjoints = needs_states ? std::vector<Adjoint>{} : adjoints_at(newton, path, point);
    std::array<std::optional<End>, 2> at_base;  // by Cells
    const auto end_at = [&](Side& side, Cells cells) {
        if (side.change != 0) return evaluate_at(side, point.state, cells);
        auto& end = at_base[static_cast<std::size_t>(cells)];
        if (!end)
            end =
                evaluate_at(side, point.state, cells, cells == Cells::yes && !has_memory ? newton.residual() : nullptr);
        return End{copy_of(end->R), end->equations};
    };
    for (Parameter& parameter : parameters_) {
        const bool to_higher = parameter.varied[1].change > 0;
        const bool is_central = point.touches || parameter.is_rough || !to_higher || has_memory;
        Side lower = is_central && parameter.varied[0].change < 0 ? parameter.side(0, path, point, base_) : base;
        Side higher = to_higher ? parameter.side(1, path, point, base_) : base;
        const double change = higher.change - lower.change;
        const Cells cells = adjoints.empty() || !parameter.moves_nodes_only ? Cells::yes : Cells::no;
        const End before = end_at(lower, cells), after = end_at(higher, cells);
        if (!adjoints.empty()) {
            const auto values = [&](const Side& side) {
                return values_at(*side.system, *side.loads, point.state, point, stretch_);
            };
            auto slopes = quotient(values(higher), values(lower), change);
            for (std::size_t k = 0; k < slopes.size(); ++k)
                slopes[k] += through_state(adjoints[k], lower, before, higher, after, cells);
            step.derivatives.insert(step.derivatives.end(), slopes.begin(), slopes.end());
            continue;
        }
        PathTangent moved_at = direction_between(newton, before, after, change);
        if (softens || (point.touches && measures_contact))
            correct_at_moved_states(newton, point.state, lower, higher, moved_at);
        const auto values = [&](const Side& side) {
            return values_at(*side.system, *side.loads, moved(point.state, side.change, moved_at), point, stretch_);
        };
        const auto slopes = quotient(values(higher), values(lower), change);
        step.derivatives.insert(step.derivatives.end(), slopes.begin(), slopes.end());
        if (goal != nullptr && stage_follows) {  // the next stage starts where the quantity of the goal keeps its value
            move_to_goal(*goal, point, base, lower, higher, moved_at);
            const auto start = [&](const Side& side) {
                return stage_start_at(side.system->input(), *side.loads, moved_point(side, point, moved_at));
            };
            parameter.start_slope = combine(start(higher), start(lower), [&](double after_it, double before_it) {
                return (after_it - before_it) / change;
            });
        }
        for (std::size_t which = 0; has_memory && which < parameter.varied.size(); ++which)
            if (parameter.varied[which].change != 0)
                parameter.moved[which] = moved(point.state, parameter.varied[which].change, moved_at);
    }
    last_ = step.derivatives;
    set_margin(0);
    corrector.system().prescribe(point.levels);
    corrector.restore(memory);
}

void Sensitivities::accept_step() {
    for (Parameter& parameter : parameters_)
        for (std::size_t which = 0; which < parameter.varied.size(); ++which) {
            const auto& state = parameter.moved[which];
            Parameter::Varied& varied = parameter.varied[which];
            if (!state) continue;
            varied.system->prescribe(varied.loads->levels(state->load_factor, state->pressures_Pa));
            varied.system->accept_step(state->x);
        }
}

}  // namespace soft::solver
