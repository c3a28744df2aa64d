#pragma once
/// Fits all laws to the same tests and sorts them, best first: laws that are stable up to the largest I1 of the data come before the
/// others, each group sorted by AICc (Hurvich and Tsai, Biometrika 76 (1989) 297), which penalises constants. Residuals along a curve
/// are correlated, so AICc favours more constants than the number of independent rows justifies: small differences are not
/// significant. With two or more modes, each is also predicted from the others, which is a stronger test. Tested by fit/rank_test.
#include <functional>

#include "fit/fit.hpp"

namespace soft::fit {

struct CrossPrediction {
    Mode mode = Mode::uniaxial;  ///< left out of the fit
    double rmse_Pa = 0;
    double relative = 0;  ///< rmse over the root mean square of the mode's stress
};

struct RankedFit {
    Fit fit;
    std::vector<CrossPrediction> predictions;  ///< empty for one mode
};

/// Omits laws with too many constants for the number of rows. Throws as fit() if no law remains.
[[nodiscard]] std::vector<RankedFit> rank(const std::vector<TestCurve>& tests, const Settings& settings = {});

/// The same with another fit of each law, without predictions. Laws that it refuses (Error) are omitted, unless it refuses all.
[[nodiscard]] std::vector<RankedFit> rank_by(const std::function<Fit(const Candidate&)>& fit_of);

}  // namespace soft::fit
