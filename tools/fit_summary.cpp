#include "fit_summary.hpp"

#include <nlohmann/json.hpp>

namespace soft::cli {
namespace {

using Json = nlohmann::ordered_json;

Json constants_json(const fit::Fit& fitted) {
    Json list = Json::array();
    for (const fit::Constant& constant : fitted.list)
        list.push_back({{"name", constant.name},
                        {"value", constant.value},
                        {"unit", constant.is_stress ? "Pa" : "1"},
                        {"standard_error", constant.standard_error}});
    for (const fit::HistoryConstant& constant : fitted.history)
        list.push_back({{"name", constant.name},
                        {"value", constant.value},
                        {"unit", constant.unit},
                        {"standard_error", constant.standard_error}});
    return list;
}

Json tests_json(const fit::Fit& fitted) {
    Json list = Json::array();
    for (const fit::TestQuality& test : fitted.tests) {
        list.push_back({{"mode", fit::name_of(test.mode)},
                        {"source", test.source},
                        {"rows", test.rows},
                        {"rmse_kPa", test.rmse_Pa / 1e3},
                        {"max_kPa", test.max_Pa / 1e3},
                        {"r2", test.r2}});
        if (test.offset_Pa) list.back()["offset_kPa"] = *test.offset_Pa / 1e3;
    }
    return list;
}

Json limits_json(const fit::Fit& fitted) {
    Json list = Json::array();
    for (const material::StabilityLimit& limit : fitted.limits)
        list.push_back({{"mode", fit::name_of(limit.mode)},
                        {"sense", limit.sense == material::Sense::tension ? "tension" : "compression"},
                        {"stretch", limit.stretch}});
    return list;
}

Json predictions_json(const fit::RankedFit& one) {
    Json list = Json::array();
    for (const fit::CrossPrediction& prediction : one.predictions)
        list.push_back({{"mode", fit::name_of(prediction.mode)},
                        {"rmse_kPa", prediction.rmse_Pa / 1e3},
                        {"relative", prediction.relative}});
    return list;
}

}  // namespace

Json fit_summary(const std::vector<fit::RankedFit>& ranked, const std::vector<fit::TestCurve>& tests) {
    Json json;
    for (const fit::TestCurve& test : tests)
        json["data"].push_back({{"source", test.source}, {"mode", fit::name_of(test.mode)}, {"sha256", test.sha256}});
    for (const fit::RankedFit& one : ranked) {
        const fit::Fit& fitted = one.fit;
        json["fits"].push_back(
            {{"name", fitted.candidate.name},
             {"law", fitted.candidate.law},
             {"constants", constants_json(fitted)},
             {"covariance", fitted.covariance},
             {"rows", fitted.rows},
             {"rmse_kPa", fitted.rmse_Pa / 1e3},
             {"max_kPa", fitted.max_Pa / 1e3},
             {"r2", fitted.r2},
             {"max_relative_error", fitted.max_relative_error ? Json(*fitted.max_relative_error) : Json(nullptr)},
             {"aicc", fitted.aicc},
             {"max_I1", fitted.max_I1},
             {"condition", fitted.condition},
             {"stable", fitted.stable},
             {"unstable", limits_json(fitted)},
             {"flags", fitted.flags},
             {"tests", tests_json(fitted)},
             {"predictions", predictions_json(one)}});
    }
    return json;
}

}  // namespace soft::cli
