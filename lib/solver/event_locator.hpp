#pragma once
/// What happens between two points of the path: contact, extrema of the load and of the user-selected control, bifurcations. An event
/// is located by states between both points; nothing here changes the path. Internal to the module.
/// Tested by solver/solver_test, solver/branch_test.
#include "solver/corrector.hpp"
#include "solver/path.hpp"

namespace soft::solver {

struct Event {
    enum class Kind { limit_point, control_extremum, bifurcation };
    Kind kind;
    PathPoint point;
    int modes = 0;                            ///< eigenvalues that pass through zero at a bifurcation
    std::optional<linalg::Vector> mode = {};  ///< of a bifurcation, largest displacement 1
};

struct Events {
    std::vector<Event> list;   ///< in the order of the path
    std::string control_ends;  ///< why the user-selected control cannot continue beyond the first extremum; else empty
};

class EventLocator {
public:
    EventLocator(Corrector& corrector, const PathState& path, const Listeners& listeners)
        : corrector_(corrector), path_(path), frame_(frame_of(path)), listeners_(listeners) {}

    /// Walls that touch at `point`, which moves back to the last state without contact between the last row and itself.
    [[nodiscard]] std::optional<ContactEvent> find_contact(PathPoint& point);

    /// The events between the last row and `to`.
    [[nodiscard]] Events events_before(const PathPoint& to);

private:
    /// A quantity's slope by q at a point.
    using Slope = double (*)(const PathPoint&, std::size_t);

    /// States on both sides of an event, each the last row or `to` until a state between them is found.
    struct Bracket {
        const PathPoint &from, &to;
        std::optional<PathPoint> left = {}, right = {};
        [[nodiscard]] const PathPoint& low() const { return left ? *left : from; }
        [[nodiscard]] const PathPoint& high() const { return right ? *right : to; }
    };

    [[nodiscard]] std::optional<PathPoint> locate_extremum(const PathPoint& to, Slope slope_at, std::size_t index);
    [[nodiscard]] std::optional<Event> locate_bifurcation(const PathPoint& to);
    [[nodiscard]] std::string check_bifurcation(const Bracket& bracket, const std::optional<linalg::Vector>& mode);

    Corrector& corrector_;
    const PathState& path_;
    Frame frame_;
    const Listeners& listeners_;
};

}  // namespace soft::solver
