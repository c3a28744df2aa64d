#pragma once
/// Is the reason true for which a path says that it has ended? Judged by the rows and the fields of the last ones alone,
/// without the solver's tangent, events or contact search. Tested by Pipeline.ACampaignConfirmsWhyPathsEnd, which plants
/// false reasons.
///   done              the last stage's loads are in place, or a value that it was to end at
///   limit_point       the load, at full length one, passes a maximum within the rows and the path comes to path.stretch_limit behind
///                     it; or what the control lets grow has a maximum at the last row, by the slopes of the last four; or, at
///                     ten times the stretch limit, the power with which the load's rise falls ends below the load asked for
///   self_contact      pieces of the deformed surface that are no neighbours and of different cells meet (CGAL), or a crease closes,
///                     or a facet passes a mirror with the air before it, in the last row or soon after it, the last step drawn out
///   inverted_element  the least det F, sampled at corners, mid nodes and centres of the cells, is next to nothing
///   step_limit        so many rows there are
/// and only of rows without a contradiction (consistency.hpp).
///   diverged          never: whatever ends so is a find
#include <string>

#include "io/result_file.hpp"

namespace soft::campaign {

struct Verdict {
    bool confirmed = false;
    std::string why;  ///< in a few words, with the numbers
};

[[nodiscard]] Verdict confirm(const io::Result& result);

}  // namespace soft::campaign
