/// Kinks of the path. Where a fibre becomes slack or taut, the tangent K jumps, and with it the direction of the path: it
/// may turn by more than a right angle, and the load may reverse; then no step along the direction before the kink converges.
/// Beyond the kink the path belongs to another smooth piece of the law, with the direction +-K^-1 f and the K of the far side. The
/// sign is the one that leads away from the kink and stays in that piece (paths of piecewise linear maps: Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 12). Tested by solver/kink_test.
#include <algorithm>
#include <cmath>

#include "model/cavity_surface.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

namespace {

/// Number of steps tried beyond a kink, each a quarter of the one before.
constexpr int reaches = 3;
constexpr double shorter_reach = 0.25;
/// Distance beyond the kink along the new direction, in failed steps.
constexpr double along_new_direction = 2.0;
/// Smallest cosine between two directions of the same piece, and to the direction of the path at the end of the step.
constexpr double same_piece = 0.9999, same_direction = 0.5;
/// Distance from rest in first steps: close enough to lie in the first piece, far enough that rounding does not select the piece. And
/// the relative difference of directions of one piece.
constexpr double away_from_rest = 1e-5, of_the_piece = 1e-3;
/// Minimum distance from rest relative to the body's size: under tiny loads rounding would decide which fibres are taut.
constexpr double visible_strain = 1e-9;
/// Fibres of neighbouring points may change one right after the other: number of directions tried until one leads into its own
/// piece, and of halvings of the failed step to find the first piece if none does.
constexpr int pieces = 8, halvings = 30;
/// Number of distances along a direction, each longer than the one before by the factor `longer`, to find which sense leaves a piece.
constexpr int lengths = 4;
constexpr double longer = 4.0;
/// Allowed distance from the plane of both directions, relative to the distances along them, and tolerance relative to the failed
/// step: a state that is farther off lies on another path.
constexpr double off_the_plane = 0.1;

State moved(const State& from, double length, const PathTangent& direction) {
    State to = copy_of(from);
    linalg::add(to.x, length, direction.x);
    to.load_factor += length * direction.load_factor;
    for (std::size_t k = 0; k < to.pressures_Pa.size(); ++k) to.pressures_Pa[k] += length * direction.pressures[k];
    return to;
}

}  // namespace

/// At rest all fibres are at the point of becoming taut, and K is that of the matrix material alone. The direction of the path is
/// that of the piece into which it leads.
PathTangent PathFollower::leave_rest(const State& rest, PathTangent slack) {
    PathTangent direction = std::move(slack);
    const double visible_m = visible_strain * model::extent_m(input_.mesh);
    for (int piece = 0; piece < pieces; ++piece) {
        const double way = std::max(away_from_rest * settings_.first_step, visible_m / linalg::norm(direction.x));
        auto next = newton_.tangent({ConstraintKind::load_factor}, moved(rest, way, direction));
        if (!next || !std::isfinite(linalg::norm(next->x))) break;
        linalg::copy(next->x, scratch_);
        linalg::add(scratch_, -1.0, direction.x);
        const bool settled = linalg::norm(scratch_) < of_the_piece * linalg::norm(next->x);
        direction = std::move(*next);
        if (settled) break;
    }
    return direction;
}

/// The unit direction of travel by the tangent at `state`, which is near the path but not on it.
std::optional<PathTangent> PathFollower::oriented_direction(const State& state) {
    auto direction = newton_.tangent({ConstraintKind::load_factor}, state);
    if (!direction || !direction->unstable_modes) return std::nullopt;
    const bool flips = (*direction->unstable_modes - *last_->tangent.unstable_modes) % 2 != 0;
    scale(*direction, (load_falls(*last_) == flips ? 1.0 : -1.0) / linalg::norm(direction->x));
    return direction;
}

/// At rest all fibres are at their kink: there is no step towards it, and the sense of the first direction is known.
bool PathFollower::begins_at_rest() const { return rows_ <= stage_first_row_ + 1; }

/// Gives `direction`, that of the piece at `base`, the sense in which it does not leave this piece again: the count of pivots
/// gives the sense only where K is symmetric. False where both senses leave the piece.
bool PathFollower::stays_in_piece(const State& base, double length, PathTangent& direction) {
    const auto stays = [&](double way) {
        const auto there = oriented_direction(moved(base, way, direction));
        return there && std::abs(linalg::dot(there->x, direction.x)) > same_piece;
    };
    for (int i = 0; i < lengths; ++i, length *= longer) {
        const bool forward = stays(length);
        if (begins_at_rest()) return forward;
        const bool backward = stays(-length);
        if (forward && backward) continue;
        if (backward) scale(direction, -1.0);
        return forward || backward;
    }
    return true;
}

/// Follows directions from piece to piece until one leads into its own piece; false if none does.
bool PathFollower::find_consistent_direction(const State& base, double length, PathTangent& direction) {
    for (int piece = 0; piece < pieces; ++piece) {
        if (stays_in_piece(base, length, direction)) return true;
        auto next = oriented_direction(moved(base, length, direction));
        if (!next) return false;
        direction = std::move(*next);
    }
    return false;
}

/// The direction of the first piece beyond the last row that is neither that row's own nor `far`, the one at the end of the step.
std::optional<PathTangent> PathFollower::piece_between(double step, const PathTangent& far) {
    const double length = (step < 0.0 ? -1.0 : 1.0) * linalg::norm(last_->tangent.x);
    double near = 0.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (near + step);
        auto direction = oriented_direction(moved(last_->state, middle, last_->tangent));
        if (!direction) return std::nullopt;
        const bool as_last = linalg::dot(direction->x, last_->tangent.x) > same_piece * length;
        if (!as_last && linalg::dot(direction->x, far.x) < same_piece) return direction;
        (as_last ? near : step) = middle;
    }
    return std::nullopt;
}

/// Whether x is reached from the last row along its direction by no more than the step, then along `turned`.
bool PathFollower::turns_within(double step, const PathTangent& turned, Vec x) {
    const double length = (step < 0.0 ? -1.0 : 1.0) * linalg::norm(last_->tangent.x);
    const double cosine = linalg::dot(turned.x, last_->tangent.x) / length;
    if (cosine > same_direction) return true;
    linalg::copy(x, scratch_);
    linalg::add(scratch_, -1.0, last_->state.x);
    const double by_old = linalg::dot(scratch_, last_->tangent.x) / length, by_new = linalg::dot(scratch_, turned.x);
    const double sine2 = 1.0 - cosine * cosine;
    const double old_way = (by_old - cosine * by_new) / sine2, new_way = (by_new - cosine * by_old) / sine2;
    linalg::add(scratch_, -old_way / length, last_->tangent.x);
    linalg::add(scratch_, -new_way, turned.x);
    const double reach = std::abs(step) * std::abs(length);
    return new_way > 0.0 && linalg::norm(scratch_) <= off_the_plane * std::max(new_way, std::abs(old_way)) &&
           (begins_at_rest() || (old_way > -off_the_plane * reach && old_way < (1.0 + off_the_plane) * reach));
}

std::optional<PathPoint> PathFollower::point_along(double step, const PathTangent& turned) {
    const State beyond = moved(last_->state, step, last_->tangent);
    State guess = moved(beyond, along_new_direction * std::abs(step) * linalg::norm(last_->tangent.x), turned);
    Constraint arc{ConstraintKind::arc};
    arc.arc_origin = last_->state.x;
    arc.arc_direction = turned.x;
    arc.scale = std::abs(step);
    const double target = evaluate(arc, system_, *loads_, guess, scratch_).value;
    const NewtonResult result = newton_.correct(arc, target, guess);
    iterations_since_row_ += result.iterations;
    end_.newton_iterations += result.iterations;
    if (result.end != NewtonEnd::converged) return std::nullopt;
    auto tangent = oriented_direction(guess);
    if (!tangent) return std::nullopt;
    const double cosine = linalg::dot(tangent->x, turned.x);
    if (std::abs(cosine) < same_direction || !turns_within(step, turned, guess.x)) return std::nullopt;
    if (cosine < 0.0 && begins_at_rest()) return std::nullopt;
    if (cosine < 0.0) scale(*tangent, -1.0);
    return measure(std::move(guess), std::move(*tangent));
}

bool PathFollower::pass_kink(double failed_step) {
    if (control_.kind != ConstraintKind::arc || !last_->tangent.unstable_modes) return false;
    const int pivots = newton_.confirmed_pivots();
    for (int attempt = 0; attempt < reaches; ++attempt) {
        const double step = failed_step * std::pow(shorter_reach, attempt);
        const State beyond = moved(last_->state, step, last_->tangent);
        const double along = along_new_direction * std::abs(step) * linalg::norm(last_->tangent.x);
        auto turned = oriented_direction(beyond);
        if (turned && !find_consistent_direction(beyond, along, *turned))
            if (auto between = piece_between(step, *turned)) {
                turned = std::move(between);
                static_cast<void>(find_consistent_direction(beyond, along, *turned));
            }
        auto point = turned ? point_along(step, *turned) : std::nullopt;
        if (!point) {
            newton_.confirm_pivots(pivots);
            continue;
        }
        log("row " + std::to_string(rows_) + ": passed a kink to " + describe(*point));
        if (step_ < 0.0) rescale(*last_, -1.0);
        step_ = point->q - last_->q;
        failures_ = 0;
        rejected_error_.reset();
        rejected_curve_error_.reset();
        accept(std::move(*point));
        before_.reset();  // no cubic through a kink
        return true;
    }
    return false;
}

}  // namespace soft::solver
