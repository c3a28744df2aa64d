#pragma once
/// How far a curve is from that of the continuous body, judged from the same rows on the next mesh, every cell halved.
///
/// A row holds the same point of the path on the mesh that is reported (level k) and on the finer one: load p and measure m
/// (an output, or the volume). Divided by their ranges they make the path a plane curve with unit tangent (cos a, sin a) in
/// (m, p). What lies along the tangent is another point of the same curve; the discretisation moves it across:
///     d = cos a (p_k - p_{k+1}) - sin a (m_k - m_{k+1})
/// so that the difference in load at equal m is d / cos a and that in m at equal load d / sin a.
///
/// Where differences fall by rho = 2^r a level, level k is off by d rho / (rho - 1): 1.07 d for r = 4 (second-order cells,
/// smooth solution) to 2 d for r = 1 (a singular corner of incompressible rubber). The bar is
///     2.2 |d|           covers every r >= 0.87, at most 2.1 times the error.
/// Where the level before gives d' and it has the sign of d all about, rho = |d'| / |d| is known, and with it how much of d
/// may be slow: rho / (rho - 1) is convex, so that its chord from rho = 2 (r = 1) to 16 (r = 4) covers every sum of parts of
/// one sign that fall at rates from 1 to 4. The bar is 1.2 times that: it only ever narrows.
/// Parts of opposite sign that nearly cancel in d over a whole neighbourhood make the bar of two meshes too short: measured
/// 0.36 of the error (closed tube of verification/tube.yaml with 3 mm cells). So does a mesh too coarse for any rate: 0.37 of
/// the error (verification/bellows.yaml with 3 mm cells, one through the bent wall). Both are covered once halved, which is why
/// refine_path (accuracy.hpp) reports the given mesh itself only where no third mesh is possible.
/// |d| is not trusted where it passes through zero: at least half of its root mean square over the neighbourhood in the
/// path (a quarter of its length either way, relative to the distance from the path's start) is taken.
///
/// Near a limit point the load has no error in m at equal load: there the bar is how far along the curve the load changes by
/// its error, by the curvature from the neighbouring rows. No bar is more than the whole range.
/// Source: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307, for one rate; the turn at limit points is derived here.
/// Held by solver/error_bar_test and the verification suite (group Error bars).
#include <optional>
#include <span>
#include <vector>

namespace soft::solver {

struct CurvePoint {
    double load, measure;
};

struct LevelRow {
    CurvePoint reported, finer;
    std::optional<CurvePoint> before;  ///< level k - 1, where it was solved
    CurvePoint tangent;  ///< derivative along the path, any positive scale; both 0: unknown, by neighbours
};

/// Half widths, in the units of the row.
struct ErrorBar {
    double load, measure;
};

/// The part of a bar that the solver's own tolerance makes, of the size of the load and measure.
inline constexpr double solved_to = 1e-8;

/// One bar a row, for the level that is reported.
[[nodiscard]] std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows);

}  // namespace soft::solver
