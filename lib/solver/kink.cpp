#include "solver/kink.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"

namespace soft::solver {

namespace {

/// Number of steps tried beyond a kink, each a quarter of the one before.
constexpr int reaches = 3;
constexpr double shorter_reach = 0.25;
/// Distance beyond the kink along the new direction, in failed steps.
constexpr double along_new_direction = 2.0;
/// Smallest cosine between two directions of the same piece, and to the direction of the path at the end of the step.
constexpr double same_piece = 0.9999, roughly_along = 0.5;
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

/// The unit direction of travel by the tangent at `state`, which is near the path but not on it.
std::optional<PathTangent> oriented_direction(Corrector& corrector, const PathState& path, const State& state) {
    auto direction = corrector.newton().tangent({ConstraintKind::load_factor}, state);
    if (!direction || !direction->unstable_modes) return std::nullopt;
    const bool flips = (*direction->unstable_modes - *path.last->tangent.unstable_modes) % 2 != 0;
    scale(*direction, (path.load_falls(*path.last) == flips ? 1.0 : -1.0) / linalg::norm(direction->x));
    return direction;
}

/// Gives `direction`, that of the piece at `base`, the sense in which it does not leave this piece again: the count of pivots
/// gives the sense only where K is symmetric. False where both senses leave the piece.
bool stays_in_piece(Corrector& corrector, const PathState& path, const State& base, double length,
                    PathTangent& direction) {
    const auto stays = [&](double way) {
        const auto there = oriented_direction(corrector, path, moved(base, way, direction));
        return there && std::abs(linalg::dot(there->x, direction.x)) > same_piece;
    };
    for (int i = 0; i < lengths; ++i, length *= longer) {
        const bool forward = stays(length);
        if (path.begins_stage()) return forward;
        const bool backward = stays(-length);
        if (forward && backward) continue;
        if (backward) scale(direction, -1.0);
        return forward || backward;
    }
    return true;
}

/// Follows directions from piece to piece until one leads into its own piece; false if none does.
bool find_consistent_direction(Corrector& corrector, const PathState& path, const State& base, double length,
                               PathTangent& direction) {
    for (int piece = 0; piece < pieces; ++piece) {
        if (stays_in_piece(corrector, path, base, length, direction)) return true;
        auto next = oriented_direction(corrector, path, moved(base, length, direction));
        if (!next) return false;
        direction = std::move(*next);
    }
    return false;
}

/// The direction of the first piece beyond the last row that is neither that row's own nor `far`, the one at the end of the step.
std::optional<PathTangent> piece_between(Corrector& corrector, const PathState& path, double step,
                                         const PathTangent& far) {
    const double length = path.direction() * linalg::norm(path.last->tangent.x);
    double near = 0.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (near + step);
        auto direction = oriented_direction(corrector, path, moved(path.last->state, middle, path.last->tangent));
        if (!direction) return std::nullopt;
        const bool as_last = linalg::dot(direction->x, path.last->tangent.x) > same_piece * length;
        if (!as_last && linalg::dot(direction->x, far.x) < same_piece) return direction;
        (as_last ? near : step) = middle;
    }
    return std::nullopt;
}

/// Whether x is reached from the last row along its direction by no more than the step, then along `turned`.
bool turns_within(const PathState& path, double step, const PathTangent& turned, Vec x) {
    const double length = path.direction() * linalg::norm(path.last->tangent.x);
    const double cosine = linalg::dot(turned.x, path.last->tangent.x) / length;
    if (cosine > roughly_along) return true;
    const linalg::Vector rest = copy_of(x);
    linalg::add(rest, -1.0, path.last->state.x);
    const double by_old = linalg::dot(rest, path.last->tangent.x) / length, by_new = linalg::dot(rest, turned.x);
    const double sine2 = 1.0 - cosine * cosine;
    const double old_way = (by_old - cosine * by_new) / sine2, new_way = (by_new - cosine * by_old) / sine2;
    linalg::add(rest, -old_way / length, path.last->tangent.x);
    linalg::add(rest, -new_way, turned.x);
    const double reach = std::abs(step) * std::abs(length);
    return new_way > 0.0 && linalg::norm(rest) <= off_the_plane * std::max(new_way, std::abs(old_way)) &&
           (path.begins_stage() || (old_way > -off_the_plane * reach && old_way < (1.0 + off_the_plane) * reach));
}

std::optional<PathPoint> point_along(Corrector& corrector, const PathState& path, double step,
                                     const PathTangent& turned) {
    const State beyond = moved(path.last->state, step, path.last->tangent);
    State guess = moved(beyond, along_new_direction * std::abs(step) * linalg::norm(path.last->tangent.x), turned);
    const Constraint arc{ConstraintKind::arc, 0, path.last->state.x, turned.x, std::abs(step)};
    const double target = corrector.value(arc, *path.loads, guess);
    if (!corrector.correct(arc, target, guess)) return std::nullopt;
    auto tangent = oriented_direction(corrector, path, guess);
    if (!tangent) return std::nullopt;
    const double cosine = linalg::dot(tangent->x, turned.x);
    if (std::abs(cosine) < roughly_along || !turns_within(path, step, turned, guess.x)) return std::nullopt;
    if (cosine < 0.0 && path.begins_stage()) return std::nullopt;
    if (cosine < 0.0) scale(*tangent, -1.0);
    return corrector.measure(frame_of(path), std::move(guess), std::move(*tangent));
}

}  // namespace

PathTangent leave_rest(Corrector& corrector, const State& rest, PathTangent slack) {
    PathTangent direction = std::move(slack);
    const model::Case& input = corrector.input();
    const double visible_m = visible_strain * mesh::extent_m(input.mesh);
    for (int piece = 0; piece < pieces; ++piece) {
        const double way = std::max(away_from_rest * input.solver.first_step, visible_m / linalg::norm(direction.x));
        auto next = corrector.newton().tangent({ConstraintKind::load_factor}, moved(rest, way, direction));
        if (!next || !std::isfinite(linalg::norm(next->x))) break;
        const bool settled = distance(next->x, direction.x) < of_the_piece * linalg::norm(next->x);
        direction = std::move(*next);
        if (settled) break;
    }
    return direction;
}

std::optional<PathPoint> pass_kink(Corrector& corrector, const PathState& path, double failed_step) {
    if (path.control.kind != ConstraintKind::arc || !path.last->tangent.unstable_modes) return std::nullopt;
    const Corrector::Memory memory = corrector.memory();
    for (int attempt = 0; attempt < reaches; ++attempt) {
        const double step = failed_step * std::pow(shorter_reach, attempt);
        const State beyond = moved(path.last->state, step, path.last->tangent);
        const double along = along_new_direction * std::abs(step) * linalg::norm(path.last->tangent.x);
        auto turned = oriented_direction(corrector, path, beyond);
        if (turned && !find_consistent_direction(corrector, path, beyond, along, *turned))
            if (auto between = piece_between(corrector, path, step, *turned)) {
                turned = std::move(between);
                static_cast<void>(find_consistent_direction(corrector, path, beyond, along, *turned));
            }
        if (turned)
            if (auto point = point_along(corrector, path, step, *turned)) return point;
        corrector.restore(memory);
    }
    return std::nullopt;
}

}  // namespace soft::solver
