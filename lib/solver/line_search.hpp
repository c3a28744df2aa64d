#pragma once
/// Step length of a Newton correction dx (model::LineSearch).
///   backtracking: 1, 1/2, 1/4, ... until |R| falls below (1 - 1e-4 length) of `pending` (Armijo)
///   secant: until the residual along the correction, g(length) = dx . R(x + length dx, loads of the whole correction), is at
///       most half of g(0); the secant method on g, which may go beyond 1 (Matthies and Strang 1979; Crisfield 1991 9.2)
///   none: 1
/// All of them halve the length while det F <= 0 somewhere. Tested by solver/line_search_test.
#include <functional>

#include "model/settings.hpp"

namespace soft::solver {

/// The state at one length.
struct Trial {
    bool admissible = true;  ///< det F > 0
    double residual = 0;     ///< |R|
    double floor = 0;        ///< |R| that counts as equilibrium
    double slope = 0;        ///< g, used by secant only
};

struct SearchStart {
    double pending = 0;       ///< |R| and the loads not yet applied, as a force
    double allowed_rise = 1;  ///< of the residual over `pending`, backtracking only
    double slope = 0;         ///< g(0)
    double longest = 1;       ///< first length that is tried (contact: walls that a longer step would pass through)
};

enum class SearchEnd { found, no_descent, inverted };

struct Search {
    SearchEnd end = SearchEnd::found;
    double length = 1;
    int halvings = 0;  ///< trials beyond the first
    Trial trial;       ///< at `length`, which was tried last
};

[[nodiscard]] Search search(model::LineSearch kind, const SearchStart& start, const std::function<Trial(double)>& at);

}  // namespace soft::solver
