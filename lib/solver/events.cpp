#include <algorithm>
#include <cmath>

#include "solver/path_follower.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

/// A limit point is located until its load is known to this relative accuracy (estimated from the slope's parabola).
constexpr double limit_point_tolerance = 1e-8;
constexpr int limit_point_solves = 12;
/// A bifurcation is located until the load changes by less than this fraction of itself over the bracket.
constexpr double bifurcation_tolerance = 1e-6;
constexpr int bifurcation_solves = 30;
/// Inverse iterations for the mode: the eigenvalue that passes through zero is by far the smallest there.
constexpr int mode_iterations = 3;
/// Fractions of the step: distance before and after a bifurcation at which its eigenvalue is checked.
constexpr double beside_bifurcation = 0.05, min_beside = 1e-6;
/// Smallest cosine between the mode at the bifurcation and on either side.
constexpr double same_mode = 0.9;
/// Fraction of the distance between the rows on both sides: states farther apart than this belong to two branches.
constexpr double apart = 0.05;
/// The step in which contact occurs is halved this many times.
constexpr int contact_halvings = 8;

double leading_slope(const PathPoint& point, std::size_t) { return point.leading_slope; }
double volume_slope(const PathPoint& point, std::size_t load) { return point.load_volume_slopes[load]; }
double output_slope(const PathPoint& point, std::size_t output) { return point.output_slopes[output]; }
double load_factor_slope(const PathPoint& point, std::size_t) { return point.tangent.load_factor; }

/// A vector without any symmetry, the same in every run and on any number of ranks.
linalg::Vector generic_vector(const fem::System& system) {
    auto b = system.make_vector();
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i) {
        const double phase = 0.618033988749895 * static_cast<double>(i + 1);
        SOFT_PETSC(VecSetValue(b, i, 2.0 * (phase - std::floor(phase)) - 1.0, INSERT_VALUES));
    }
    SOFT_PETSC(VecAssemblyBegin(b));
    SOFT_PETSC(VecAssemblyEnd(b));
    return b;
}

/// A position on the path and the value of a function there.
struct Sample {
    double q, value;
};

/// The next trial position for the zero between two samples of opposite sign: the secant's root, moved towards the farther end by as
/// much as the root has moved since the last one, so that the bracket closes from both sides. `last` is the previous root.
double next_between(const Sample& a, const Sample& b, std::optional<double>& last) {
    const double root = a.q + (b.q - a.q) * a.value / (a.value - b.value);
    const double moved = last ? std::abs(root - *last) : 0.0;
    last = root;
    const double toward_farther = std::abs(root - a.q) > std::abs(b.q - root) ? a.q - root : b.q - root;
    return root + std::clamp(moved / std::abs(toward_farther), 0.0, 0.5) * toward_farther;
}

}  // namespace

/// Bisects the step between the last row and `point` down to the last state without contact.
std::optional<ContactEvent> PathFollower::find_contact(PathPoint& point) {
    if (!listeners_.contact || input_.path.contact == model::Contact::ignore) return std::nullopt;
    const auto contact_at = [&](const PathPoint& at) {
        system_.prescribe(loads_->levels(at.state.load_factor, at.state.pressures_Pa));
        return listeners_.contact(at.state.x);
    };
    auto touching = contact_at(point);
    if (!touching) return std::nullopt;
    log("contact before row " + std::to_string(rows_) + ": locating its onset");
    double free_q = last_->q, touching_q = point.q;
    std::optional<PathPoint> free;
    for (int i = 0; i < contact_halvings; ++i) {
        const double q = 0.5 * (free_q + touching_q);
        auto middle = solve_between(*last_, point, q);
        if (!middle) break;
        if (auto touch = contact_at(*middle)) {
            touching = std::move(touch);
            touching_q = q;
        } else {
            free = std::move(middle);
            free_q = q;
        }
    }
    if (free) point = std::move(*free);
    return touching;
}

/// This number changes with each eigenvalue that passes through zero between two points without a limit point of the load.
std::optional<int> PathFollower::branch_index(const PathPoint& point) const {
    if (!point.tangent.unstable_modes) return std::nullopt;
    return *point.tangent.unstable_modes - (load_falls(point) ? 1 : 0);
}

bool PathFollower::pass_events(const PathPoint& from, const PathPoint& to) {
    std::vector<Event> events;
    std::string ends;  // why the user-selected control cannot continue
    const auto watch = [&](double (*slope)(const PathPoint&, std::size_t), std::size_t index) -> PathPoint* {
        if (slope(from, index) * slope(to, index) >= 0.0) return nullptr;
        auto point = locate_extremum(from, to, slope, index);
        if (!point) return nullptr;  // not located: only the rows show the sign change
        events.push_back({std::move(*point), slope == leading_slope, 0, std::nullopt});
        return &events.back().point;
    };
    // Where the load changes by less than the tolerance of a limit point, a change of sign is rounding: the path hardly moves.
    const double change = std::abs(to.leading - from.leading),
                 size = std::max(std::abs(to.leading), std::abs(from.leading));
    if (chosen_ || change > limit_point_tolerance * size) (void)watch(leading_slope, 0);
    if (chosen_) {
        const bool loads = chosen_->kind == ConstraintKind::load_factor;
        const auto slope = loads                                     ? load_factor_slope
                           : chosen_->kind == ConstraintKind::volume ? volume_slope
                                                                     : output_slope;
        const bool same = loads && model::leading_load(input_) == model::LeadingLoad::pressure &&
                          loads_->rate().pressures_Pa[0] != 0.0;
        if (same ? !events.empty() : watch(slope, chosen_->index) != nullptr)
            ends = (loads ? std::string("the load") : "the " + std::string(name(chosen_->kind))) + " has a " +
                   (slope(from, chosen_->index) * (step_ < 0.0 ? -1.0 : 1.0) < 0.0 ? "minimum" : "maximum");
    }
    const auto before = branch_index(from), after = branch_index(to);
    if (before && after && *before != *after)
        if (auto event = locate_bifurcation(from, to)) {
            event->modes = std::abs(*after - *before);
            events.push_back(std::move(*event));
        }
    const double sense = step_ < 0.0 ? -1.0 : 1.0;
    std::ranges::stable_sort(events,
                             [&](const Event& a, const Event& b) { return sense * a.point.q < sense * b.point.q; });
    for (auto& event : events) {
        if (event.modes > 0) {
            model::Bifurcation bifurcation{location_of(event.point), event.modes, {}};
            if (event.mode) {
                system_.prescribe(fem::no_loads(input_));
                bifurcation.mode = system_.gather_fields(*event.mode).displacement_m;
            }
            end_.bifurcations.push_back(std::move(bifurcation));
            append(event.point);
            if (take_branch(event)) return true;
            continue;
        }
        if (event.is_limit_point) end_.limit_points.push_back(location_of(event.point));
        append(event.point);
        if (ends.empty()) continue;
        finish(StopReason::limit_point,
               ends + " at " + describe(event.point) +
                   ": no equilibrium exists beyond it under this control; use path.control: auto to continue");
        return true;
    }
    return false;
}

std::optional<PathPoint> PathFollower::locate_extremum(const PathPoint& from, const PathPoint& to,
                                                       double (*slope_of)(const PathPoint&, std::size_t),
                                                       std::size_t index) {
    std::optional<PathPoint> left, right;
    for (int solve = 0; solve < limit_point_solves; ++solve) {
        const PathPoint& a = left ? *left : from;
        const PathPoint& b = right ? *right : to;
        // Zero of the slope by the secant through both ends, kept away from both ends.
        const double span = b.q - a.q;
        const double share = std::clamp(slope_of(a, index) / (slope_of(a, index) - slope_of(b, index)), 0.02, 0.98);
        auto point = solve_between(a, b, a.q + share * span);
        if (!point) return std::nullopt;
        const double curvature = (slope_of(b, index) - slope_of(a, index)) / span, slope = slope_of(*point, index);
        const double gain = std::abs(slope_of(from, index) * (to.q - from.q));  // the scale of the quantity itself
        const double size = std::max(slope_of == leading_slope ? std::abs(point->leading) : 0.0, gain);
        const bool located = slope * slope <= 2.0 * limit_point_tolerance * std::abs(curvature) * size;
        if (located || solve + 1 == limit_point_solves) return point;
        (slope * slope_of(from, index) > 0.0 ? left : right) = std::move(point);
    }
    return std::nullopt;
}

/// Why a change of the count of negative pivots between `left` and `right`, on the step from `from` to `to`, is no bifurcation: a
/// count also changes by rounding, and where the corrector has converged to another branch. Empty where the eigenvalue of
/// the mode has opposite signs on both sides.
std::string PathFollower::check_bifurcation(const PathPoint& from, const PathPoint& to, const PathPoint& left,
                                            const PathPoint& right, const std::optional<linalg::Vector>& mode) {
    const auto distance = [&](const PathPoint& a, const PathPoint& b) {
        linalg::copy(b.state.x, scratch_);
        linalg::add(scratch_, -1.0, a.state.x);
        return linalg::norm(scratch_);
    };
    if (distance(left, right) > apart * distance(from, to)) return "the states on both sides belong to two branches";
    if (!mode) return "no mode is found";
    const double span = to.q - from.q, at = 0.5 * (left.q + right.q);
    std::optional<double> before;
    for (const double side : {-1.0, 1.0}) {
        const double distance_to_end = std::abs(side < 0.0 ? at - from.q : to.q - at);
        const double away = std::min(beside_bifurcation * std::abs(span), 0.5 * distance_to_end);
        // A change arbitrarily close to a row means that the count at the row itself is different.
        if (away < min_beside * std::abs(span)) return "only at a row itself, where no eigenvalue passes through zero";
        const auto point = solve_between(from, to, at + side * std::copysign(away, span));
        linalg::Vector b = linalg::duplicate(*mode);
        linalg::copy(*mode, b);
        std::optional<double> eigenvalue;
        for (int i = 0; point && i < 2 * mode_iterations; ++i) {
            auto v = newton_.bordered_solve(b);
            if (!v) break;
            eigenvalue = 1.0 / linalg::dot(b, *v);
            SOFT_PETSC(VecScale(*v, 1.0 / linalg::norm(*v)));
            b = std::move(*v);
        }
        if (!eigenvalue || std::abs(linalg::dot(b, *mode)) < same_mode)
            return "the smallest eigenvalue has another mode there";
        if (before && *before * *eigenvalue > 0.0) return "no eigenvalue passes through zero";
        before = eigenvalue;
    }
    return {};
}

/// Brackets the change of branch_index by bisection on its count. The secant on 1 / (b . M^-1 b), which vanishes with the
/// eigenvalue (Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.3), shortens the bracket as
/// soon as b is close to the mode.
std::optional<Event> PathFollower::locate_bifurcation(const PathPoint& from, const PathPoint& to) {
    const int index = *branch_index(from);
    std::optional<PathPoint> left, right;
    std::optional<double> left_test, right_test;
    linalg::Vector b = generic_vector(system_);
    SOFT_PETSC(VecScale(b, 1.0 / linalg::norm(b)));
    std::optional<linalg::Vector> mode;
    std::optional<double> root;
    for (int solve = 0; solve < bifurcation_solves; ++solve) {
        const PathPoint& a = left ? *left : from;
        const PathPoint& c = right ? *right : to;
        const double q = left_test && right_test && *left_test * *right_test < 0.0
                             ? next_between({a.q, *left_test}, {c.q, *right_test}, root)
                             : 0.5 * (a.q + c.q);
        auto point = solve_between(a, c, q);
        if (!point) break;
        const auto here = branch_index(*point);
        if (!here) break;
        std::optional<double> test;
        for (int i = 0; i < mode_iterations; ++i) {
            auto v = newton_.bordered_solve(b);
            if (!v) break;
            test = 1.0 / linalg::dot(b, *v);
            SOFT_PETSC(VecScale(*v, 1.0 / linalg::norm(*v)));
            if (linalg::dot(*v, b) < 0.0) SOFT_PETSC(VecScale(*v, -1.0));
            if (i + 1 < mode_iterations || solve == 0) linalg::copy(*v, b);
            mode = std::move(*v);
        }
        const bool before = *here == index;
        (before ? left : right) = std::move(point);
        (before ? left_test : right_test) = test;
        if (!left || !right) continue;
        const double change = std::abs(right->leading - left->leading) +
                              std::abs(right->state.load_factor - left->state.load_factor) * std::abs(left->leading);
        if (change <= bifurcation_tolerance * std::max(std::abs(left->leading), std::abs(right->leading))) break;
    }
    if (!left && !right) return std::nullopt;
    const std::string objection = check_bifurcation(from, to, left ? *left : from, right ? *right : to, mode);
    if (!objection.empty()) {
        log("the count of negative pivots changes before row " + std::to_string(rows_) + ", but " + objection +
            ": no bifurcation");
        return std::nullopt;
    }
    Event event{std::move(left ? *left : *right), false, 1, std::move(mode)};
    if (event.mode) {  // largest displacement 1; the sign does not depend on the number of ranks
        system_.prescribe(fem::no_loads(input_));
        const auto u = system_.gather_fields(*event.mode).displacement_m;
        double factor = 0;
        for (const double component : u) factor = std::max(factor, std::abs(component));
        const auto first =
            std::ranges::find_if(u, [&](double component) { return std::abs(component) > 0.5 * factor; });
        if (first != u.end() && *first < 0.0) factor = -factor;
        MPI_Bcast(&factor, 1, MPI_DOUBLE, 0, system_.comm());
        if (factor != 0.0) SOFT_PETSC(VecScale(*event.mode, 1.0 / factor));
    }
    return event;
}

/// Perturbs the state along the mode, with largest displacement `imperfection`, then re-equilibrates at this arc length: a point of
/// the branch, from which the path continues.
bool PathFollower::take_branch(const Event& event) {
    if (input_.path.branch != model::Branch::follow || on_branch_ || !event.mode) return false;
    const double length = linalg::norm(*event.mode);
    const auto saved_control = control_;
    auto saved_last = std::move(last_);
    auto saved_before = std::move(before_);
    const double saved_step = step_;
    PathPoint origin;
    origin.state = {linalg::duplicate(event.point.state.x), event.point.state.load_factor,
                    event.point.state.pressures_Pa};
    linalg::copy(event.point.state.x, origin.state.x);
    origin.tangent.x = linalg::duplicate(*event.mode);
    linalg::add(origin.tangent.x, 1.0 / length, *event.mode);
    origin.outputs = event.point.outputs;
    origin.levels = event.point.levels;
    origin.level_slopes = fem::no_loads(input_);
    origin.load_work_J = event.point.load_work_J;
    control_ = {ConstraintKind::arc};
    last_ = std::move(origin);
    before_.reset();
    step_ = input_.path.imperfection_m * length;
    State guess{linalg::duplicate(last_->state.x), last_->state.load_factor, last_->state.pressures_Pa};
    linalg::copy(last_->state.x, guess.x);
    linalg::add(guess.x, input_.path.imperfection_m, *event.mode);
    Constraint perturbed = bind(control_, *last_);
    perturbed.scale = step_;
    auto point = solve_at(perturbed, step_, std::move(guess));
    if (!point) {
        log("no branch is found at path.imperfection from the bifurcation: the path continues without it");
        control_ = saved_control;
        last_ = std::move(saved_last);
        before_ = std::move(saved_before);
        step_ = saved_step;
        return false;
    }
    log("on the branch: " + describe(*point));
    on_branch_ = true;
    first_step_ = step_;
    report_control();
    append(*point);
    last_ = std::move(point);
    return true;
}

}  // namespace soft::solver
