#pragma once
/// Input and errors of a program that runs on several MPI ranks.
#include <functional>
#include <string>

#include "cli.hpp"

namespace soft::cli {

/// Rank 0 reads (mpirun gives stdin to it alone), all ranks get the bytes. A failure to read ends all ranks alike.
[[nodiscard]] Input read_input_on_first_rank(const std::string& name, int rank);

/// The first rank's value, on every rank.
[[nodiscard]] double of_first_rank(double value);

/// Runs `body` on every rank. On one rank errors pass through. On several, the first rank's error is printed once and
/// ends all ranks with its exit code, since the others may wait for it for ever.
[[nodiscard]] ExitCode on_all_ranks(int rank, int size, const std::function<ExitCode()>& body);

}  // namespace soft::cli
