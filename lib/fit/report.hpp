#pragma once
/// A fit as the `material:` block of a design, with units, errors in comments, and the origin of the data under `fit:`.
/// Tested by fit/report_test and, with mesh-gen, by tests/pipeline/fit.sh.
#include <string>

#include "fit/rank.hpp"

namespace soft::fit {

/// Further information for the report.
struct Provenance {
    std::string command_line = {};  ///< "fit-material 0.1.0 (revision): command line"; empty: omitted
    std::string notice = {};    ///< source and licence of the data, for a comment at the top; may contain line feeds
    std::string protocol = {};  ///< one line given by the user: test standard, rate; empty: omitted
};

/// Writes constants with ten digits, because large terms of opposite sign cancel in some laws.
[[nodiscard]] std::string material_yaml(const Fit& fit, const std::vector<TestCurve>& tests,
                                        const Provenance& provenance);

/// A readable table, one line per law.
[[nodiscard]] std::string rank_table(const std::vector<RankedFit>& ranked);

}  // namespace soft::fit
