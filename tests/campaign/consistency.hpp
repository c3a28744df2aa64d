#pragma once
/// What the rows of any result must not do, whatever ends its path: judged by the rows and the displacements alone.
///   energies    work of the loads and stored energy of a static path differ by no more than 1 % of the largest of them
///   motions     a face that is moved lies between where it was and where it is to be, at the end of a path that is done there
///   tiny loads  a body that nowhere stretches by 1e-6 behaves linearly: its path is done, and within a few rows
/// Tested by campaign/consistency_test.
#include <span>
#include <string>

#include "io/result_file.hpp"

namespace soft::campaign {

/// What is wrong with the result, in a few words with the numbers; empty where nothing is.
[[nodiscard]] std::string inconsistency(const io::Result& result);

/// Of its rows alone: energies and tiny loads.
[[nodiscard]] std::string inconsistency(const model::Case& model, std::span<const solution::Step> rows,
                                        solution::StopReason end);

}  // namespace soft::campaign
