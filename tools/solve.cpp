/// solve: computes the result of a case by following the equilibrium path R(u, p) = 0 of a pressurised hyperelastic body,
///     int P : grad(du) dV = pressure x (change of enclosed volume),   int dp (Theta(J) - p/kappa) dV = 0.
///     mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv
///     mpirun -n 2 solve case.h5 -o result.h5 -- -mat_mumps_icntl_14 120
#include <omp.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>

#include "cli.hpp"
#include "linalg/profile.hpp"
#include "linalg/session.hpp"
#include "ranks.hpp"
#include "solve_options.hpp"
#include "solve_run.hpp"
#include "solve_summary.hpp"

namespace soft::cli {
namespace {

ExitCode solve_one(const SolveOptions& options) {
    if (options.resume.empty()) check_output(options.common.output, Content::binary);
    const linalg::Session session{options.petsc};
    if (options.profile) linalg::start_profile();
    return run_on_all_ranks(session.rank(), session.size(), [&] { return run_solve(options, session); });
}

/// After such an error the state of the libraries is undefined.
bool is_fatal(ExitCode code) { return code == ExitCode::internal || code == ExitCode::io_error; }

constexpr std::size_t max_batch_line = std::size_t{1} << 20;  // bytes

/// Reads the next line of stdin; false at the end. A line that is too long is truncated to one byte more than the maximum.
bool read_line(std::string& line) {
    line.clear();
    std::streambuf& input = *std::cin.rdbuf();
    int c = input.sbumpc();
    const bool has_line = c != std::char_traits<char>::eof();
    for (; c != std::char_traits<char>::eof() && c != '\n'; c = input.sbumpc())
        if (line.size() <= max_batch_line) line += static_cast<char>(c);
    return has_line;
}

/// Solves the lines of stdin one after the other. Errors are reported and the next line follows, except after ExitCode::internal
/// and io_error, which end the process. Returns the exit code that ended it, else that of the first line that failed.
ExitCode solve_batch(const SolveOptions& batch) {
    const linalg::Session session{batch.petsc};
    if (session.size() > 1) throw Error(ExitCode::usage, "--batch", "runs on one rank only", "omit mpirun");
    omp_set_num_threads(1);  // many batches run side by side
    ExitCode first = ExitCode::ok;
    ProcessTimes before;  // the first line includes the start-up time
    for (std::string line; read_line(line);) {
        const auto begin = std::chrono::steady_clock::now();
        const auto solve_line = [&] {
            const StdoutRedirection kept;  // also for --help
            if (line.size() > max_batch_line)
                throw Error(ExitCode::usage, "--batch", "a line is longer than 1 MiB", "for example CASE -o FILE");
            auto options = parse_batch_line(line);
            if (!options) return ExitCode::ok;
            options->cpu_before_s = before.user_s + before.system_s;
            return run_solve(*options, session);
        };
        const ExitCode code =
            report_errors(solve_about().tool, std::string{solve_about().tool} + " " + line, solve_line);
        if (first == ExitCode::ok) first = code;
        const ProcessTimes now = process_times();
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        std::array<char, 128> answer{};
        const int size = std::snprintf(answer.data(), answer.size(), "%d %.3f %.3f %.3f\n", static_cast<int>(code),
                                       now.user_s - before.user_s, now.system_s - before.system_s, wall.count());
        const auto bytes = std::as_bytes(std::span(answer).first(static_cast<std::size_t>(size)));
        if (core::write_all(STDOUT_FILENO, bytes, "<stdout>") == core::WriteStatus::reader_closed) break;
        if (is_fatal(code)) return code;  // further lines have not been solved
        before = now;
    }
    return first;
}

ExitCode solve(const SolveOptions& options) { return options.batch ? solve_batch(options) : solve_one(options); }

}  // namespace
}  // namespace soft::cli

int main(int argc, char** argv) {
    soft::linalg::choose_blas_kernel(argv);
    return soft::cli::run_guarded(argc, argv, soft::cli::parse_solve_options, soft::cli::solve);
}
