#pragma once
/// Checks the stop reason of a path from the rows and the fields of the last rows only, without the solver's tangent, events or contact
/// search. Tested by Pipeline.CampaignConfirmsTheStopReasons, also with false reasons. A reason is confirmed as follows:
///   done              the loads of the last stage, or a goal of it, are reached
///   limit_point       the load factor has a maximum below 1 within the rows, and the path exceeds path.stretch_limit after it; or the
///                     controlled quantity has a maximum at the last row, by the slopes of the last four rows; or, at ten times the
///                     stretch limit, the extrapolated power law of the load's growth stays below the requested load
///   self_contact      pieces of the deformed surface that are not adjacent and belong to different cells intersect (CGAL), or a crease
///                     closes, or a facet crosses a symmetry plane from the outside, in the last row or after extrapolating the last step
///   inverted_element  the smallest det F, sampled at corners, mid nodes and centres of the cells, is nearly zero
///   step_limit        the number of rows equals the limit
///   diverged          never: every diverged path is a finding
/// The rows must also be consistent (consistency.hpp).
#include <string>

#include "io/result_file.hpp"

namespace soft::campaign {

struct Verdict {
    bool confirmed = false;
    std::string reason;  ///< short text with the values
};

[[nodiscard]] Verdict confirm(const io::Result& result);

}  // namespace soft::campaign
