#include "solver/visited_states.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace soft::solver {

namespace {

/// Smallest cosine of the angle between directions that count as the same (or opposite).
constexpr double same_direction = 0.9;
/// In lengths of the earlier step: far above the error of the cubic between two rows of an error-adaptive path.
constexpr double on_the_curve = 2e-3;
/// Shortest length of a closed path, in lengths of the earlier step: a path that an obstacle stops stays on the curve because it hardly moves.
constexpr double shortest_loop = 10 * on_the_curve;
constexpr std::size_t forward_rows = 2, backward_rows = 3;
/// Largest distance of a path that retraces itself from its earlier states, relative to the length retraced and to the whole path,
/// and the shortest length retraced, relative to the whole path.
constexpr double beside_the_run = 0.05, beside_the_path = 2e-3, shortest_run = 0.02;
/// The same relative to the earlier step: a path nearby that departs from it is another one.
constexpr double beside_the_step = 0.15;
/// Relative to the whole path: a path that has turned twice, as where one cell after another snaps through, continues along its
/// first part.
constexpr double alongside = 0.02;

double dot(const Sketch& a, const Sketch& b) {
    double sum = 0;
    for (std::size_t j = 0; j < sketch_size; ++j) sum += a[j] * b[j];
    return sum;
}

Sketch difference(const Sketch& a, const Sketch& b) {
    Sketch result;
    for (std::size_t j = 0; j < sketch_size; ++j) result[j] = a[j] - b[j];
    return result;
}

double norm(const Sketch& a) { return std::sqrt(dot(a, a)); }

/// The cubic between two states with a parameter from 0 to 1; both tangents have the length of the chord.
struct Segment {
    const VisitedState &from, &to;
    double chord = norm(difference(to.state, from.state));

    [[nodiscard]] Sketch at(double t) const {
        const double t2 = t * t, t3 = t2 * t;
        const double a = 2 * t3 - 3 * t2 + 1, b = chord * (t3 - 2 * t2 + t), c = 3 * t2 - 2 * t3, d = chord * (t3 - t2);
        Sketch point;
        for (std::size_t j = 0; j < sketch_size; ++j)
            point[j] = a * from.state[j] + b * from.tangent[j] + c * to.state[j] + d * to.tangent[j];
        return point;
    }
    [[nodiscard]] Sketch direction_at(double t) const {
        const double a = 6 * (t - t * t), b = chord * (3 * t * t - 4 * t + 1), d = chord * (3 * t * t - 2 * t);
        Sketch direction;
        for (std::size_t j = 0; j < sketch_size; ++j)
            direction[j] = a * (to.state[j] - from.state[j]) + b * from.tangent[j] + d * to.tangent[j];
        return direction;
    }
};

/// Parameter of the segment's state that is nearest to `state`: the best of some samples, then golden-section search around it.
double nearest_parameter(const Segment& segment, const Sketch& state) {
    constexpr int samples = 8, sections = 30;
    const auto distance = [&](double t) { return norm(difference(segment.at(t), state)); };
    double best = 0, smallest = distance(0);
    for (int i = 1; i <= samples; ++i) {
        const double t = static_cast<double>(i) / samples, there = distance(t);
        if (there < smallest) {
            best = t;
            smallest = there;
        }
    }
    double low = std::max(0.0, best - 1.0 / samples), high = std::min(1.0, best + 1.0 / samples);
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < sections; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        if (distance(a) < distance(b))
            high = b;
        else
            low = a;
    }
    return 0.5 * (low + high);
}

/// The nearest position to a state on the path before it; `position` is the length along the path.
struct Match {
    std::size_t segment = 0;
    double position = 0, distance = 0, cosine = 0, chord = 0;
};

class Path {
public:
    explicit Path(std::span<const VisitedState> states) : states_(states), lengths_(states.size(), 0.0) {
        for (std::size_t i = 1; i < states.size(); ++i)
            lengths_[i] = lengths_[i - 1] + norm(difference(states[i].state, states[i - 1].state));
    }

    [[nodiscard]] double length() const { return lengths_.back(); }
    [[nodiscard]] double length_to(std::size_t index) const { return lengths_[index]; }

    /// The nearest state on the segments before `index` whose direction is along (`sense` 1) or against (-1) that of the state.
    [[nodiscard]] std::optional<Match> match(std::size_t index, double sense) const {
        return match(index, sense, index - std::min<std::size_t>(index, 1));
    }
    /// The same on the first `segments` only.
    [[nodiscard]] std::optional<Match> match(std::size_t index, double sense, std::size_t segments) const {
        std::optional<Match> best;
        const VisitedState& state = states_[index];
        for (std::size_t i = 0; i < segments; ++i) {
            const Segment segment{states_[i], states_[i + 1]};
            const double near = best ? std::min(best->distance, segment.chord) : segment.chord;
            const double reach = near + segment.chord;
            if (segment.chord == 0.0 || norm(difference(state.state, states_[i].state)) > reach) continue;
            const double t = nearest_parameter(segment, state.state);
            const double distance = norm(difference(segment.at(t), state.state));
            const Sketch direction = segment.direction_at(t);
            const double size = norm(direction) * norm(state.tangent);
            const double cosine = size > 0.0 ? dot(direction, state.tangent) / size : 0.0;
            if (sense * cosine < same_direction || (best && distance >= best->distance)) continue;
            best = Match{i, lengths_[i] + t * segment.chord, distance, cosine, segment.chord};
        }
        return best;
    }

private:
    std::span<const VisitedState> states_;
    std::vector<double> lengths_;
};

std::optional<Return> forward_return(const Path& path, std::size_t last) {
    if (last < forward_rows) return std::nullopt;
    std::optional<Match> match;
    for (std::size_t i = last; i + forward_rows > last; --i) {
        match = path.match(i, 1.0);
        if (!match || match->distance > on_the_curve * match->chord) return std::nullopt;
        const double since = path.length_to(i) - match->position;
        if (since < shortest_loop * match->chord) return std::nullopt;
    }
    return Return{Return::Sense::forward, match->segment, last + 1 - forward_rows};
}

std::optional<Return> backward_return(const Path& path, std::size_t last) {
    const auto end = path.match(last, -1.0);
    if (!end) return std::nullopt;
    double position = end->position;
    std::size_t first = last;
    while (first > 0) {
        const auto match = path.match(first - 1, -1.0);
        if (!match || match->position < position || match->distance > beside_the_path * path.length()) break;
        position = match->position;
        --first;
    }
    const double run = position - end->position;
    if (last + 1 - first < backward_rows || run < shortest_run * path.length() ||
        end->distance > std::min({beside_the_run * run, beside_the_path * path.length(), beside_the_step * end->chord}))
        return std::nullopt;
    const auto along = path.match(last, 1.0, end->segment);  // before the part that it passes in the opposite direction
    if (along && along->distance < alongside * path.length()) return std::nullopt;
    return Return{Return::Sense::backward, end->segment, first};
}

}  // namespace

Sketch sketch_of(Vec x) {
    Sketch sketch{};
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(VecGetOwnershipRange(x, &begin, &end));
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArrayRead(x, &values));
    for (PetscInt i = begin; i < end; ++i) {
        // Signs from the bits of a hash of the unknown's index (splitmix64: Steele, Lea and Flood, OOPSLA 2014).
        std::uint64_t bits = (static_cast<std::uint64_t>(i) + 1) * 0x9e3779b97f4a7c15ULL;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
        bits ^= bits >> 31;
        const auto value = std::bit_cast<std::uint64_t>(values[i - begin]);
        for (std::size_t j = 0; j < sketch_size; ++j)  // without branches, which random bits mispredict
            sketch[j] += std::bit_cast<double>(value ^ (~bits >> j << 63));
    }
    SOFT_PETSC(VecRestoreArrayRead(x, &values));
    MPI_Allreduce(MPI_IN_PLACE, sketch.data(), static_cast<int>(sketch_size), MPI_DOUBLE, MPI_SUM,
                  PetscObjectComm(reinterpret_cast<PetscObject>(x)));
    const double scale = 1.0 / std::sqrt(static_cast<double>(sketch_size));
    for (double& component : sketch) component *= scale;
    return sketch;
}

double length_of(std::span<const VisitedState> states) {
    double length = 0;
    for (std::size_t i = 1; i < states.size(); ++i) length += norm(difference(states[i].state, states[i - 1].state));
    return length;
}

std::optional<Return> find_return(std::span<const VisitedState> states) {
    if (states.size() < backward_rows) return std::nullopt;
    const Path path(states);
    const std::size_t last = states.size() - 1;
    if (auto closed = forward_return(path, last)) return closed;
    return backward_return(path, last);
}

}  // namespace soft::solver
