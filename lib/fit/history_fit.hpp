#pragma once
/// A law with viscoelasticity and softening (material/inelastic.hpp) fitted to tests with a time column: relaxation, creep, cycles and
/// ramps at several rates, all together. The measured strain drives the model, linear between the rows; the residuals are those of the
/// nominal stress. The constants of the law start from its elastic fit to the same rows, the relaxation times are spread evenly over the
/// times of the tests on a logarithmic scale; Ceres minimises the sum of squares with bounds from several starts. Unless the stability is
/// only reported, the constants have signs that suffice for it. A given law keeps its constants, which describe its long-term response.
/// Tested by fit/history_fit_test.
#include "fit/fit.hpp"

namespace soft::fit {

struct HistorySettings {
    int branches = 0;  ///< Maxwell elements; 0: no viscoelasticity
    bool softening = false;
    std::optional<Fit> elastic = {};  ///< given_law.hpp: only the other constants are fitted
};

/// The fit with its `inelastic` constants, their errors in `history`, and the predicted stress of every row. Flags in addition to those of
/// fit(): time-outside-data:<n> (a relaxation time below the shortest interval or above the length of the tests).
/// The candidate of a given law replaces `candidate`.
/// Throws Error (bad_input) for tests without times or in which time does not increase, too few rows, and for softening where no test unloads.
[[nodiscard]] Fit fit_history(const Candidate& candidate, const std::vector<TestCurve>& tests,
                              const HistorySettings& history, const Settings& settings = {});

}  // namespace soft::fit
