#include "fit/shifted_constants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::fit {
namespace {

constexpr double rounding = 1e-12;           // of a pivot, relative to the variance
constexpr double symmetry_tolerance = 1e-9;  // relative to the two standard errors
// Bound on the column below a zero pivot: larger than the square root of `rounding`.
constexpr double zero_column = 1e-5;

[[noreturn]] void refuse_covariance(const std::string& problem) {
    throw Error(ExitCode::bad_input, "covariance", problem, "give the --json output of fit-material");
}

void check_covariance(const FittedLaw& fitted) {
    const std::size_t n = fitted.constants.size();
    const std::vector<double>& covariance = fitted.covariance;
    if (n == 0) refuse_covariance("the law has no constants");
    if (covariance.size() != n * n)
        refuse_covariance(std::to_string(covariance.size()) + " numbers for " + core::counted(n, "constant"));
    if (!std::ranges::all_of(covariance, [](double value) { return std::isfinite(value); }))
        refuse_covariance("a number is not finite");
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double size = std::sqrt(std::abs(covariance[i * n + i] * covariance[j * n + j]));
            if (std::abs(covariance[i * n + j] - covariance[j * n + i]) > symmetry_tolerance * size)
                refuse_covariance("the matrix is not symmetric");
        }
}

/// Standard normal numbers, equal on all platforms: the C++ standard specifies std::mt19937_64, but not std::normal_distribution.
/// Source: Box and Muller, Ann. Math. Statist. 29 (1958) 610.
class NormalNumbers {
public:
    double operator()() {
        const double radius = std::sqrt(-2 * std::log(1 - uniform())), angle = 2 * std::numbers::pi * uniform();
        return radius * std::cos(angle);
    }

private:
    double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11U), -53); }  // [0, 1)
    std::mt19937_64 engine_{1};
};

/// "mu 2" is the second entry of the list "mu".
std::string key_of(const std::string& name) { return name.substr(0, name.find(' ')); }

}  // namespace

std::vector<double> cholesky_factor(const FittedLaw& fitted) {
    check_covariance(fitted);
    const std::size_t n = fitted.constants.size();
    std::vector<double> factor(n * n, 0);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i) {
            double rest = fitted.covariance[i * n + j];
            for (std::size_t k = 0; k < j; ++k) rest -= factor[i * n + k] * factor[j * n + k];
            const double variance = fitted.covariance[j * n + j];
            if (i == j && (variance < 0 || rest < -symmetry_tolerance * variance))
                refuse_covariance("the matrix has a negative eigenvalue");
            if (i == j)
                factor[j * n + j] = rest > rounding * variance ? std::sqrt(rest) : 0;
            else if (factor[j * n + j] > 0)
                factor[i * n + j] = rest / factor[j * n + j];
            else if (std::abs(rest) > zero_column * std::sqrt(variance * std::abs(fitted.covariance[i * n + i])))
                refuse_covariance("the matrix has a negative eigenvalue");
        }
    return factor;
}

std::vector<std::vector<double>> shifted_constants(const FittedLaw& fitted, int samples) {
    const std::vector<double> factor = cholesky_factor(fitted);
    const std::size_t n = fitted.constants.size();
    std::vector<double> fit;
    for (const FittedLaw::Constant& constant : fitted.constants) fit.push_back(constant.value);
    std::vector<std::vector<double>> sets{fit};
    const auto add = [&](const std::vector<double>& z) {
        std::vector<double>& set = sets.emplace_back(fit);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k <= i; ++k) set[i] += factor[i * n + k] * z[k];
    };
    for (std::size_t k = 0; k < n; ++k)
        for (const double sign : {1.0, -1.0}) {
            std::vector<double> z(n, 0);
            z[k] = sign;
            add(z);
        }
    NormalNumbers normal;
    for (int sample = 0; sample < samples; ++sample) {
        std::vector<double> z(n);
        for (double& number : z) number = normal();
        add(z);
    }
    return sets;
}

std::string material_text(const FittedLaw& fitted, const std::vector<double>& constants) {
    std::vector<std::pair<std::string, std::vector<std::string>>> entries;  // in the order of the constants
    std::vector<std::string> lists;
    for (std::size_t i = 0; i < constants.size(); ++i) {
        const FittedLaw::Constant& constant = fitted.constants[i];
        const std::string key = key_of(constant.name);
        if (key != constant.name) lists.push_back(key);
        auto entry = std::ranges::find(entries, key, &std::pair<std::string, std::vector<std::string>>::first);
        if (entry == entries.end()) entry = entries.insert(entries.end(), {key, {}});
        entry->second.push_back(core::number_text(constants[i]) + (constant.is_stress ? " Pa" : ""));
    }
    std::string text = "{law: " + fitted.law + ", kappa: incompressible";
    for (const auto& [key, values] : entries) {
        const bool is_list = std::ranges::find(lists, key) != lists.end();
        text.append(", ").append(key).append(": ").append(is_list ? "[" : "").append(core::join(values));
        text.append(is_list ? "]" : "");
    }
    return text + "}";
}

}  // namespace soft::fit
