#pragma once
/// A fit as the `material:` block of a design, with units, errors behind # and what it rests on under `fit:`.
/// Tested by fit/report_test; that mesh-gen takes it by tests/pipeline/fit.sh.
#include <string>

#include "fit/rank.hpp"

namespace soft::fit {

/// What the report says beside the fit.
struct Provenance {
    std::string command_line = {};  ///< "fit-material 0.1.0 (revision): line as typed"; empty: left out
    std::string notice = {};        ///< source and licence of the data, a comment at the top; may hold line feeds
    std::string protocol = {};      ///< one line: test standard, rate, as the user says it; empty: left out
};

/// Ten digits: large terms of opposite sign cancel in some laws.
[[nodiscard]] std::string material_yaml(const Fit& fit, const std::vector<TestCurve>& tests,
                                        const Provenance& provenance);

/// A table for people, one law a line.
[[nodiscard]] std::string rank_table(const std::vector<Ranked>& ranked);

}  // namespace soft::fit
