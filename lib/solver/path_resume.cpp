#include "solver/path_follower.hpp"

#include "core/error.hpp"

namespace soft::solver {

void PathFollower::keep_checkpoint() {
    if (!keep_) return;
    const auto stored = [](const PathPoint& point) {
        return solution::StatePoint{linalg::gather(point.state.x), linalg::gather(point.tangent.x),
                                    point.state.load_factor,       point.tangent.load_factor,
                                    point.q,                       point.tangent.excess_pivots};
    };
    solution::Checkpoint checkpoint;
    MPI_Comm_size(system_.comm(), &checkpoint.ranks);
    checkpoint.rows = rows_;
    checkpoint.control = static_cast<int>(control_.kind);
    checkpoint.control_output = static_cast<std::int64_t>(control_.output);
    if (before_) checkpoint.before = stored(*before_);
    checkpoint.last = stored(*last_);
    checkpoint.step = step_;
    checkpoint.first_step = first_step_;
    checkpoint.so_far = end_;
    checkpoint.so_far.factorizations = factorizations_before_ + newton_.factorizations();
    keep_(checkpoint);
}

void PathFollower::restore(const solution::Checkpoint& from) {
    int ranks = 1;
    MPI_Comm_size(system_.comm(), &ranks);
    if (ranks != from.ranks)
        throw Error(ExitCode::bad_input, "the interrupted path",
                    "was followed by " + std::to_string(from.ranks) + " ranks, these are " + std::to_string(ranks),
                    "use as many");
    const auto size = static_cast<std::size_t>(system_.dofs().total);
    const auto point_of = [&](const solution::StatePoint& stored) {
        if (stored.unknowns.size() != size || stored.tangent_unknowns.size() != size)
            throw Error(ExitCode::bad_input, "the interrupted path", "has another number of unknowns than the case",
                        "run solve again");
        PathPoint point{{system_.make_vector(), stored.load_factor}, {}, stored.q, std::nullopt, {}, 0, {}};
        linalg::spread(stored.unknowns, point.state.x);
        point.tangent = {system_.make_vector(), stored.tangent_load_factor, stored.excess_pivots};
        linalg::spread(stored.tangent_unknowns, point.tangent.x);
        read_values(point);
        return point;
    };
    control_.kind = static_cast<ConstraintKind>(from.control);
    if (from.before) before_ = point_of(*from.before);
    last_ = point_of(from.last);
    step_ = from.step;
    first_step_ = from.first_step;
    rows_ = from.rows;
    end_ = from.so_far;
    factorizations_before_ = from.so_far.factorizations;
}

}  // namespace soft::solver
