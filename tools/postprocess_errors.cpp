#include "postprocess_errors.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft {
namespace {

/// Numbers of a design with their covariance.
struct Estimate {
    struct Number {
        std::string key;
        std::optional<double> value_SI;
    };
    std::vector<Number> numbers;
    std::vector<double> covariance;
};

Estimate of_fit(const nlohmann::json& fit) {
    Estimate estimate{{}, fit.at("covariance").get<std::vector<double>>()};
    for (const nlohmann::json& constant : fit.at("constants")) {
        std::string name = constant.at("name");  // "mu 1" of a list
        std::ranges::replace(name, ' ', '.');
        if (constant.at("standard_error").is_null())
            throw Error(ExitCode::bad_input, "--errors", "the data of the fit do not determine material." + name,
                        "add a test of another mode, or fit a law with fewer constants");
        estimate.numbers.push_back({"material." + name, constant.at("value").get<double>()});
    }
    return estimate;
}

Estimate of_optimization(const nlohmann::json& report) {
    Estimate estimate;
    const auto value_of = [&report](const std::string& key) -> std::optional<double> {
        const std::string text = report.at("values").at(key);
        const std::string unit = core::quantity_parts(text).unit;
        const auto value = core::parse_quantity(
            text, unit.empty() ? core::Dimension::ratio : core::dimension_of(unit).value_or(core::Dimension::ratio));
        const double* SI = std::get_if<double>(&value);
        return SI == nullptr ? std::nullopt : std::optional(*SI);
    };
    for (const auto& [key, error] : report.at("standard_errors_SI").items()) {
        estimate.numbers.push_back({key, value_of(key)});
        for (const auto& [other, correlation] : report.at("correlations").at(key).items())
            estimate.covariance.push_back(error.get<double>() *
                                          report.at("standard_errors_SI").at(other).get<double>() *
                                          correlation.get<double>());
    }
    return estimate;
}

}  // namespace

post::Deviations fitted_deviations(const std::string& file, const model::Case& model) {
    const cli::Input input = cli::read_input(file, cli::max_table_bytes);
    Estimate estimate;
    try {
        const nlohmann::json json = nlohmann::json::parse(input.text());
        estimate = json.contains("fits") ? of_fit(json.at("fits").at(0)) : of_optimization(json);
    } catch (const nlohmann::json::exception& error) {
        throw Error(ExitCode::bad_input, file, "is not a fit: " + core::one_line(error.what()),
                    "give the --json file of fit-material or optimize");
    }
    const std::size_t size = estimate.numbers.size();
    if (estimate.covariance.size() != size * size)
        throw Error(ExitCode::bad_input, file, "has a covariance of the wrong size");
    post::Deviations deviations;
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < size; ++i) {
        if (estimate.covariance.at(i * size + i) == 0) continue;  // at a bound
        const auto& [key, value_SI] = estimate.numbers[i];
        const auto found = std::ranges::find(model.parameters, key, &model::DesignParameter::key);
        if (found == model.parameters.end())
            throw Error(ExitCode::usage, "--errors " + file, "the result has no sensitivity to " + key,
                        "name it in mesh-gen --sensitivity");
        constexpr double same = 1e-3;
        if (value_SI && std::abs(*value_SI - found->value) > same * std::abs(found->value))
            throw Error(ExitCode::bad_input, "--errors " + file,
                        "the fit has another " + key + " than the result (" + core::rounded_text(*value_SI, 5) +
                            " instead of " + core::rounded_text(found->value, 5) + " in SI units)",
                        "solve the design with the fitted material");
        used.push_back(i);
        deviations.parameters.push_back(static_cast<std::size_t>(found - model.parameters.begin()));
    }
    if (used.empty())
        throw Error(ExitCode::bad_input, file, "has no errors: all its numbers are at the ends of their ranges");
    for (const std::size_t i : used)
        for (const std::size_t j : used) deviations.covariance.push_back(estimate.covariance.at(i * size + j));
    return deviations;
}

}  // namespace soft
