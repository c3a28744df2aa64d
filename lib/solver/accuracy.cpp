#include "solver/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "mesh/single_layer.hpp"
#include "solver/refined_path.hpp"
#include "solver/row_bars.hpp"

namespace soft::solver {

namespace {

/// Fraction of the cells from which on a mesh counts as one with a single cell through its walls.
constexpr double single_cells = 0.1;

/// Fraction of the rows from which on it is reported that their differences decrease at no constant order.
constexpr double without_order = 0.25;

std::string percent(double share) { return core::rounded_text(100 * share, 3) + " %"; }

void require_refinable(const model::Case& input, const model::Step& step) {
    for (const auto type : input.mesh.cell_types)
        if (mesh::topology(type).order < 2)
            throw Error(
                ExitCode::bad_input, "--tolerance",
                "first-order cells have straight edges, which do not approach a curved boundary under refinement",
                "set mesh.order=2");
    if (step.outputs.empty() && !step.volume_m3)
        throw Error(ExitCode::bad_input, "--tolerance",
                    "the case has no output or volume whose error could be estimated", "define an output");
}

/// A mesh finer than the given one, with its case and system.
struct Level {
    Level(const model::Case& coarse, MPI_Comm comm)
        : refined(mesh::refine_once(coarse.mesh, mesh::Curve::circle)),
          input(with_mesh(coarse, refined.mesh)),
          system(input, comm) {}
    static model::Case with_mesh(model::Case input, const mesh::Mesh& mesh) {
        input.mesh = mesh;
        return input;
    }
    mesh::Refined refined;
    model::Case input;
    fem::System system;
};

RowPosition location_of(const Rows& rows, std::size_t i, const model::PathEnd& end) {
    if (i == 0) return RowPosition::first;
    const bool last =
        i + 1 == rows.size() ? end.reason == model::StopReason::done : rows[i + 1].step.stage != rows[i].step.stage;
    return last ? RowPosition::ends_stage : RowPosition::inside;
}

/// `level` 0 is the given mesh; every finer mesh has at least two cells through its walls.
Walls walls_of(const model::Case& input, int level) {
    std::vector<std::string> supported;
    for (const model::Support& support : input.supports) supported.push_back(support.face);
    return level == 0 && mesh::single_layer_fraction(input.mesh, supported) >= single_cells ? Walls::single_cell
                                                                                            : Walls::resolved;
}

std::vector<std::string> doubts_of(int level, Walls walls, const std::vector<ErrorBar>& bars) {
    if (level == 0) {
        std::vector<std::string> doubts{
            "they are based on two meshes, which do not show the order of convergence; a smaller "
            "--tolerance adds a third mesh"};
        if (walls == Walls::single_cell)
            doubts.emplace_back("the mesh has one cell through its walls; use two or more");
        return doubts;
    }
    const auto rows = static_cast<double>(bars.size());
    const auto without = std::ranges::count_if(bars, [](const ErrorBar& bar) { return !bar.settled; });
    if (static_cast<double>(without) < without_order * rows) return {};
    return {"the differences between the meshes decrease at no constant order at " + std::to_string(without) + " of " +
            core::counted(bars.size(), "row")};
}

/// The rows solved on a finer level, and why some are missing.
struct Solved {
    Rows rows;
    std::string failure;
    bool interrupted = false;
};

Solved solve_rows(Level& level, const Rows& coarse, const model::PathEnd& end, const RefinementListeners& listeners,
                  RefinedPath::Keep keep, Accuracy& counts) {
    Solved solved;
    RefinedPath path(level.system, level.refined);
    for (std::size_t i = 0; i < coarse.size() && solved.failure.empty(); ++i) {
        solved.interrupted = listeners.is_interrupted && listeners.is_interrupted(i);
        auto row = solved.interrupted ? std::nullopt : path.solve(coarse[i], location_of(coarse, i, end), keep);
        if (row)
            solved.rows.push_back(std::move(*row));
        else if (solved.interrupted)
            solved.failure = "the refinement was interrupted";
        else
            solved.failure = "row " + std::to_string(i) + " does not converge on the mesh with " +
                             std::to_string(level.system.dofs().total) + " unknowns";
    }
    counts.newton_iterations += path.work().iterations;
    counts.factorizations += path.work().factorizations;
    return solved;
}

/// Load, volume and outputs of a row, moved along its tangent by `way` of the tangent's parameter; the load by half of its
/// slope, which falls linearly to zero over this distance.
model::LimitPoint moved(int row, const model::Step& step, double way) {
    model::LimitPoint point{row, step.pressure_Pa + 0.5 * way * step.tangent_pressure, step.volume_m3, step.outputs};
    if (point.volume_m3) *point.volume_m3 += way * step.tangent_volume;
    for (std::size_t k = 0; k < point.outputs.size(); ++k) point.outputs[k] += way * step.tangent_outputs[k];
    return point;
}

/// The extremum of the load next to row i: where the slope by the volume (else the first output), interpolated linearly to the
/// neighbour on the side of the sign change, vanishes.
model::LimitPoint limit_beside(const Rows& rows, std::size_t i) {
    const model::Step& at = rows[i].step;
    const Measure measure{at.volume_m3 ? Measure::volume : 0};
    const auto slope = [&](const model::Step& step) {
        const CurvePoint tangent = measure.tangent(step);
        return tangent.load / tangent.measure;
    };
    for (const std::size_t other : {i - 1, i + 1}) {  // i - 1 wraps around for the first row and exceeds rows.size()
        if (other >= rows.size() || rows[other].step.stage != at.stage) continue;
        const model::Step& neighbour = rows[other].step;
        const double here = slope(at), there = slope(neighbour);
        if (!(here * there < 0.0)) continue;
        const double distance = measure.point(neighbour).measure - measure.point(at).measure;
        return moved(static_cast<int>(i), at, here / (here - there) * distance / measure.tangent(at).measure);
    }
    return moved(static_cast<int>(i), at, 0.0);
}

void move_points(const Rows& rows, model::PathEnd& end) {
    for (auto& point : end.limit_points) point = limit_beside(rows, static_cast<std::size_t>(point.step));
    for (auto& contact : end.first_contacts)
        contact.at = moved(contact.at.step, rows[static_cast<std::size_t>(contact.at.step)].step, 0.0);
    for (auto& bifurcation : end.bifurcations)
        bifurcation.at = moved(bifurcation.at.step, rows[static_cast<std::size_t>(bifurcation.at.step)].step, 0.0);
}

std::string bound_text(std::int64_t needed, std::int64_t bound) {
    return "the next mesh would have about " + std::to_string(needed) + " unknowns, more than the limit of " +
           std::to_string(bound);
}

/// Why another finer mesh is needed.
std::string reason_of(const Accuracy& result, double tolerance) {
    if (!result.has_bars) return "error bars need the same rows on a second mesh";
    return "the error bars of the load reach " + percent(result.reached) + ", " + percent(tolerance) + " is requested";
}

void report_curve(const RefinementListeners& listeners, const Accuracy& result, const model::PathEnd& end) {
    if (!listeners.curve) return;
    model::PathEnd moved_end = end;
    if (result.level > 0) move_points(result.rows, moved_end);
    listeners.curve(result, moved_end);
}

}  // namespace

Accuracy refine_path(fem::System& given, Rows rows, model::PathEnd& end, const AccuracyTarget& target,
                     const RefinementListeners& listeners) {
    const model::Case& input = given.input();
    require_refinable(input, rows.front().step);
    const bool solid = input.mesh.dimension == 3;
    const std::int64_t bound = solid ? target.max_unknowns_3d : target.max_unknowns_2d, growth = solid ? 8 : 4;
    Accuracy result;
    result.unknowns = given.dofs().total;
    result.rows = std::move(rows);
    report_curve(listeners, result, end);
    const model::Case* coarse = &input;
    std::unique_ptr<Level> level;
    Rows earlier, before, finer;  // the reported rows lie between the last two
    while (!result.has_bars || result.reached > target.tolerance) {
        const std::int64_t needed = growth * result.unknowns;
        if (needed > bound) {
            result.end_reason = bound_text(needed, bound);
            break;
        }
        auto next = std::make_unique<Level>(*coarse, given.comm());
        const std::int64_t unknowns = next->system.dofs().total;
        if (listeners.next)
            listeners.next({result.has_bars ? result.level + 2 : 1, unknowns, result.unknowns, result.rows.size(),
                            reason_of(result, target.tolerance)});
        const bool last = growth * unknowns > bound;  // no finer mesh will start from it
        Solved solved = solve_rows(*next, result.has_bars ? finer : result.rows, end, listeners,
                                   last ? RefinedPath::Keep::values : RefinedPath::Keep::fields, result);
        result.end_reason = solved.failure;
        result.interrupted = solved.interrupted;
        if (!result.end_reason.empty()) break;
        if (result.has_bars) {  // advance by one level
            earlier = std::move(before);
            before = std::exchange(result.rows, std::move(finer));
            ++result.level;
        }
        finer = std::move(solved.rows);
        result.unknowns = unknowns;
        const Walls walls = walls_of(input, result.level);
        const std::vector<ErrorBar> bars = set_bars(result.rows, {finer, before, earlier, walls});
        result.has_bars = true;
        result.reached = max_relative_bar(result.rows);
        result.doubts = doubts_of(result.level, walls, bars);
        result.finer.clear();
        for (const RowState& row : finer) result.finer.push_back(row.step);
        report_curve(listeners, result, end);
        level = std::move(next);
        coarse = &level->input;
    }
    if (result.level > 0) move_points(result.rows, end);
    return result;
}

}  // namespace soft::solver
