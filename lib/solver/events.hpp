#pragma once
/// What happens between two points of the path: contact, extrema of the load and of the user-selected control, bifurcations. An event
/// is located by states between both points; nothing here changes the path. Internal to the module.
/// Tested by solver/solver_test, solver/branch_test.
#include "solver/corrector.hpp"
#include "solver/path.hpp"

namespace soft::solver {

struct Event {
    enum class Kind { limit_point, control_extremum, bifurcation, first_contact };
    Kind kind;
    PathPoint point;
    int modes = 0;                            ///< eigenvalues that pass through zero at a bifurcation
    std::optional<linalg::Vector> mode = {};  ///< of a bifurcation, largest displacement 1
    int obstacle = -1;                        ///< of a first contact, as model::FirstContact
    mesh::Point location_m{};
};

/// States on both sides of an event, each a row until a state between both rows is found.
struct Bracket {
    const PathPoint &from, &to;
    std::optional<PathPoint> left = {}, right = {};
    [[nodiscard]] const PathPoint& low() const { return left ? *left : from; }
    [[nodiscard]] const PathPoint& high() const { return right ? *right : to; }
};

struct Events {
    std::vector<Event> list;                  ///< in the order of the path
    void add(Event event, double direction);  ///< of the path: 1 or -1
    std::string control_ends;  ///< why the user-selected control cannot continue beyond the first extremum; else empty
};

/// Walls that touch at a point with path.contact: stop, or that pass through each other with path.contact: solve.
[[nodiscard]] std::optional<ContactEvent> walls_at(Corrector& corrector, const Listeners& listeners,
                                                   const PathPoint& point);

/// With path.contact: stop, walls that touch at `point`, which moves back to the last state without contact between the last row and
/// itself.
[[nodiscard]] std::optional<ContactEvent> find_contact(Corrector& corrector, const PathState& path,
                                                       const Listeners& listeners, PathPoint& point);

/// With path.contact: solve, walls that pass through each other at `point`: contact is not resolved there.
[[nodiscard]] std::optional<ContactEvent> find_crossing(Corrector& corrector, const Listeners& listeners,
                                                        const PathPoint& point);

/// Where contact begins before `to`, which has been `solved` with or without it, if nothing touches at the last row. nullopt also where the
/// search fails before a state without contact.
[[nodiscard]] std::optional<Event> first_contact_before(const PathPoint& to, Corrector& corrector,
                                                        const PathState& path, WithContact solved);

/// Whether contact begins at a state of the same step, to the accuracy with which it is located.
[[nodiscard]] bool is_beside(const Event& contact, const PathPoint& point, double step);

/// A point that touches, as the event of a first contact.
[[nodiscard]] Event first_contact_at(PathPoint point, Corrector& corrector, const PathState& path);

/// The other events between the last row and `to`.
[[nodiscard]] Events events_before(const PathPoint& to, Corrector& corrector, const PathState& path,
                                   const Listeners& listeners);

}  // namespace soft::solver
