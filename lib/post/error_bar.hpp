#pragma once
/// How far a curve is from that of the continuous body, judged from the same path on three meshes, each the one before with
/// every cell halved.
///
/// A row holds the same point of the path on the three meshes: load p and measure m (an output, or the volume). Divided by
/// their ranges they make the path a plane curve with unit tangent (cos a, sin a) in (m, p). What lies along the tangent is
/// another point of the same curve; the discretisation moves it across:
///     c_k = cos a (p_k - p_2) - sin a (m_k - m_2),   d1 = c_0 - c_1,   d2 = c_1            (2: the finest mesh)
/// so that the error in load at equal m is c / cos a and that in m at equal load c / sin a.
///
/// One rate r would give rho = d1/d2 = 2^r and the finest mesh's error d2 / (rho - 1) (Richardson; Aitken). Energy norms
/// give rates of 2 k for cells of order k where the solution is smooth, and down to about 1 for singular corners (a clamped
/// edge or a sharp notch of incompressible rubber: twice the exponent of the corner, 2 x 0.54 to 2 x 0.59). Two such parts,
/// fast (2 k) and slow (1), give t = |(rho - 2)/(F - 1) + F - rho| / (F - 2) of d2, F = 2^(2k). Which of the two holds cannot
/// be told from three meshes, and they differ by up to 4: the geometric mean is taken, times 1.4. One rate of any size
/// between the two then makes a bar of 1.4 to 2.9 errors; two parts make one of at least 2/3 of the error, 1/2 where they
/// have opposite signs.
/// rho is the ratio of weighted root mean squares over the neighbourhood in the path (a quarter of its length either way,
/// differences relative to the distance from the path's start), since differences pass through zero where nothing converges
/// faster. Where d1 and d2 are not of one sign there (correlation below 1/2), or rho < 2, the rate was not measured, and the
/// last difference itself times 1.4 is the bar (more, by t at -rho, where the first difference is more than 5 times the last).
/// Where rho > F, t takes over the more, the larger rho is. No bar is below half of what the neighbourhood asks for.
///
/// Near a limit point the load has no error in m at equal load: there the bar is how far along the curve the load changes by
/// its error, by the curvature from the neighbouring rows.
/// Sources: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307; P. J. Roache, J. Fluids Eng. 116 (1994) 405 (factor of
/// safety); the two-rate form and the turn at limit points are derived here. Held by post/error_bar_test.
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace soft::post {

struct PathPoint {
    double load, measure;
};

struct LevelRow {
    std::array<PathPoint, 3> levels;  ///< coarse, halved once, halved twice
    PathPoint tangent;  ///< derivative along the finest path, any positive scale; both 0: unknown, by neighbours
};

/// Half widths, in the units of the row; empty where it would be more than the whole range (a plateau of the other one).
struct ErrorBar {
    std::optional<double> load, measure;
};

/// The part of a bar that the solver's own tolerance makes, of the size of the load and measure.
inline constexpr double solved_to = 1e-8;

/// One bar a row, for the finest mesh. `order` of the cells, 1 or 2. std::logic_error for another.
[[nodiscard]] std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows, int order);

}  // namespace soft::post
