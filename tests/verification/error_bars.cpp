// The error bars of `solve --tolerance` on coarse meshes compared with the true errors of known curves.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/text.hpp"
#include "fem/system.hpp"
#include "inflation_formula.hpp"
#include "post/curve.hpp"
#include "post/interpolate.hpp"
#include "problem.hpp"
#include "solver/accuracy.hpp"

namespace soft::verification {
namespace {

/// A value of the curve with its error bar; all in the same unit.
struct BarPoint {
    double truth, ours, bar;
};

/// The rows with their error bars, on the given mesh or on the mesh refined once.
enum class Mesh { given, halved };

Run run_with_bars(const std::string& design, const std::vector<std::string>& sets, Mesh mesh) {
    Run run;
    run.model = read_case(design, sets);
    fem::System system(run.model, PETSC_COMM_WORLD);
    std::vector<solver::RowState> rows;
    run.end = solver::follow_path(system, {.step = [](const model::Step&, Vec) {},
                                           .row = [&](const solver::RowState& row) { rows.push_back(row); }});
    // The bound on the unknowns ends the refinement; the tolerance is never reached.
    const std::int64_t levels = mesh == Mesh::given ? 1 : 2, growth = run.model.mesh.dimension == 3 ? 8 : 4;
    const std::int64_t bound = 2 * system.dofs().total * (levels == 1 ? growth : growth * growth);
    const auto accuracy = solver::refine_path(system, std::move(rows), run.end,
                                              {.tolerance = 1e-12, .max_unknowns_2d = bound, .max_unknowns_3d = bound});
    if (!accuracy.has_bars) throw std::runtime_error(design + ": no error bars: " + accuracy.end_reason);
    for (const auto& row : accuracy.rows) run.steps.push_back(row.step);
    run.mesh = std::to_string(run.model.mesh.cell_count()) + " cells" + (mesh == Mesh::halved ? ", halved once" : "");
    return run;
}

using Pressure = std::function<double(double inner_stretch)>;

/// Every row after the first, compared at its volume.
std::vector<BarPoint> at_rows(const Run& run, const Pressure& exact, const std::function<double(double)>& stretch) {
    std::vector<BarPoint> found;
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const auto& step = run.steps[i];
        found.push_back({exact(stretch(*step.volume_m3)), step.pressure_Pa, *step.pressure_error_Pa});
    }
    return found;
}

struct Sphere {
    const char* design;
    double inner_m, outer_m;
    std::vector<std::string> sets;
};

std::vector<BarPoint> bars_of_sphere(const Sphere& sphere, Mesh mesh) {
    auto sets = sphere.sets;
    sets.push_back("geometry.inner_radius=" + core::number_text(1e3 * sphere.inner_m) + " mm");
    sets.push_back("geometry.outer_radius=" + core::number_text(1e3 * sphere.outer_m) + " mm");
    const auto run = run_with_bars("verification/" + std::string(sphere.design) + ".yaml", sets, mesh);
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(sphere.inner_m, 3);
    return at_rows(
        run, [&](double l) { return sphere_pressure_Pa(extra_stress, l, sphere.outer_m / sphere.inner_m); },
        [&](double v) { return std::cbrt(v / volume); });
}

std::vector<BarPoint> bars_of_cylinder(const char* design, double inner_m, double outer_m,
                                       const std::vector<std::string>& sets, Mesh mesh) {
    const auto run = run_with_bars("verification/" + std::string(design) + ".yaml", sets, mesh);
    const ExtraStress extra_stress = extra_stress_of(run.model.materials.front());
    const Cylinder cylinder{inner_m, outer_m, 1};
    const double volume = std::numbers::pi * inner_m * inner_m;  // of 1 m
    return at_rows(
        run, [&](double l) { return cylinder_pressure_Pa(extra_stress, cylinder, l); },
        [&](double v) { return std::sqrt(v / volume); });
}

/// Value and error bar at a given value of another quantity, in the units of the curve.
BarPoint bar_at(const Run& run, const std::string& fixed, double value, const std::string& wanted, double truth) {
    const auto curve = post::make_curve(run.model, run.steps);
    const auto index = [&](const std::string& name) {
        return static_cast<std::size_t>(curve.find(name) - curve.columns.data());
    };
    const post::Path path(curve);
    const auto crossings = path.crossings(index(fixed), value);
    const double end = run.steps.empty() ? 0.0 : curve.columns[index(fixed)].values.back();
    if (crossings.empty() &&
        std::abs(end - value) > 1e-8 * std::abs(value))  // the last row reaches the goal up to rounding
        throw std::runtime_error("the path never has this " + fixed + ", it ends at " + core::number_text(end));
    const auto row = path.at(crossings.empty() ? path.length() : crossings.front());
    return {truth, row[index(wanted)], row[index(wanted + "_error")]};
}

std::vector<BarPoint> bars_of_tube(const std::vector<std::string>& sets, Mesh mesh) {
    const auto run = run_with_bars("verification/tube.yaml", sets, mesh);
    std::vector<BarPoint> found;
    for (const auto& [pressure_kPa, elongation_mm] :
         std::vector<std::pair<double, double>>{{10, 0.2817}, {20, 0.9168}, {30, 2.2875}, {40, 5.8978}})
        found.push_back(bar_at(run, "pressure", pressure_kPa, "elongation", elongation_mm));
    const auto& limit = run.end.limit_points.at(0);
    found.push_back({44.3387, 1e-3 * limit.pressure_Pa,
                     1e-3 * *run.steps.at(static_cast<std::size_t>(limit.step)).pressure_error_Pa});
    return found;
}

std::vector<BarPoint> bars_of_bellows(const std::vector<std::string>& sets, Mesh mesh) {
    auto all = sets;
    all.push_back("loads.cavity.sealed=false");
    const auto run = run_with_bars("verification/bellows.yaml", all, mesh);
    std::vector<BarPoint> found;
    for (const auto& [elongation_mm, pressure_kPa] :
         std::vector<std::pair<double, double>>{{20, 1.38862}, {40, 3.31042}, {80, 10.06423}, {130, 26.49325}})
        found.push_back(bar_at(run, "elongation", elongation_mm, "pressure", pressure_kPa));
    return found;
}

struct BarCase {
    std::string name;
    std::function<std::vector<BarPoint>(Mesh)> points;
    std::vector<Mesh> meshes{Mesh::halved};  ///< the mesh reported if a third mesh is affordable
};

std::vector<BarCase> bar_cases() {
    const auto sphere = [](const char* name, Sphere s) {
        return BarCase{std::string("bars, ") + name, [s](Mesh mesh) { return bars_of_sphere(s, mesh); }};
    };
    const Sphere eighth{"sphere-neo-hookean",
                        10e-3,
                        20e-3,
                        {"model=quarter", "mesh.size=8 mm", "mesh.sectors=2", "path.until.volume_ratio=6"}};
    const char* neo = "sphere-neo-hookean";
    return {
        sphere("sphere B/A = 2, neo-Hookean", {neo, 10e-3, 20e-3, {"mesh.size=5 mm"}}),
        sphere("sphere B/A = 1.1, neo-Hookean", {neo, 10e-3, 11e-3, {"mesh.size=5 mm"}}),
        sphere("sphere B/A = 2, Mooney-Rivlin", {"sphere-mooney-rivlin", 10e-3, 20e-3, {"mesh.size=5 mm"}}),
        sphere("sphere B/A = 2, Yeoh", {"sphere-yeoh", 10e-3, 20e-3, {"mesh.size=5 mm"}}),
        sphere("sphere B/A = 2, neo-Hookean, triangles",
               {neo, 10e-3, 20e-3, {"mesh.size=5 mm", "mesh.cells=simplices"}}),
        {"bars, sphere B/A = 2, neo-Hookean, solid eighth",
         [eighth](Mesh mesh) { return bars_of_sphere(eighth, mesh); },
         {Mesh::given}},  // a third solid mesh takes minutes
        {"bars, plane-strain cylinder B/A = 2, neo-Hookean",
         [](Mesh mesh) { return bars_of_cylinder("cylinder-neo-hookean", 10e-3, 20e-3, {"mesh.size=8 mm"}, mesh); }},
        {"bars, plane-strain cylinder 7 / 18.625 m, Mooney-Rivlin",
         [](Mesh mesh) { return bars_of_cylinder("cylinder-mooney-rivlin", 7, 18.625, {"mesh.size=6 m"}, mesh); }},
        {"bars, closed tube",
         [](Mesh mesh) {
             return bars_of_tube({"mesh.size=3 mm", "solver.step_accuracy=5e-4"}, mesh);
         }},
        // The first two differences between meshes have opposite signs, or differ by a factor of a hundred.
        {"bars, closed tube, 4 mm cells",
         [](Mesh mesh) {
             return bars_of_tube({"mesh.size=4 mm", "solver.step_accuracy=5e-4"}, mesh);
         }},
        {"bars, closed tube, 5 mm cells",
         [](Mesh mesh) {
             return bars_of_tube({"mesh.size=5 mm", "solver.step_accuracy=5e-4"}, mesh);
         }},
        {"bars, bellows, open",
         [](Mesh mesh) {
             return bars_of_bellows({"mesh.size=3 mm", "solver.step_accuracy=5e-4"}, mesh);
         }},
    };
}

/// Statistics of a list of error bars.
struct Score {
    double max_error = 0, max_bar = 0;  ///< relative to the largest value of the curve
    double min_ratio = 1e300;           ///< smallest ratio of bar to error
    double width = 0;                   ///< ratio of the root mean squares of bars and errors
    double median = 0;                  ///< of the ratio of bar to error
    int covered = 0;
};

Score score_of(const std::vector<BarPoint>& found) {
    Score score;
    double largest = 0, bars = 0, errors = 0;
    for (const BarPoint& j : found) largest = std::max(largest, std::abs(j.truth));
    for (const BarPoint& j : found) {
        const double error = std::abs(j.ours - j.truth);
        score.max_error = std::max(score.max_error, error / largest);
        score.max_bar = std::max(score.max_bar, j.bar / largest);
        score.min_ratio = std::min(score.min_ratio, j.bar / error);
        score.covered += j.bar >= error ? 1 : 0;
        bars += j.bar * j.bar;
        errors += error * error;
    }
    score.width = std::sqrt(bars / errors);
    std::vector<double> ratios;
    for (const BarPoint& j : found) ratios.push_back(j.bar / std::abs(j.ours - j.truth));
    std::ranges::sort(ratios);
    score.median = ratios[ratios.size() / 2];
    return score;
}

/// Largest allowed width of the bars. With two meshes the lowest order is assumed, which overestimates the error of a smooth solution 2.3
/// times, and by another half for one cell through the wall.
double max_width(Mesh mesh) { return mesh == Mesh::given ? 5 : 3; }

Outcome solve_case(const BarCase& bar_case) {
    Outcome outcome;
    outcome.tables.push_back(
        {bar_case.name,
         "Error bars compared with true errors of the load: at every row of the path if there is a formula, else at "
         "the points of the reference (tube: errors of the elongation and of the limit pressure). Errors and bars in "
         "per cent of the largest value; smallest ratio of bar to error; root mean square of the bars over that of "
         "the errors.",
         {"mesh", "points", "largest error [%]", "largest error bar [%]", "smallest bar / error", "bars / errors, rms"},
         {}});
    for (const Mesh mesh : bar_case.meshes) {
        const auto begin = std::chrono::steady_clock::now();
        const auto found = bar_case.points(mesh);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const Score score = score_of(found);
        const std::string name = mesh == Mesh::given ? "coarse mesh" : "halved once";
        outcome.rows.push_back({.quantity = "points covered by their bars, " + name,
                                .reference = static_cast<double>(found.size()),
                                .source = "all points",
                                .ours = static_cast<double>(score.covered),
                                .mesh = name,
                                .seconds = seconds});
        outcome.rows.push_back(
            {.quantity = "width of the bars (" + core::number_text(max_width(mesh)) + " if less), " + name,
             .reference = max_width(mesh),
             .source = "at most",
             .ours = std::max(max_width(mesh), score.median),
             .mesh = name,
             .seconds = seconds});
        outcome.tables.back().lines.push_back(
            {name, std::to_string(found.size()), core::rounded_text(100 * score.max_error, 3),
             core::rounded_text(100 * score.max_bar, 3), core::rounded_text(score.min_ratio, 3),
             core::rounded_text(score.width, 3)});
    }
    return outcome;
}

}  // namespace

std::vector<Problem> error_bar_problems() {
    std::vector<Problem> problems;
    for (const BarCase& bar_case : bar_cases())
        problems.push_back({"Error bars", bar_case.name, [bar_case] { return solve_case(bar_case); }});
    return problems;
}

}  // namespace soft::verification
