#include "solver/path.hpp"

#include <cmath>

#include "core/error.hpp"
#include "fem/rigid_motion.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

using model::PathEnd;

Error start_error(NewtonEnd end, const std::string& problem) {
    if (end == NewtonEnd::not_definite)
        return Error(
            ExitCode::bad_input, "solver.linear",
            "cholmod needs a positive definite tangent, which this case does not have",
            "use mumps-ldlt; the pressure unknowns of mixed cells (mesh.formulation) make the tangent indefinite");
    if (end == NewtonEnd::linear_solver)
        return Error(ExitCode::bad_input, "solver.linear", problem + ": the linear solver does not converge",
                     "use another solver.linear or solver.preconditioner, or increase solver.linear_limit");
    return Error(ExitCode::bad_input, "materials", problem, "check the moduli of the materials");
}

PathEnd PathFollower::run(const model::Checkpoint* from) {
    prepare();
    if (from != nullptr)
        restore(*from);
    else
        start();
    while (!finished_) {
        const int rows = rows_;
        advance();
        if (!finished_ && rows_ > rows) keep_checkpoint();
    }
    end_.factorizations = factorizations_before_ + newton_.factorizations();
    return std::move(end_);
}

void PathFollower::prepare() {
    if (const auto motion = fem::free_rigid_motion(input_))
        throw Error(ExitCode::bad_input, "supports", "no support prevents a rigid " + *motion,
                    "fix a face in that direction");
    if (input_.path.stages.empty()) throw Error(ExitCode::bad_input, "path", "the load programme has no stages");
    undeformed_volumes_m3_ = undeformed_volumes_m3(system_);
    if (input_.path.frequencies > 0) frequencies_.emplace(system_, input_.path.frequencies);
}

void PathFollower::start() {
    set_stage(0, unloaded(input_, undeformed_volumes_m3_));
    if (!loads_->changes())
        throw Error(ExitCode::bad_input, "loads", "no load acts on the body", "set loads.cavity.pressure");
    State state{system_.make_vector(), 0.0, {}};
    state.pressures_Pa.assign(loads_->free_supplies().size(), 0.0);
    if (system_.has_initial_stress()) {  // row 0 is the unloaded equilibrium, not the undeformed state
        newton_result_ = newton_.correct({ConstraintKind::load_factor}, 0.0, state);
        if (newton_result_.end != NewtonEnd::converged)
            throw start_error(newton_result_.end, "no equilibrium without load under the law's initial stress");
    }
    begin_stage(std::move(state));
    append(*last_);
}

void PathFollower::finish(model::StopReason reason, std::string detail) {
    end_.reason = reason;
    end_.detail = std::move(detail);
    finished_ = true;
}

PathEnd follow_path(fem::System& system, const Listeners& listeners, const model::Checkpoint* from) {
    return PathFollower(system, listeners).run(from);
}

}  // namespace soft::solver
