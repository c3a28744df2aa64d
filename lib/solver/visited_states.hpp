#pragma once
/// Detects a path that returns to states it has passed: a closed branch, or a path that retraces itself. A state x is
/// stored as its sketch s = A x / sqrt(k) with k = 16 rows of signs +-1, whose distances estimate those of the states (random
/// projections: Achlioptas, J. Comput. Syst. Sci. 66 (2003) 671). Between two rows the path is the cubic through both sketches
/// with their tangents. Lengths are in the norm of the unknowns, as for the arc length.
/// Tested by solver/visited_states_test.
#include <array>
#include <optional>
#include <span>

#include "linalg/petsc.hpp"

namespace soft::solver {

inline constexpr std::size_t sketch_size = 16;
using Sketch = std::array<double, sketch_size>;

/// Collective, the same on every rank. The signs depend on the indices of the unknowns.
[[nodiscard]] Sketch sketch_of(Vec x);

/// A row of the path, with its unit tangent in the direction of travel.
struct VisitedState {
    Sketch state{}, tangent{};
};

/// Sum of the distances from each state to the next.
[[nodiscard]] double length_of(std::span<const VisitedState> states);

/// How the last states return to earlier ones: along them, as a closed curve does, or in the opposite direction.
struct Return {
    enum class Sense { forward, backward };
    Sense sense = Sense::forward;
    std::size_t earlier = 0;  ///< index of a state near the last one
    std::size_t first = 0;    ///< index of the first of the last states, which all lie on earlier ones
};

/// nullopt where the last state lies on no earlier part of the path. forward: the last two states do, to the accuracy of the cubic.
/// backward: the last three or more do, over at least a fiftieth of the path's length, within 0.2 % of that length; the last one also
/// within a twentieth of the length retraced and 15 % of the earlier step. A state that differs from the earlier one in one cell only
/// counts as the same. Not reported where they also lie beside a part that the path has passed in their own direction.
[[nodiscard]] std::optional<Return> find_return(std::span<const VisitedState> states);

}  // namespace soft::solver
