#pragma once
/// Interpolation of the path between its rows: one smooth curve through all rows, and its crossings of a value.
///
/// Between two rows every column is a cubic Hermite polynomial of one parameter t. The coordinates (pressure, outputs, volume), each
/// divided by its range, form a curve in the plane or in space. The solver provides its unit directions u0, u1 at the rows. The speeds
/// v0, v1 solve, in the least-squares sense,
///     (v0 u0 + v1 u1) / 2 = q1 - q0,
/// which reproduces any parabola exactly and any smooth path to fourth order (derived here). If this has no valid solution (parallel
/// directions on a straight piece, an inflection point), both speeds are the length of the chord. A dependent column with slopes
/// (energies: the power of the loads) uses the same speeds. Rows without slopes and columns without slopes use slopes estimated from
/// the rows (monotone_slopes.hpp: third order, each interval monotone). Columns without slopes are cubics of the progress along the
/// chord, (q(t) - q0) . (q1 - q0) / |q1 - q0|^2, which is more uniform along the path than t.
/// At a change of stage the path has a corner. Estimated slopes use the rows of one stage only, one-sided at both its ends, and are
/// linear in a stage with a single interval. The last row of a stage records the direction of that stage, and the interval to the next
/// row belongs to the next stage. In this interval the piece is the arc given by u1 alone: m1 = v u1, m0 = 2 (q1 - q0) - m1,
/// v = |q1 - q0| / cos(chord, u1) (a parabola about its axis, third order; derived here). It is a straight line if u1 is not within
/// 60 degrees of the chord, or if a coordinate would not be monotonic in the interval.
/// At a kink (Curve::kinks) the direction recorded is that after it: the interval before is the arc given by u0 alone, in the same way. In a
/// motion only the loads bend (Column::bends); displacements keep their velocity.
/// A column that jumps (Column::jumps) is, in the first interval of a stage, the line through its value and slope at the row after it, constant
/// if the stage has no other row; in an interval that ends at a kink, and is not the first of its piece, that at the row before it.
/// With a time the parameter is the time, and the slopes are time derivatives: the cubic through two rows interpolates values and
/// velocities. In the interval after a change of stage the velocity at its start is unknown: there it is the parabola with the velocity at
/// its end, or a straight line where that would turn. Tested by post/interpolate_test and post/dependent_columns_test.
#include <array>
#include <span>
#include <vector>

#include "post/curve.hpp"

namespace soft::post {

/// Fraction of an interval within which a point is the row at its end: the solver's tolerance along the path is smaller.
inline constexpr double at_a_row = 1e-6;

/// Cubic on t in [0, 1] with values q0, q1 and slopes m0, m1 = dq/dt at the ends.
struct Hermite {
    double q0, q1, m0, m1;

    [[nodiscard]] double operator()(double t) const noexcept;
    /// Ends of the monotone pieces: 0, the interior extrema in ascending order, 1.
    [[nodiscard]] std::vector<double> monotone_pieces() const;
};

/// Interpolant of a curve, continuous but for columns that jump. The curve must outlive it.
class Path {
public:
    explicit Path(const Curve& curve);

    [[nodiscard]] double length() const noexcept { return s_.back(); }
    /// Parameters of the distinct rows (a row equal to the previous one is omitted).
    [[nodiscard]] std::span<const double> row_parameters() const noexcept { return s_; }
    [[nodiscard]] std::span<const std::size_t> rows() const noexcept { return rows_; }
    /// All columns at path parameter s in [0, length()], in the order of the curve.
    [[nodiscard]] std::vector<double> at(double s) const;
    /// The values at the ends of the interval with s, as its cubic has them: those of another piece are left out (Column::jumps).
    [[nodiscard]] std::array<double, 2> ends(std::size_t column, double s) const;
    /// All s at which the column, a coordinate, has `value` (in the column's unit), in path order.
    [[nodiscard]] std::vector<double> crossings(std::size_t column, double value) const;
    struct Range {
        double lowest, highest;
    };
    /// Range of the smooth curve, including extrema between the rows.
    [[nodiscard]] Range range(std::size_t column) const;
    /// `value`, or the end of the range if `value` lies beyond it by at most a millionth of the range: a path with the goal 130 mm may
    /// end at 129.9999999 mm.
    [[nodiscard]] double within_reach(std::size_t column, double value) const;

private:
    [[nodiscard]] std::size_t interval_at(double s) const;
    [[nodiscard]] double in_interval(std::size_t column, std::size_t interval, double t) const;

    const Curve* curve_;
    std::vector<std::size_t> rows_;  ///< distinct rows of the path
    std::vector<double> s_;          ///< their parameters: cumulative mean speeds of the intervals
    std::vector<std::vector<Hermite>>
        pieces_;  ///< [column][interval]; functions of t, or of the progress for columns without slopes
    std::vector<Hermite> progress_;  ///< [interval], function of t
};

}  // namespace soft::post
