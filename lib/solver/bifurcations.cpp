#include "solver/bifurcations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/stepping.hpp"

namespace soft::solver {

namespace {

/// A bifurcation is located until the load changes by less than this fraction of itself over the bracket.
constexpr double bifurcation_tolerance = 1e-6;
constexpr int bifurcation_solves = 30;
/// Of the rest of the step: how far beyond a bifurcation the next one is sought.
constexpr std::array shares_beyond{0.02, 1e-3};
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

/// What the first change of branch_index in an interval is: a bifurcation, or none; and a state beyond it, before the next change, where there
/// may be one.
struct FirstChange {
    std::optional<Event> event;
    std::optional<PathPoint> beyond;
};

/// Brackets the first change of branch_index by bisection on its count. The secant on 1 / (b . M^-1 b), which vanishes with the
/// eigenvalue (Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.3), shortens the bracket as
/// soon as b is close to the mode.
FirstChange locate_bifurcation(Corrector& corrector, const PathState& path, const Listeners& listeners,
                               const PathPoint& from, const PathPoint& to) {
    Bracket bracket{from, to};
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
    if (!bracket.left && !bracket.right) return {};
    const std::string objection = check_bifurcation(corrector, path, bracket, mode);
    const int modes = std::abs(*branch_index(path, bracket.high()) - index);
    FirstChange change;
    if (objection.empty()) {
        if (mode) normalize_mode(corrector.system(), *mode);
        change.event = {Event::Kind::bifurcation, std::move(bracket.left ? *bracket.left : *bracket.right), modes,
                        std::move(mode)};
        use_parabola(corrector.system(), path, change.event->point);
        if (!bracket.left) return change;
    } else {
        listeners.report("the count of negative pivots changes before row " + std::to_string(path.rows) + ", but " +
                         objection + ": no bifurcation");
    }
    change.beyond = std::move(bracket.right);
    return change;
}

/// The state from which the next change is sought: a little beyond the last one, as the tangent at a bifurcation contains any multiple of the
/// mode. nullopt where the next change follows at once.
std::optional<PathPoint> start_beyond(Corrector& corrector, const PathState& path, const PathPoint& beyond,
                                      const PathPoint& to) {
    for (const double share : shares_beyond) {
        auto point = corrector.solve_between(frame_of(path), *path.last, to, beyond.q + share * (to.q - beyond.q));
        if (point && branch_index(path, *point) == branch_index(path, beyond)) return point;
    }
    return std::nullopt;
}

}  // namespace

std::vector<Event> bifurcations_before(const PathPoint& to, Corrector& corrector, const PathState& path,
                                       const Listeners& listeners) {
    std::vector<Event> events;
    const auto last = branch_index(path, to), first = branch_index(path, *path.last);
    if (!last || !first) return events;
    std::optional<PathPoint> start;
    const auto from = [&]() -> const PathPoint& { return start ? *start : *path.last; };
    int before_event = *first;
    for (int tries = std::abs(*last - *first) + 1; tries > 0 && branch_index(path, from()) != last; --tries) {
        const int index = *branch_index(path, from());
        FirstChange change = locate_bifurcation(corrector, path, listeners, from(), to);
        if (change.event) {
            events.push_back(std::move(*change.event));
            before_event = index;
        }
        start = change.beyond ? start_beyond(corrector, path, *change.beyond, to) : std::nullopt;
        if (!events.empty() && (!start || !change.event))  // what is not told apart belongs to the last one
            events.back().modes = std::max(1, std::abs(*(start ? branch_index(path, *start) : last) - before_event));
        if (!start) break;
    }
    return events;
}

}  // namespace soft::solver
