#include "solver/events.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/bifurcations.hpp"
#include "solver/stepping.hpp"

namespace soft::solver {

namespace {

/// A limit point is located until its load is known to this relative accuracy (estimated from the slope's parabola), better than the
/// tolerance of equilibrium, so that the path does not end below the row before.
constexpr double limit_point_tolerance = 1e-10;
/// Relative change of the load between two rows that is rounding.
constexpr double load_rounding = 1e-8;
constexpr int limit_point_solves = 12;
/// The step in which contact occurs is halved this many times: where the path ends there (more if it begins just beyond the last row), and
/// where a row follows.
constexpr int contact_halvings = 12, most_contact_halvings = 40, first_contact_halvings = 12;
/// Of the resolution of the first contact: the distance from it of the states that are solved for.
constexpr double beside_contact = 0.4;

/// A quantity's slope by q at a point.
using Slope = std::function<double(const PathPoint&)>;

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

std::optional<ContactEvent> walls_at(Corrector& corrector, const Listeners& listeners, const PathPoint& point) {
    if (!listeners.contact || corrector.input().path.contact == model::Contact::ignore) return std::nullopt;
    corrector.system().prescribe(point.levels);
    return listeners.contact(point.state.x);
}

std::optional<ContactEvent> find_contact(Corrector& corrector, const PathState& path, const Listeners& listeners,
                                         PathPoint& point) {
    if (corrector.input().path.contact != model::Contact::stop) return std::nullopt;
    auto touching = walls_at(corrector, listeners, point);
    if (!touching) return std::nullopt;
    listeners.report("contact before row " + std::to_string(path.rows) + ": locating its onset");
    double free_q = path.last->q, touching_q = point.q;
    std::optional<PathPoint> free;  // the walls may touch just beyond the last row
    for (int i = 0; i < contact_halvings || (!free && i < most_contact_halvings); ++i) {
        const double q = 0.5 * (free_q + touching_q);
        auto middle = corrector.solve_between(frame_of(path), *path.last, point, q);
        if (!middle) break;
        if (auto touch = walls_at(corrector, listeners, *middle)) {
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
    if (corrector.input().path.contact != model::Contact::solve) return std::nullopt;
    return walls_at(corrector, listeners, point);
}

std::optional<Event> first_contact_before(const PathPoint& to, Corrector& corrector, const PathState& path,
                                          WithContact solved) {
    if (!to.touches || path.last->touches) return std::nullopt;
    auto touching = first_in_contact(corrector, path, to, solved);
    if (!touching && solved != WithContact::no) touching = bisect_first_contact(corrector, path, to);
    if (touching) return first_contact_at(std::move(*touching), corrector, path);
    corrector.system().contact().set_resting(false);  // `to` touches
    return std::nullopt;
}

bool is_beside(const Event& contact, const PathPoint& point, double step) {
    return std::abs(contact.point.q - point.q) <= std::ldexp(std::abs(step), -first_contact_halvings);
}

Event first_contact_at(PathPoint point, Corrector& corrector, const PathState& path) {
    const contact::Summary touch = contact_at(corrector, path, point.state);
    return {Event::Kind::first_contact, std::move(point), 0, {}, touch.touched, *touch.location};
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
    if (!stage_of(corrector.input(), path).time_s)
        for (Event& event : bifurcations_before(to, corrector, path, listeners))
            events.add(std::move(event), path.direction());
    return events;
}

}  // namespace soft::solver
