#pragma once
/// The Taylor polynomial of the path at the start of a stage,
///   y(q) = y0 + s y1 + s^2 y2 + s^3 y3,  s = q - q0,  y = (x, load factor, pressures of the free supplies),
/// in place of a row before the first: the first step is as long as that of a later row. y1 is the tangent. With the bordered matrix M
/// at y0 (newton.hpp) and the miss m = (-R, -e_k, q - c) of a polynomial at small s, terms of higher order of the path follow one after
/// the other: M^-1 m(y0 + s y1) = s^2 y2 + O(s^3), M^-1 m(y0 + s y1 + s^2 y2) = s^3 y3 + O(s^4). The cubic term of the first is
/// eliminated with its value at s/2. Five residuals and four solves with a known factor or a few more, a tenth of a row.
/// Source: Cochelin, Damil and Potier-Ferry, Int. J. Numer. Methods Eng. 37 (1994) 1187 (there with analytic terms).
/// Tested by solver/series_test.
#include <optional>

#include "solver/corrector.hpp"

namespace soft::solver {

struct Series {
    PathPoint
        behind;  ///< on the polynomial behind the start, with its values: the cubic through both is the polynomial
    /// Of q, signed. Where the polynomial misses the path by SolverSettings::step_accuracy of the step, estimated by solves at about this distance
    /// and at half of it.
    double reach;
};

/// At the state of the last Newton::tangent(), under the path's control; `small`: s, signed; `longest`: bound of the reach. nullopt
/// where the terms are lost in rounding, or the series does not hold at `small`.
[[nodiscard]] std::optional<Series> series_at(Corrector& corrector, const PathState& path, const PathPoint& start,
                                              double small, double longest);

}  // namespace soft::solver
