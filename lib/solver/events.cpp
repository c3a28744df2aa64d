#include "solver/events.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/stepping.hpp"

namespace soft::solver {

namespace {

/// A limit point is located until its load is known to this relative accuracy (estimated from the slope's parabola), better than the
/// tolerance of equilibrium, so that the path does not end below the row before.
constexpr double limit_point_tolerance = 1e-10;
/// Relative change of the load between two rows that is rounding.
constexpr double load_rounding = 1e-8;
constexpr int limit_point_solves = 12;
/// A bifurcation is located until the load changes by less than this fraction of itself over the bracket.
constexpr double bifurcation_tolerance = 1e-6;
constexpr int bifurcation_solves = 30;
/// Inverse iterations for the mode: the eigenvalue that passes through zero is by far the smallest there.
constexpr int mode_iterations = 3;
/// Fractions of the step: distance before and after a bifurcation at which its eigenvalue is checked; where another one is smaller there,
/// closer to it.
constexpr double beside_bifurcation = 0.05, min_beside = 1e-6, closer_beside = 0.1;
/// Smallest cosine between the mode at the bifurcation and on either side.
constexpr double same_mode = 0.9;
/// Fraction of the distance between the rows on both sides: states farther apart than this belong to two branches, or the search between
/// them has failed.
constexpr double apart = 1e-3;
/// The step in which contact occurs is halved this many times: where the path ends there (more if it begins just beyond the last row), and
/// where a row follows.
constexpr int contact_halvings = 12, most_contact_halvings = 40, first_contact_halvings = 12;
/// Of the resolution of the first contact: the distance from it of the states that are solved for.
constexpr double beside_contact = 0.4;

/// A vector without any symmetry, the same in every run and on any number of ranks.
linalg::Vector generic_vector(const fem::System& system) {
    auto b = system.make_vector();
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i) {
        const double phase = 0.618033988749895 * static_cast<double>(i + 1);
        SOFT_PETSC(VecSetValue(b, i, 2.0 * (phase - std::floor(phase)) - 1.0, INSERT_VALUES));
    }
    linalg::assemble(b);
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

/// One inverse iteration with the bordered matrix M of the last tangent: 1 / (b . M^-1 b), an estimate of the smallest eigenvalue if b is
/// close to its mode, and the unit vector along M^-1 b.
struct InverseIterate {
    double eigenvalue;
    linalg::Vector v;
};
std::optional<InverseIterate> iterate_inverse(Newton& newton, Vec b) {
    auto solution = newton.bordered_solve(b);
    if (!solution) return std::nullopt;
    linalg::Vector v = std::move(solution->x);
    const double eigenvalue = 1.0 / linalg::dot(b, v);
    SOFT_PETSC(VecScale(v, 1.0 / linalg::norm(v)));
    if (linalg::dot(v, b) < 0.0) SOFT_PETSC(VecScale(v, -1.0));
    return InverseIterate{eigenvalue, std::move(v)};
}

/// Scales a mode to a largest displacement of 1; the sign does not depend on the number of ranks.
void normalize_mode(fem::System& system, Vec mode) {
    system.prescribe(fem::no_loads(system.input()));
    const auto u = system.fields().gather_displacements(mode);
    double factor = 0;
    for (const double component : u) factor = std::max(factor, std::abs(component));
    const auto first = std::ranges::find_if(u, [&](double component) { return std::abs(component) > 0.5 * factor; });
    if (first != u.end() && *first < 0.0) factor = -factor;
    MPI_Bcast(&factor, 1, MPI_DOUBLE, 0, system.comm());
    if (factor != 0.0) SOFT_PETSC(VecScale(mode, 1.0 / factor));
}

/// A quantity's slope by q at a point.
using Slope = std::function<double(const PathPoint&)>;

/// States on both sides of an event, each a row until a state between both rows is found.
struct Bracket {
    const PathPoint &from, &to;
    std::optional<PathPoint> left = {}, right = {};
    [[nodiscard]] const PathPoint& low() const { return left ? *left : from; }
    [[nodiscard]] const PathPoint& high() const { return right ? *right : to; }
};

std::optional<PathPoint> locate_extremum(Corrector& corrector, const PathState& path, const PathPoint& to,
                                         Event::Kind kind, const Slope& slope_at) {
    Bracket bracket{*path.last, to};
    const double first_slope = slope_at(bracket.from);
    for (int solve = 0; solve < limit_point_solves; ++solve) {
        const PathPoint &a = bracket.low(), &b = bracket.high();
        // Zero of the slope by the secant through both ends, kept away from both ends.
        const double span = b.q - a.q, at_a = slope_at(a), at_b = slope_at(b);
        const double share = std::clamp(at_a / (at_a - at_b), 0.02, 0.98);
        auto point = corrector.solve_between(frame_of(path), a, b, a.q + share * span);
        if (!point) return std::nullopt;
        const double curvature = (at_b - at_a) / span, slope = slope_at(*point);
        const double gain = std::abs(first_slope * (to.q - bracket.from.q));  // the scale of the quantity itself
        const double size = std::max(kind == Event::Kind::limit_point ? std::abs(point->leading) : 0.0, gain);
        const bool located = slope * slope <= 2.0 * limit_point_tolerance * std::abs(curvature) * size;
        if (located || solve + 1 == limit_point_solves) return point;
        (slope * first_slope > 0.0 ? bracket.left : bracket.right) = std::move(point);
    }
    return std::nullopt;
}

/// The smallest eigenvalue at q between the ends of a bracket, if its mode is `mode`.
std::optional<double> eigenvalue_at(Corrector& corrector, const PathState& path, const Bracket& bracket, double q,
                                    Vec mode) {
    const auto point = corrector.solve_between(frame_of(path), bracket.from, bracket.to, q);
    linalg::Vector b = copy_of(mode);
    std::optional<double> eigenvalue;
    for (int i = 0; point && i < 2 * mode_iterations; ++i) {
        auto next = iterate_inverse(corrector.newton(), b);
        if (!next) break;
        eigenvalue = next->eigenvalue;
        b = std::move(next->v);
    }
    if (std::abs(linalg::dot(b, mode)) < same_mode) return std::nullopt;
    return eigenvalue;
}

/// Why a change of the count of negative pivots over a bracket is no bifurcation: a count also changes by rounding, and where the
/// corrector has converged to another branch. Empty where the eigenvalue of the mode has opposite signs on both sides.
std::string check_bifurcation(Corrector& corrector, const PathState& path, const Bracket& bracket,
                              const std::optional<linalg::Vector>& mode) {
    const PathPoint &from = bracket.from, &to = bracket.to;
    const double gap = distance(bracket.low().state.x, bracket.high().state.x);
    if (gap > apart * distance(from.state.x, to.state.x))
        return "it is not located: the states found on both sides lie apart";
    if (!mode) return "no mode is found";
    const double span = to.q - from.q, at = 0.5 * (bracket.low().q + bracket.high().q);
    std::optional<double> before;
    for (const double side : {-1.0, 1.0}) {
        const double distance_to_end = std::abs(side < 0.0 ? at - from.q : to.q - at);
        double away = std::min(beside_bifurcation * std::abs(span), 0.5 * distance_to_end);
        // A change arbitrarily close to a row means that the count at the row itself is different.
        if (away < min_beside * std::abs(span)) return "only at a row itself, where no eigenvalue passes through zero";
        std::optional<double> eigenvalue;
        for (; away >= min_beside * std::abs(span) && !eigenvalue; away *= closer_beside)
            eigenvalue = eigenvalue_at(corrector, path, bracket, at + side * std::copysign(away, span), *mode);
        if (!eigenvalue) return "the smallest eigenvalue has another mode there";
        if (before && *before * *eigenvalue > 0.0) return "no eigenvalue passes through zero";
        before = eigenvalue;
    }
    return {};
}

/// The tangent at a bifurcation contains any multiple of the mode; that of the parabola with value and slope of the last row does not.
void use_parabola(fem::System& system, const PathState& path, PathPoint& to) {
    const PathPoint& from = *path.last;
    const double span = to.q - from.q;
    const auto slope = [span](double before, double after, double slope_before) {
        return 2 * (after - before) / span - slope_before;
    };
    to.is_singular = true;
    if (span == 0) return;
    linalg::copy(to.state.x, to.tangent.x);
    linalg::add(to.tangent.x, -1.0, from.state.x);
    SOFT_PETSC(VecScale(to.tangent.x, 2.0 / span));
    linalg::add(to.tangent.x, -1.0, from.tangent.x);
    to.tangent.load_factor = slope(from.state.load_factor, to.state.load_factor, from.tangent.load_factor);
    for (std::size_t k = 0; k < to.tangent.pressures.size(); ++k)
        to.tangent.pressures[k] =
            slope(from.state.pressures_Pa[k], to.state.pressures_Pa[k], from.tangent.pressures[k]);
    read_values(system, *path.loads, &from, to);
}

/// Brackets the change of branch_index by bisection on its count. The secant on 1 / (b . M^-1 b), which vanishes with the
/// eigenvalue (Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.3), shortens the bracket as
/// soon as b is close to the mode.
std::optional<Event> locate_bifurcation(Corrector& corrector, const PathState& path, const Listeners& listeners,
                                        const PathPoint& to) {
    Bracket bracket{*path.last, to};
    const int index = *branch_index(path, bracket.from);
    std::optional<double> left_test, right_test, root;
    linalg::Vector b = generic_vector(corrector.system());
    SOFT_PETSC(VecScale(b, 1.0 / linalg::norm(b)));
    std::optional<linalg::Vector> mode;
    for (int solve = 0; solve < bifurcation_solves; ++solve) {
        const PathPoint &a = bracket.low(), &c = bracket.high();
        const double q = left_test && right_test && *left_test * *right_test < 0.0
                             ? next_between({a.q, *left_test}, {c.q, *right_test}, root)
                             : 0.5 * (a.q + c.q);
        auto point = corrector.solve_between(frame_of(path), a, c, q);
        if (!point) break;
        const auto here = branch_index(path, *point);
        if (!here) break;
        std::optional<double> test;
        for (int i = 0; i < mode_iterations; ++i) {
            auto next = iterate_inverse(corrector.newton(), b);
            if (!next) break;
            test = next->eigenvalue;
            if (i + 1 < mode_iterations || solve == 0) linalg::copy(next->v, b);
            mode = std::move(next->v);
        }
        const bool before = *here == index;
        (before ? bracket.left : bracket.right) = std::move(point);
        (before ? left_test : right_test) = test;
        if (!bracket.left || !bracket.right) continue;
        const PathPoint &left = *bracket.left, &right = *bracket.right;
        const double change = std::abs(right.leading - left.leading) +
                              std::abs(right.state.load_factor - left.state.load_factor) * std::abs(left.leading);
        if (change <= bifurcation_tolerance * std::max(std::abs(left.leading), std::abs(right.leading))) break;
    }
    if (!bracket.left && !bracket.right) return std::nullopt;
    const std::string objection = check_bifurcation(corrector, path, bracket, mode);
    if (!objection.empty()) {
        listeners.report("the count of negative pivots changes before row " + std::to_string(path.rows) + ", but " +
                         objection + ": no bifurcation");
        return std::nullopt;
    }
    if (mode) normalize_mode(corrector.system(), *mode);
    PathPoint found = std::move(bracket.left ? *bracket.left : *bracket.right);
    use_parabola(corrector.system(), path, found);
    return Event{Event::Kind::bifurcation, std::move(found), 1, std::move(mode)};
}

contact::Summary contact_at(Corrector& corrector, const PathState& path, const State& state) {
    corrector.system().prescribe(path.loads->levels(state.load_factor, state.pressures_Pa));
    corrector.system().contact().set_resting(false);
    return corrector.system().contact().measure(state.x);
}

/// The first state in contact. Without contact the path does not bend: the cubic between two of its states tells where the next ones are
/// solved for, on both sides of the contact. nullopt where this fails.
std::optional<PathPoint> first_in_contact(Corrector& corrector, const PathState& path, const PathPoint& to,
                                          WithContact solved) {
    const Frame frame = frame_of(path);
    const double resolution = std::ldexp(to.q - path.last->q, -first_contact_halvings),
                 margin = beside_contact * std::abs(resolution);
    Bracket bracket{*path.last, to};
    if (solved != WithContact::no) {
        bracket.right = corrector.solve_between(frame, *path.last, to, to.q, WithContact::no);
        if (!bracket.right) return std::nullopt;
    }
    for (int i = 0; i < first_contact_halvings && bracket.high().touches; ++i) {
        const PathPoint &a = bracket.low(), &b = bracket.high();
        if (std::abs(b.q - a.q) <= std::abs(resolution)) {
            auto touching = corrector.solve_between(frame, a, b, b.q, WithContact::yes);
            return touching && touching->touches ? std::move(touching) : std::nullopt;
        }
        double before = a.q, after = b.q;
        while (std::abs(after - before) > margin) {
            const double middle = 0.5 * (before + after);
            (contact_at(corrector, path, predict(&a, b, middle)).touches() ? after : before) = middle;
        }
        double q = i % 2 == 0 ? before - beside_contact * resolution : after + beside_contact * resolution;
        if ((q - a.q) * (b.q - q) <= 0.0) q = 0.5 * (a.q + b.q);
        auto point = corrector.solve_between(frame, a, b, q, WithContact::no);
        if (!point || (!point->touches && corrector.wake_contact_if_met(frame, *point))) break;  // a thin obstacle
        (point->touches ? bracket.right : bracket.left) = std::move(point);
    }
    return std::nullopt;
}

/// Bisects on states of the path: a cubic between both states does not bend where the path does, at the contact.
std::optional<PathPoint> bisect_first_contact(Corrector& corrector, const PathState& path, const PathPoint& to) {
    Bracket bracket{*path.last, to};
    for (int i = 0; i < first_contact_halvings; ++i) {
        const PathPoint &a = bracket.low(), &b = bracket.high();
        auto middle = corrector.solve_between(frame_of(path), a, b, 0.5 * (a.q + b.q));
        if (!middle) break;
        (middle->touches ? bracket.right : bracket.left) = std::move(middle);
    }
    return std::move(bracket.right);
}

}  // namespace

std::optional<ContactEvent> find_contact(Corrector& corrector, const PathState& path, const Listeners& listeners,
                                         PathPoint& point) {
    if (!listeners.contact || corrector.input().path.contact != model::Contact::stop) return std::nullopt;
    const auto contact_at = [&](const PathPoint& at) {
        corrector.system().prescribe(at.levels);
        return listeners.contact(at.state.x);
    };
    auto touching = contact_at(point);
    if (!touching) return std::nullopt;
    listeners.report("contact before row " + std::to_string(path.rows) + ": locating its onset");
    double free_q = path.last->q, touching_q = point.q;
    std::optional<PathPoint> free;  // the walls may touch just beyond the last row
    for (int i = 0; i < contact_halvings || (!free && i < most_contact_halvings); ++i) {
        const double q = 0.5 * (free_q + touching_q);
        auto middle = corrector.solve_between(frame_of(path), *path.last, point, q);
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

std::optional<ContactEvent> find_crossing(Corrector& corrector, const Listeners& listeners, const PathPoint& point) {
    if (!listeners.contact || corrector.input().path.contact != model::Contact::solve) return std::nullopt;
    corrector.system().prescribe(point.levels);
    return listeners.contact(point.state.x);
}

std::optional<Event> first_contact_before(const PathPoint& to, Corrector& corrector, const PathState& path,
                                          WithContact solved) {
    if (!to.touches || path.last->touches) return std::nullopt;
    auto touching = first_in_contact(corrector, path, to, solved);
    if (!touching && solved != WithContact::no) touching = bisect_first_contact(corrector, path, to);
    const contact::Summary touch = contact_at(corrector, path, touching ? touching->state : to.state);
    if (!touching) return std::nullopt;
    return Event{Event::Kind::first_contact, std::move(*touching), 0, {}, touch.touched, *touch.location};
}

void Events::add(Event event, double direction) {
    const auto after = std::ranges::upper_bound(list, direction * event.point.q, {},
                                                [&](const Event& other) { return direction * other.point.q; });
    list.insert(after, std::move(event));
}

Events events_before(const PathPoint& to, Corrector& corrector, const PathState& path, const Listeners& listeners) {
    const PathPoint& from = *path.last;
    Events events;
    const auto watch = [&](Event::Kind kind, const Slope& slope) {
        if (slope(from) * slope(to) >= 0.0) return false;
        auto point = locate_extremum(corrector, path, to, kind, slope);
        if (!point) return false;  // not located: only the rows show the sign change
        events.add({kind, std::move(*point)}, path.direction());
        return true;
    };
    // Where the load hardly changes, a change of sign of its slope is rounding.
    const double change = std::abs(to.leading - from.leading),
                 size = std::max(std::abs(to.leading), std::abs(from.leading));
    const bool moves = path.user_control || change > load_rounding * size;
    bool ends = moves && watch(Event::Kind::limit_point, [](const PathPoint& at) { return at.leading_slope; });
    if (const auto& user = path.user_control) {
        const bool by_load = user->kind == ConstraintKind::load_factor;
        const bool leads = by_load && model::leading_load(corrector.input()) == model::LeadingLoad::pressure &&
                           path.loads->rate().pressures_Pa[0] != 0.0;
        const Slope slope = [&](const PathPoint& at) { return slope_of(*user, at); };
        if (!leads) ends = watch(Event::Kind::control_extremum, slope);
        if (ends)
            events.control_ends = "the " + std::string(by_load ? "load" : name(user->kind)) + " has a " +
                                  (slope(from) * path.direction() < 0.0 ? "minimum" : "maximum");
    }
    const auto before = branch_index(path, from), after = branch_index(path, to);
    if (before && after && *before != *after && !stage_of(corrector.input(), path).time_s)
        if (auto event = locate_bifurcation(corrector, path, listeners, to)) {
            event->modes = std::abs(*after - *before);
            events.add(std::move(*event), path.direction());
        }
    return events;
}

}  // namespace soft::solver
