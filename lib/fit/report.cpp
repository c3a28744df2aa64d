#include "fit/report.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/text.hpp"

namespace soft::fit {
namespace {

constexpr int digits = 10;
constexpr double kilo = 1e3;

std::string kPa(double value_Pa) { return core::rounded_text(value_Pa / kilo, digits) + " kPa"; }
std::string value_text(const Constant& constant) {
    return constant.is_stress ? kPa(constant.value) : core::rounded_text(constant.value, digits);
}
std::string error_text(const Fit& fit, const Constant& constant) {
    if (fit.law_is_given) return "given";
    if (!(constant.standard_error > 0.0)) return "at a bound";
    if (std::isinf(constant.standard_error)) return "not determined by the data";
    return "+- " +
           core::rounded_text(constant.is_stress ? constant.standard_error / kilo : constant.standard_error, 3) +
           (constant.is_stress ? " kPa" : "");
}

/// "2.4 %", "110 %".
std::string percent_text(double share) {
    const double percent = 100.0 * share;
    return core::rounded_text(percent < 10.0 ? percent : std::round(percent), percent < 10.0 ? 2 : 6) + " %";
}

std::string line(const std::string& key, const std::string& value, const std::string& comment = {}) {
    return key + ": " + value + (comment.empty() ? "" : "   # " + comment) + "\n";
}

/// One line, quoted so that no character of a file name can end it, and truncated to the length that a design allows.
std::string yaml_text(const std::string& text) {
    constexpr std::size_t max_length = 200;
    return core::single_quoted(core::one_line(text, max_length));
}

/// The file name without directories, which differ between machines.
std::string bare_name(const std::string& source) { return source.substr(source.rfind('/') + 1); }

std::string constants(const Fit& fit) {
    std::string text;
    const bool ogden = fit.candidate.law == "ogden";
    if (!ogden) {
        for (const Constant& constant : fit.list)
            text += line(std::string{"  "}.append(constant.name), value_text(constant), error_text(fit, constant));
        return text;
    }
    for (const bool stress : {true, false}) {
        std::vector<std::string> values, errors;
        for (const Constant& constant : fit.list)
            if (constant.is_stress == stress)
                values.push_back(value_text(constant)), errors.push_back(error_text(fit, constant));
        text += line(stress ? "  mu" : "  alpha", std::string{"["}.append(core::join(values)).append("]"),
                     core::join(errors));
    }
    return text;
}

/// The groups `viscoelastic` and `softening` of a fit to tests in time.
std::string history_lines(const Fit& fit) {
    if (!fit.inelastic) return {};
    const auto text = [](const HistoryConstant& constant) {
        return constant.unit == "Pa"  ? kPa(constant.value)
               : constant.unit == "s" ? core::rounded_text(constant.value, digits) + " s"
                                      : core::rounded_text(constant.value, digits);
    };
    const auto error = [](const HistoryConstant& constant) {
        if (!(constant.standard_error > 0.0)) return std::string{"at a bound"};
        const bool in_kPa = constant.unit == "Pa";
        return "+- " + core::rounded_text(constant.standard_error / (in_kPa ? kilo : 1.0), 3) +
               (in_kPa                 ? " kPa"
                : constant.unit == "s" ? " s"
                                       : "");
    };
    const std::size_t branches = fit.inelastic->moduli.size();
    std::string lines;
    for (const std::size_t first : {std::size_t{0}, branches}) {
        std::vector<std::string> values, errors;
        for (std::size_t k = first; k < first + branches; ++k) {
            values.push_back(text(fit.history[k]));
            errors.push_back(error(fit.history[k]));
        }
        if (branches == 0) break;
        if (first == 0) lines += "  viscoelastic:\n";
        lines += line(first == 0 ? "    moduli" : "    times", std::string{"["}.append(core::join(values)).append("]"),
                      core::join(errors));
    }
    if (!fit.inelastic->softening) return lines;
    lines += "  softening:\n";
    for (std::size_t i = 2 * branches; i < fit.history.size(); ++i)
        lines += line(std::string{"    "}.append(fit.history[i].name), text(fit.history[i]), error(fit.history[i]));
    return lines;
}

std::string range_text(const std::vector<TestCurve>& tests) {
    double min = tests.front().stretch.front(), max = min;
    for (const TestCurve& test : tests)
        for (const double stretch : test.stretch) min = std::min(min, stretch), max = std::max(max, stretch);
    return core::rounded_text((min - 1.0) * 100.0, 6) + ":" + core::rounded_text((max - 1.0) * 100.0, 6) + " %";
}

std::string stress_text(const std::vector<TestCurve>& tests) {
    const bool all_engineering = std::all_of(
        tests.begin(), tests.end(), [](const TestCurve& test) { return test.measured == StressMeasure::engineering; });
    return all_engineering ? "engineering" : "engineering, from true";
}

std::string comment_lines(const std::string& text) {
    std::string lines;
    std::istringstream in{text};
    for (std::string one; std::getline(in, one);) lines += "# " + one + "\n";
    return lines;
}

std::string unstable_comment(const Fit& fit) {
    const std::string text = material::stability_text(fit.limits);
    return text.empty() ? "" : "# " + text + "\n";
}

}  // namespace

std::string material_yaml(const Fit& fit, const std::vector<TestCurve>& tests, const Provenance& provenance) {
    std::string text = comment_lines(provenance.notice);
    // An argument may contain a line feed, which would end the comment.
    if (!provenance.command_line.empty())
        text += "# " + core::one_line(provenance.command_line, provenance.command_line.size()) + "\n";
    for (const TestQuality& test : fit.tests) {
        text += "# " + std::string{name_of(test.mode)} + ", " + std::to_string(test.rows) + " rows: RMSE " +
                core::rounded_text(test.rmse_Pa / kilo, 4) + " kPa, largest " +
                core::rounded_text(test.max_Pa / kilo, 4) + " kPa, R2 " + core::rounded_text(test.r2, 6);
        if (test.offset_Pa) text += ", offset " + core::rounded_text(*test.offset_Pa / kilo, 4) + " kPa";
        text += "\n";
    }
    text += unstable_comment(fit);
    text += "material:\n" + line("  law", std::string{fit.candidate.law}) + constants(fit) +
            line("  kappa", "incompressible") + history_lines(fit) + "  fit:\n";
    text += line("    range", yaml_text(range_text(tests)), "engineering strain of the data");
    text += line("    max_I1", core::rounded_text(fit.max_I1, digits), "beyond it the law extrapolates");
    text += line("    rmse_kPa", core::rounded_text(fit.rmse_Pa / kilo, 4));
    text += line("    r2", core::rounded_text(fit.r2, 8));
    if (fit.max_relative_error)
        text += line("    max_error", yaml_text(percent_text(*fit.max_relative_error)),
                     "of the stress, at strains of 20 % and above");
    text += line("    stress", yaml_text(stress_text(tests)));
    text += line("    rows", std::to_string(fit.rows));
    text += line("    flags", yaml_text(fit.flags.empty() ? "none" : core::join(fit.flags, " ")));
    std::vector<std::string> sources, hashes;
    for (const TestCurve& test : tests) {
        sources.push_back(std::string{name_of(test.mode)} + " " + bare_name(test.source));
        if (!test.sha256.empty()) hashes.push_back(test.sha256);
    }
    text += line("    source", yaml_text(core::join(sources)));
    if (!hashes.empty()) text += line("    sha256", yaml_text(core::join(hashes, " ")));
    if (!provenance.protocol.empty()) text += line("    protocol", yaml_text(provenance.protocol));
    return text;
}

std::string rank_table(const std::vector<RankedFit>& ranked) {
    const auto padded = [](std::string text, std::size_t width) {
        text.resize(std::max(width, text.size() + 1), ' ');
        return text;
    };
    std::string text =
        padded("law", 17) + padded("constants", 11) + padded("AICc", 10) + padded("RMSE_kPa", 11) + padded("R2", 11);
    if (!ranked.front().predictions.empty())
        for (const CrossPrediction& prediction : ranked.front().predictions)
            text += padded("predicts_" + std::string{name_of(prediction.mode)}, 22);
    text += "flags\n";
    for (const RankedFit& one : ranked) {
        text += padded(std::string{one.fit.candidate.name}, 17) +
                padded(std::to_string(one.fit.list.size() + one.fit.history.size()), 11) +
                padded(core::rounded_text(one.fit.aicc, 6), 10) +
                padded(core::rounded_text(one.fit.rmse_Pa / kilo, 4), 11) +
                padded(core::rounded_text(one.fit.r2, 6), 11);
        for (const CrossPrediction& prediction : one.predictions)
            text += padded(core::rounded_text(100.0 * prediction.relative, 3) + " %", 22);
        text += (one.fit.flags.empty() ? "-" : core::join(one.fit.flags, " ")) + "\n";
    }
    return text;
}

}  // namespace soft::fit
