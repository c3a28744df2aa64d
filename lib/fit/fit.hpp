#pragma once
/// A law fitted to tests: constants, their errors, goodness of fit and stability.
/// Least squares of the nominal stress over all rows of all tests. The linear constants are solved exactly (bounded.hpp). The shapes
/// are searched by Ceres, a least-squares library with bounds on the unknowns, from several starts (for ogden the best of a dense
/// list of exponents for every pattern of signs). The result therefore does not depend on the unit, the order of the rows or an
/// initial guess. Tested by fit/fit_test, fit/treloar_test.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/candidates.hpp"
#include "fit/test_data.hpp"
#include "material/stability.hpp"

namespace soft::fit {

enum class Stability {
    /// The free fit if it is stable in every mode up to the largest I1 of the data, else the best fit with signs that suffice for
    /// stability.
    enforced,
    everywhere,  ///< the best fit with signs that suffice for stability at every stretch
    reported     ///< the free fit, stable or not
};
enum class RowWeights {
    uniform,  ///< equal weights: the noise of the nominal stress is nearly uniform
    relative  ///< 1 / max(s, weight_floor * largest s)
};
enum class Offset { none, fitted };  ///< fitted: a constant stress per test, within +- 10 kPa

struct Settings {
    Stability stability = Stability::enforced;
    RowWeights weights = RowWeights::uniform;
    double weight_floor = 0.05;  ///< limits the weight of the first rows, which contain the error of the load cell
    Offset offset = Offset::none;
};

/// Unbounded, an offset would absorb the error of the law.
inline constexpr double max_offset_Pa = 10e3;

struct Constant {
    std::string name;  ///< "mu"; with several terms "mu 1", "mu 2", ...
    double value = 0;  ///< SI
    /// From the covariance; a lower bound because residuals along a curve are correlated; 0 at a bound; infinite where the data determine
    /// only a combination with other constants.
    double standard_error = 0;
    bool is_stress = true;
};

/// A constant of viscoelasticity or softening.
struct HistoryConstant {
    std::string name;  ///< "modulus 1", "time 1", "r", "m", "beta"
    double value = 0, standard_error = 0;
    std::string unit;  ///< SI
};

struct TestQuality {
    Mode mode = Mode::uniaxial;
    std::string source;
    std::size_t rows = 0;
    double rmse_Pa = 0, max_Pa = 0;  ///< of the nominal stress, unweighted
    double r2 = 0;
    std::optional<double> offset_Pa = {};
};

struct Fit {
    Candidate candidate;
    material::Constants constants;  ///< as in a design
    std::vector<Constant> list;
    std::vector<double> covariance;  ///< of `list`, by rows [SI]
    std::vector<TestQuality> tests;
    std::size_t rows = 0;
    double rmse_Pa = 0, max_Pa = 0, r2 = 0;
    bool law_is_given = false;  ///< `list` was not fitted (history_fit.hpp)
    // Of fit_history; else empty.
    std::optional<material::Inelastic> inelastic = {};
    std::vector<HistoryConstant> history;           ///< its constants; `covariance` covers `list`, then these
    std::vector<std::vector<double>> predicted_Pa;  ///< nominal stress by test and row

    /// Largest error of the nominal stress relative to the measured one, over rows with at least 20 % strain (below that the zero
    /// error of the load cell dominates); nullopt without such rows.
    std::optional<double> max_relative_error = {};
    double aicc = 0;       ///< n ln(weighted sum of squares / n) + 2 k + 2 k (k+1)/(n-k-1)
    double max_I1 = 3;     ///< of the data: beyond it the law extrapolates
    double condition = 1;  ///< of the Jacobian with columns scaled to length 1
    std::vector<material::StabilityLimit>
        limits;           ///< first unstable stretch of each mode, searched beyond the data too
    bool stable = false;  ///< up to max_I1, in every mode
    /// unstable:<mode>@<stretch> (up to max_I1), mu0<=0, at-bound, ill-conditioned (condition > 1e4), offset>10% (of
    /// the stress at e = 0.25), signs-constrained, terms:<n> (fewer terms than requested suffice)
    std::vector<std::string> flags;

    /// [Pa]; NaN beyond the largest stretch of the law.
    [[nodiscard]] double nominal_stress_Pa(Mode mode, double stretch) const;
};

/// Throws Error (bad_input) unless there are more rows than constants, for a stress that does no positive work on the strain, and for
/// simple shear.
[[nodiscard]] Fit fit(const Candidate& candidate, const std::vector<TestCurve>& tests, const Settings& settings = {});

/// Root mean square of prediction - measurement [Pa].
[[nodiscard]] double prediction_rmse_Pa(const Fit& fit, const TestCurve& test);

}  // namespace soft::fit
