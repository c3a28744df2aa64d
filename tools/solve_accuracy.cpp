#include "solve_accuracy.hpp"

#include <chrono>
#include <cmath>
#include <csignal>

#include "core/text.hpp"
#include "core/units.hpp"
#include "ranks.hpp"

namespace soft::cli {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

/// During its lifetime the first SIGINT or SIGTERM is recorded; the next one ends the process.
class SignalRecorder {
public:
    SignalRecorder() {
        caught_signal = 0;
        struct sigaction note {};
        note.sa_handler = [](int signal) { caught_signal = signal; };
        note.sa_flags = static_cast<int>(SA_RESETHAND);
        install(SIGINT, note, interrupt_);
        install(SIGTERM, note, terminate_);
    }
    SignalRecorder(const SignalRecorder&) = delete;
    SignalRecorder& operator=(const SignalRecorder&) = delete;
    ~SignalRecorder() {
        sigaction(SIGINT, &interrupt_, nullptr);
        sigaction(SIGTERM, &terminate_, nullptr);
    }

private:
    /// Signals that are ignored, for example under nohup, stay ignored.
    static void install(int signal, const struct sigaction& note, struct sigaction& before) {
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &note, nullptr);
    }

    struct sigaction interrupt_ {
    }, terminate_{};
};

/// "40 s", "6 min", "2 h": at most two digits, since it is an estimate.
std::string duration_text(double seconds) {
    if (seconds < 90) return core::rounded_text(std::max(seconds, 1.0), seconds < 9.5 ? 1 : 2) + " s";
    if (seconds < 5400) return core::rounded_text(seconds / 60, 2) + " min";
    return core::rounded_text(seconds / 3600, 2) + " h";
}

/// Estimated ratio of the solution times of two meshes. Direct factorisation costs n^1.5 in 2-D and n^2 in 3-D, assembly n.
double cost_ratio(const solver::NextMesh& next, int dimension) {
    const double growth = static_cast<double>(next.unknowns) / static_cast<double>(next.unknowns_before);
    return std::pow(growth, dimension == 2 ? 1.25 : 1.6);
}

std::string next_text(const solver::NextMesh& next, double estimate_s) {
    return next.reason + "; solving " + core::counted(next.rows, "row") + " on mesh " + std::to_string(next.level) +
           " (all cells halved" + (next.level > 1 ? " " + std::to_string(next.level) + " times" : std::string()) +
           ", " + std::to_string(next.unknowns) + " unknowns, roughly " + duration_text(estimate_s) + ")";
}

std::string curve_text(const solver::Accuracy& accuracy, double tolerance) {
    const auto percent = [](double share) { return core::rounded_text(100 * share, 3) + " %"; };
    return "mesh " + std::to_string(accuracy.level) + ": error bars up to " + percent(accuracy.reached) +
           (accuracy.reached <= tolerance ? ", within " : ", above ") + percent(tolerance);
}

io::ResultWriter rows_of(const solver::Accuracy& accuracy, std::size_t points, const CurveOutput& output) {
    io::ResultWriter writer = output.rows_writer();
    // Refinement keeps the numbers of the points of the coarse mesh.
    for (const solver::RowState& row : accuracy.rows)
        writer.append(row.step, std::span(row.displacement_m).first(3 * points),
                      std::span(row.pressure_Pa).first(row.pressure_Pa.empty() ? 0 : points));
    return writer;
}

}  // namespace

void estimate_error(fem::System& system, std::vector<solver::RowState> rows, double tolerance, double path_s,
                    const CurveOutput& output, Console& console, SolveSummary& summary) {
    using Clock = std::chrono::steady_clock;
    const SignalRecorder note;
    const int dimension = system.input().mesh.dimension;
    const std::size_t points = system.input().mesh.points.size(), row_count = rows.size();
    double last_s = path_s;
    auto begin = Clock::now();
    solver::NextMesh mesh{};
    solver::RefinementListeners listeners;
    listeners.next = [&](const solver::NextMesh& next) {
        console.say(next_text(next, last_s * cost_ratio(next, dimension)));
        mesh = next;
        begin = Clock::now();
    };
    listeners.is_interrupted = [&](std::size_t row) {
        console.detail("mesh " + std::to_string(mesh.level) + ": row " + std::to_string(row) + " of " +
                       std::to_string(row_count));
        return broadcast_from_first_rank(caught_signal) != 0;
    };
    listeners.curve = [&](const solver::Accuracy& accuracy, const model::PathEnd& end) {
        if (accuracy.has_bars) {
            last_s = std::chrono::duration<double>(Clock::now() - begin).count();
            console.say(curve_text(accuracy, tolerance));
        }
        if (output.writer == nullptr) return;
        model::PathEnd so_far = end;
        so_far.detail += "; the refinement of --tolerance was not finished";
        output.writer->publish(rows_of(accuracy, points, output), so_far);
    };
    const solver::Accuracy accuracy =
        solver::refine_path(system, std::move(rows), summary.end, {.tolerance = tolerance}, listeners);
    summary.end.newton_iterations += accuracy.newton_iterations;
    summary.end.factorizations += accuracy.factorizations;
    summary.accuracy = {tolerance,         accuracy.reached,
                        accuracy.level,    accuracy.unknowns,
                        accuracy.has_bars, accuracy.end_reason,
                        accuracy.doubts,   accuracy.interrupted ? static_cast<int>(caught_signal) : 0};
    summary.last = accuracy.rows.back().step;
    if (output.writer != nullptr) output.writer->publish(rows_of(accuracy, points, output), summary.end);
}

}  // namespace soft::cli
