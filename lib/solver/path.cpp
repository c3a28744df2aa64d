#include "solver/path.hpp"

#include <cmath>

#include "assembly/rigid_motion.hpp"
#include "core/error.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

using solution::PathEnd;

namespace {

Constraint control_constraint(const model::Case& input, bool has_volume) {
    switch (input.path.control) {
        case model::Control::pressure: return {ConstraintKind::load_factor};
        case model::Control::volume:
            if (!has_volume)
                throw Error(ExitCode::bad_input, "path.control", "volume control needs a loaded cavity",
                            "use pressure, displacement or arc-length");
            return {ConstraintKind::volume};
        case model::Control::displacement:
            if (input.outputs.empty())
                throw Error(ExitCode::bad_input, "path.control", "displacement control needs an output",
                            "name one under outputs");
            return {ConstraintKind::output};
        case model::Control::arc_length: return {ConstraintKind::arc};
    }
    return {};
}

}  // namespace

double coarse(double step) {
    int exponent = 0;
    const double mantissa = std::frexp(step, &exponent);
    constexpr double divisions = 256;
    return std::ldexp(std::round(mantissa * divisions) / divisions, exponent);
}

PathEnd PathFollower::run(const solution::Checkpoint* from) {
    prepare();
    if (from != nullptr)
        restore(*from);
    else
        start();
    while (!finished()) {
        const int rows = rows_;
        advance();
        if (!finished() && rows_ > rows) keep_checkpoint();
    }
    end_.factorizations = factorizations_before_ + newton_.factorizations();
    return std::move(end_);
}

void PathFollower::prepare() {
    if (const auto motion = assembly::free_rigid_motion(input_))
        throw Error(ExitCode::bad_input, "supports", "nothing holds the body against a rigid " + *motion,
                    "hold a face in that direction");
    const auto volume = system_.enclosed_volume(system_.make_vector(), nullptr);
    control_ = control_constraint(input_, volume.has_value());
    stop_at_limit_point_ = control_.kind == ConstraintKind::load_factor;
    goals_ = make_goals(input_, volume);
}

void PathFollower::start() {
    State state{system_.make_vector(), 0.0};
    if (system_.starts_under_stress()) {   // row 0 is the body free of load, not the undeformed one
        newton_result_ = newton_.correct({ConstraintKind::load_factor}, 0.0, state);
        if (newton_result_.end != NewtonEnd::converged)
            throw Error(ExitCode::bad_input, "materials", "no equilibrium without load under the law's initial stress",
                        "check the moduli of the materials");
    }
    auto tangent = newton_.tangent({ConstraintKind::load_factor}, state);
    if (!tangent || !std::isfinite(linalg::norm(tangent->x)))
        throw Error(ExitCode::bad_input, "materials", "the undeformed body has a singular stiffness",
                    "check the moduli of the materials");
    // The linear response gives the first step: first_step of the full load.
    last_ = measure(std::move(state), std::move(*tangent));
    if (control_.kind != ConstraintKind::load_factor) {
        auto along_control = newton_.tangent(bind(control_, *last_), last_->state);
        if (!along_control) throw Error(ExitCode::bad_input, "path.control", "the load does not move the controlled quantity");
        State undeformed = std::move(last_->state);
        last_.reset();
        last_ = measure(std::move(undeformed), std::move(*along_control));
    }
    first_step_ = step_ = coarse(settings_.first_step / last_->tangent.load_factor);
    append(*last_);
}

void PathFollower::finish(solution::StopReason reason, std::string detail) {
    end_.reason = reason;
    end_.detail = std::move(detail);
    finished_ = true;
}

int PathFollower::wanted_steps() const {
    for (const auto& until : input_.path.until)
        if (until.quantity == "steps") return static_cast<int>(until.value);
    return settings_.step_limit;
}

PathEnd follow_path(assembly::System& system, const Listeners& listeners, const solution::Checkpoint* from) {
    if (model::leading_load(system.input()).value_Pa == 0.0)
        throw Error(ExitCode::bad_input, "loads", "nothing loads the body", "give loads.cavity.pressure");
    return PathFollower(system, listeners).run(from);
}

}  // namespace soft::solver
