#pragma once
/// All laws on the same tests, the best first: those stable up to the largest I1 of the data before the others, each by
/// AICc (Hurvich and Tsai, Biometrika 76 (1989) 297), which punishes constants. Residuals along a curve are correlated, so
/// AICc favours more constants than a fair count of independent rows would: a small difference decides nothing. Where there
/// are two modes or more, each is also predicted from the others, which says more. Tested by fit/rank_test.
#include "fit/fit.hpp"

namespace soft::fit {

struct CrossPrediction {
    Mode mode = Mode::uniaxial;  ///< left out of the fit
    double rmse_Pa = 0;
    double relative = 0;  ///< to the root mean square of its stress
};

struct Ranked {
    Fit fit;
    std::vector<CrossPrediction> predictions;  ///< empty for one mode
};

/// Laws with too many constants for the rows are left out. Throws as fit() where none is left.
[[nodiscard]] std::vector<Ranked> rank(const std::vector<TestCurve>& tests, const Settings& settings = {});

}  // namespace soft::fit
