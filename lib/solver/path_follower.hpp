#pragma once
/// The loop behind follow_path (path.hpp), internal to the module. The parts that it calls pass a PathState (path_state.hpp) along:
///   stages.hpp         loads, goals and first step of each stage
///   stepping.hpp       aim of a step, check of the state found there, size of the next step
///   corrector.hpp      Newton's method and the path's tangent; kink.hpp where fibres become taut or slack,
///                      snap.hpp where contact or a small part snaps
///   events.hpp         contact, limit points, bifurcations between two states
///   control.hpp        the controlled quantity and its change
///   recorder.hpp       rows (with work.hpp: the work of the loads), checkpoints
///   path_end.hpp       ends of paths that do not reach their load
/// What a new row changes besides the output (the internal variables of materials, the state of a contact) belongs in commit(); what is
/// computed at a row (sensitivities) in Recorder::append; new kinds of events in events_before() (first contact: step()).
#include "solver/events.hpp"
#include "solver/path_text.hpp"
#include "solver/recorder.hpp"

namespace soft::solver {

struct Aim;
struct ControlChange;
struct Snap;

class PathFollower {
public:
    PathFollower(fem::System& system, const Listeners& listeners, Sensitivities* sensitivities);

    model::PathEnd run(const model::Checkpoint* from);

private:
    void start();
    void step();
    /// Appends a state, and makes it the path's last one; go_from: without appending it again.
    void commit(PathPoint point);
    void go_from(PathPoint point);
    /// Appends the events before the next state; true if the path ends or turns at one.
    /// `at_contact`: a goal reached where contact begins.
    [[nodiscard]] bool pass_events(Events events, const Goal* at_contact);
    [[nodiscard]] bool take_branch(Event& bifurcation);
    void add_first_contact(const Event& event);
    void go_on_after_snap(Snap found, const std::string& how);
    /// The state at the aim, or where contact begins before it; this place is found without contact, and then the aim is there.
    [[nodiscard]] bool pass_goals(std::optional<PathPoint>& point, const Goal*& goal);
    [[nodiscard]] std::optional<PathPoint> solve_step(Aim& aim, std::optional<Event>& touch);
    void recover();
    /// Continues beyond a kink or a snap from `point`, which has no cubic with the rows before.
    /// `how` and `what` go before and after the point in the report. Ends the stage at a goal.
    void go_on_from(PathPoint point, const Goal* goal, const std::string& how, const std::string& what = {});
    void begin(State state);
    void end_stage(const std::string& text);
    /// Ends a stage in which nothing changes with the state at its start.
    void pass_hold();
    void change_control(const ControlChange& change);
    void finish(Stop stop);
    [[nodiscard]] std::string describe(const PathPoint& point) const { return state_text(point, input_); }
    void report_row(const std::string& text) const {
        listeners_.report("row " + std::to_string(path_.rows) + ": " + text);
    }

    fem::System& system_;
    const model::Case& input_;
    const Listeners& listeners_;
    Corrector corrector_;
    Recorder recorder_;
    PathState path_;
};

}  // namespace soft::solver
