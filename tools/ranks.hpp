#pragma once
/// Input and error handling on several MPI ranks.
#include <functional>
#include <string>

#include "cli.hpp"

namespace soft::cli {

/// Rank 0 reads (mpirun passes stdin only to it) and broadcasts the bytes to all ranks. A read error ends all ranks.
[[nodiscard]] Input read_input_on_first_rank(const std::string& name, int rank);

/// Returns the value of rank 0 on every rank.
[[nodiscard]] double broadcast_from_first_rank(double value);

/// Runs `body` on every rank. On one rank exceptions propagate. On several ranks an error is printed once and MPI_Abort ends all
/// ranks with its exit code, since the other ranks may be waiting in a collective call.
[[nodiscard]] ExitCode run_on_all_ranks(int rank, int size, const std::function<ExitCode()>& body);

}  // namespace soft::cli
