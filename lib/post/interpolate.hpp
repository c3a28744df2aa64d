#pragma once
/// The path between its rows: one smooth curve through all of them, and where it crosses a value.
///
/// Between two rows every column is a cubic Hermite polynomial of one parameter t. The coordinates (pressure, outputs,
/// volume), each divided by its range, make the path a curve in the plane or in space. The solver gives its unit
/// directions u0, u1 at the rows; the speeds v0, v1 that belong to them solve, in the sense of least squares,
///     (v0 u0 + v1 u1) / 2 = q1 - q0,
/// so that a piece of any parabola is met exactly and any smooth path to fourth order (derived here). Where that has no
/// sound answer (a straight piece, whose directions are parallel, a point of inflection) both speeds are the length of the chord. A column beside the
/// coordinates that has slopes too (energies: the power of the loads) goes by the same speeds. Rows without
/// slopes, and columns that have none, take those of their rows (monotone_slopes.hpp: third order, each interval monotone).
/// The latter are cubics of the progress along the chord, (q(t) - q0) . (q1 - q0) / |q1 - q0|^2, which unlike t runs as
/// evenly as the path itself.
/// A change of stage is a corner: the slopes of rows belong to one stage, one-sided at both its ends, and a column is straight
/// where the stage is a single interval, of which no more is known. Of the coordinates the last row of a stage holds the
/// direction in which that stage has arrived, and the way on to the next row belongs to the next stage. There the piece is
/// the arc that leaves the chord as it arrives, known by u1 alone: m1 = v u1, m0 = 2 (q1 - q0) - m1,
/// v = |q1 - q0| / cos(chord, u1) (a parabola about its axis, third order; derived here). Where u1 is not within 60 degrees
/// of the chord, or a coordinate would turn back on the way, it is a straight line.
/// Of a motion the parameter is time itself, and the slopes, which are derivatives by time, stand for themselves: the cubic
/// through two rows meets values and velocities. Tested by post/interpolate_test and post/followers_test.
#include <span>
#include <vector>

#include "post/curve.hpp"

namespace soft::post {

/// Cubic on t in [0, 1] with values q0, q1 and slopes m0, m1 = dq/dt at the ends.
struct Hermite {
    double q0, q1, m0, m1;

    [[nodiscard]] double operator()(double t) const noexcept;
    /// Ends of the monotone pieces: 0, the interior extrema in order, 1.
    [[nodiscard]] std::vector<double> monotone_pieces() const;
};

/// A curve made continuous. The curve must outlive it.
class Path {
public:
    explicit Path(const Curve& curve);

    [[nodiscard]] double length() const noexcept { return s_.back(); }
    /// Parameters of the rows that move the path (a row equal to the one before it is left out).
    [[nodiscard]] std::span<const double> row_parameters() const noexcept { return s_; }
    [[nodiscard]] std::span<const std::size_t> rows() const noexcept { return rows_; }
    /// All columns at path parameter s in [0, length()], in the order of the curve.
    [[nodiscard]] std::vector<double> at(double s) const;
    /// All s at which the column, a coordinate, has `value` (column's unit), in the order of the path.
    [[nodiscard]] std::vector<double> crossings(std::size_t column, double value) const;
    struct Range {
        double lowest, highest;
    };
    /// Of the smooth curve, extrema between the rows included.
    [[nodiscard]] Range range(std::size_t column) const;
    /// `value`, or the end of the range that it misses by its millionth: a path that was to end at 130 mm ends at 129.9999999 mm.
    [[nodiscard]] double within_reach(std::size_t column, double value) const;

private:
    [[nodiscard]] double in_interval(std::size_t column, std::size_t interval, double t) const;

    const Curve* curve_;
    std::vector<std::size_t> rows_;             ///< distinct rows of the path
    std::vector<double> s_;                     ///< their parameters: mean speeds of the intervals, added up
    std::vector<std::vector<Hermite>> pieces_;  ///< [column][interval]; with slopes of t, the others of the progress
    std::vector<Hermite> progress_;             ///< of each interval, of t
};

}  // namespace soft::post
