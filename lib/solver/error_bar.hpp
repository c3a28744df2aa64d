#pragma once
/// Estimate of the discretisation error of a curve from the same rows on the next mesh, every cell halved.
///
/// A row is the same point of the path on the reported mesh (level k) and on the finer one: load p and measure m
/// (an output, or the volume). Divided by their ranges they make the path a plane curve with unit tangent (cos a, sin a) in
/// (m, p). A shift along the tangent gives another point of the same curve; the discretisation moves the curve across the tangent:
///     d = cos a (p_k - p_{k+1}) - sin a (m_k - m_{k+1})
/// so that the difference in load at equal m is d / cos a and the difference in m at equal load is d / sin a.
///
/// Where differences fall by a factor rho = 2^r per level, the error of level k is d rho / (rho - 1): 1.07 d for r = 4 (second-order
/// cells, smooth solution), 2 d for r = 1 (a corner of incompressible rubber), 2.5 d for r = 0.74 (such a corner at large strain; the
/// order of Cook's membrane falls to 0.65 from mesh to mesh).
///
/// Two meshes show no order. Where curves cross, d passes through zero but the error does not. The bar is therefore
///     2.5 s (max r - min r),   r = d / s and 0, times a weight, over the rows nearby,
/// where s is the distance from the start of the path, 'nearby' is a quarter of its length either way, and the weight falls from 1 to
/// 0.1. On a mesh with one cell through its walls (Walls::single_cell) it is 1.5 times that: there the parts of the error cancel most.
///
/// Where the next coarser level gives d', the error is the sum of two parts, a slow one (rho = 5/3) and a fast one (rho = 16), of any
/// signs, whose sums are d' and d:
///     e = 2.5 (d - f) + 1.07 f,   f = (d' - 5/3 d) / (16 - 5/3),
/// and the bar is 1.2 times the larger of |e| and 1.07 |d|. Where 5/3 <= d'/d <= 16, that covers every sum of parts of one sign
/// whose rates lie between, as rho / (rho - 1) is convex; it is at most 2.1 times the error of one rate. Where d' and d are of
/// opposite sign or |d'| is more than 16 |d|, a fast part of the coarse mesh nearly cancels a slow one in d: then d is small, the
/// error is not, and d' / 16 indicates the size of the parts. (Tube of designs/tube.yaml, 4 and 5 mm: d'/d = -100 to 100.)
/// Where the level before that gives d'', the error is also computed from three parts, the third with rho = 4, and the larger is used:
///     3.56 d - 0.69 d' + 0.033 d'',
/// unless the pairs (d'', d') and (d', d) are both `settled` at a rate, or the last pair has a ratio of 8 or more. (Triangles of
/// 6 mm in the same tube: differences of either sign on four levels, a bar of 0.53 of the error from two parts.)
///
/// An error from three meshes is not trusted where it passes through zero: the bar uses at least half of its root mean square over the
/// rows nearby, relative to s.
///
/// Near a limit point the load has no error in m at equal load. There the bar is the distance along the curve over which the load
/// changes by its error, computed from the curvature of the neighbouring rows. No bar is larger than the whole range.
/// Source: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307, for one rate; the treatment of limit points is derived here.
///
/// Calibrated on the 30 curves of sections and solids of verification/coverage_test, against formulas or finer meshes. Rows covered:
/// 569 of 573 by two meshes, 782 of 783 by three and four; median of bar over error 4.0 by two meshes, 2.3 of all rows. Missed: two
/// rows of a bellows with 6 mm cells (smallest bar 0.63 of the error), two of a clamped membrane with one cell through it (0.92), one
/// of triangles of 6 mm in a tube (0.94). The larger of 2.5 |d| at the row and half of the root mean square nearby covered 44 of the
/// 73 rows of the tube with one cell of 3 to 5 mm through its wall by two meshes (smallest 0.32 of the error).
#include <optional>
#include <span>
#include <vector>

namespace soft::solver {

struct CurvePoint {
    double load, measure;
};

struct LevelRow {
    CurvePoint reported, finer;
    std::optional<CurvePoint> before;   ///< level k - 1, if it was solved
    std::optional<CurvePoint> earlier;  ///< level k - 2, only where before is known
    CurvePoint tangent;  ///< derivative along the path, any positive scale; both 0: unknown, taken from the neighbours
};

/// Half widths, in the units of the row.
struct ErrorBar {
    double load, measure;
    /// d' and d of the neighbourhood are correlated (0.8 or more) and their ratio is 1.25 to 32, as where one rate dominates.
    /// Otherwise the bar relies on assumed rates. False without a coarser level.
    bool settled;
};

/// The part of a bar that comes from the solver's own tolerance, relative to the load and measure.
inline constexpr double solved_to = 1e-8;

/// Cells through the walls of the reported mesh.
enum class Walls { resolved, single_cell };

/// One bar per row, for the reported level.
[[nodiscard]] std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows, Walls walls = Walls::resolved);

}  // namespace soft::solver
