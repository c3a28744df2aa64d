#pragma once
/// Checks that every result must satisfy for any stop reason, from the rows and the displacements only:
///   energies    work of the loads and stored energy of a static path differ by at most 1 % of the largest of them
///   motions     a face with a prescribed displacement has moved by a fraction between 0 and 1 of it, and by all of it if the path is done
///   walls       in the last row no walls intersect, none crosses a symmetry plane, and no node is inside a smooth obstacle, where contact
///               is solved, by more than the contact distance
///   tiny loads  with strains below 1e-6 everywhere the response is linear: the path is done within a few rows
/// Tested by campaign/consistency_test.
#include <span>
#include <string>

#include "io/result_file.hpp"

namespace soft::campaign {

/// The first inconsistency of the result, as a short text with the values; empty if there is none.
[[nodiscard]] std::string inconsistency(const io::Result& result);

/// Checks the rows only: energies and tiny loads.
[[nodiscard]] std::string inconsistency(const model::Case& model, std::span<const model::Step> rows,
                                        model::StopReason end);

}  // namespace soft::campaign
