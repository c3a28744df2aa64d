#include "fit/rank.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"

namespace soft::fit {
namespace {

double root_mean_square(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

std::size_t row_count(const std::vector<TestCurve>& tests) {
    std::size_t rows = 0;
    for (const TestCurve& test : tests) rows += test.stretch.size();
    return rows;
}

bool has_enough_rows(const Candidate& candidate, const std::vector<TestCurve>& tests) {
    // AICc needs two rows more than unknowns and variance; one offset per test is counted too.
    return row_count(tests) > static_cast<std::size_t>(candidate.linear + candidate.shapes) + 2 + tests.size();
}

std::vector<CrossPrediction> predictions_of(const Candidate& candidate, const std::vector<TestCurve>& tests,
                                            const Settings& settings) {
    std::set<Mode> modes;
    for (const TestCurve& test : tests) modes.insert(test.mode);
    std::vector<CrossPrediction> predictions;
    if (modes.size() < 2) return predictions;
    for (const Mode mode : modes) {
        std::vector<TestCurve> others, left_out;
        for (const TestCurve& test : tests) (test.mode == mode ? left_out : others).push_back(test);
        if (!has_enough_rows(candidate, others)) continue;
        const Fit fitted = fit(candidate, others, settings);
        for (const TestCurve& test : left_out) {
            const double rmse_Pa = prediction_rmse_Pa(fitted, test);
            predictions.push_back({mode, rmse_Pa, rmse_Pa / root_mean_square(test.nominal_Pa)});
        }
    }
    return predictions;
}

void sort(std::vector<RankedFit>& ranked) {
    std::stable_sort(ranked.begin(), ranked.end(), [](const RankedFit& a, const RankedFit& b) {
        if (a.fit.stable != b.fit.stable) return a.fit.stable;
        return a.fit.aicc < b.fit.aicc;
    });
}

}  // namespace

std::vector<RankedFit> rank(const std::vector<TestCurve>& tests, const Settings& settings) {
    std::vector<RankedFit> ranked;
    for (const Candidate& candidate : candidates())
        if (has_enough_rows(candidate, tests))
            ranked.push_back({fit(candidate, tests, settings), predictions_of(candidate, tests, settings)});
    if (ranked.empty())
        ranked.push_back({fit(candidates().front(), tests, settings), {}});  // throws the error about too few rows
    sort(ranked);
    return ranked;
}

std::vector<RankedFit> rank_by(const std::function<Fit(const Candidate&)>& fit_of) {
    std::vector<RankedFit> ranked;
    for (const Candidate& candidate : candidates()) {
        try {
            ranked.push_back({fit_of(candidate), {}});
        } catch (const Error&) {
            continue;
        }
    }
    if (ranked.empty()) ranked.push_back({fit_of(candidates().front()), {}});  // throws
    sort(ranked);
    return ranked;
}

}  // namespace soft::fit
