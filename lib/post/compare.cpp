#include "post/compare.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

/// Value of `of` on the path where `at` has the value of the row; the crossing nearest to the measured value; nullopt off the path.
std::optional<double> calculated(const Path& path, const Series& of, const Series& at, std::size_t row) {
    std::optional<double> nearest;
    for (const double s : path.crossings(at.column, path.within_reach(at.column, at.values[row]))) {
        const double here = path.at(s)[of.column];
        if (!nearest || std::abs(here - of.values[row]) < std::abs(*nearest - of.values[row])) nearest = here;
    }
    return nearest;
}

ErrorSummary summarise(const Path& path, const Series& of, const Series& at) {
    ErrorSummary sum{.of = of.column, .at = at.column};
    std::vector<double> errors, values;
    for (std::size_t row = 0; row < of.values.size(); ++row) {
        const auto here = calculated(path, of, at, row);
        if (!here) continue;
        errors.push_back(*here - of.values[row]);
        values.push_back(of.values[row]);
        if (errors.size() == 1 || std::abs(errors.back()) > std::abs(sum.largest))
            sum.largest = errors.back(), sum.max_row = row;
    }
    sum.points = errors.size();
    sum.left_out = of.values.size() - errors.size();
    const double n = static_cast<double>(errors.size());
    double squares = 0, mean_value = 0, spread = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        sum.mean += errors[i] / n;
        sum.mean_absolute += std::abs(errors[i]) / n;
        squares += errors[i] * errors[i];
        mean_value += values[i] / n;
    }
    for (const double value : values) spread += (value - mean_value) * (value - mean_value);
    sum.rms = errors.empty() ? 0 : std::sqrt(squares / n);
    if (spread > 0) sum.r2 = 1 - squares / spread;
    return sum;
}

std::string location_text(const Curve& curve, const Measured& measured, const ErrorSummary& error) {
    const Series& at = *measured.find(error.at);
    const Column& column = curve.columns[error.at];
    return column.quantity + " " + value_text(column, at.values[error.max_row]) + " (" + measured.source + ":" +
           std::to_string(measured.lines[error.max_row]) + ")";
}

std::string points_text(const ErrorSummary& error) {
    return std::to_string(error.points) + (error.points == 1 ? " point" : " points") +
           (error.left_out > 0 ? ", " + std::to_string(error.left_out) + " beyond the path" : "");
}

std::string name_of(const Curve& curve, const ErrorSummary& error) {
    return curve.columns[error.of].quantity + " at equal " + curve.columns[error.at].quantity;
}

}  // namespace

std::vector<ErrorSummary> compare(const Curve& curve, const Measured& measured) {
    const Path path(curve);
    const auto base_of = [&](Source source) {
        return std::find_if(measured.series.begin(), measured.series.end(),
                            [&](const Series& series) { return curve.columns[series.column].source == source; });
    };
    const bool moves = base_of(Source::time) != measured.series.end();
    const auto base = moves ? base_of(Source::time) : base_of(Source::load);
    std::vector<ErrorSummary> errors;
    for (const Series& other : measured.series) {
        if (base == measured.series.end() || other.column == base->column) continue;
        errors.push_back(moves ? summarise(path, other, *base) : summarise(path, *base, other));
        if (!moves) errors.push_back(summarise(path, other, *base));
    }
    std::erase_if(errors, [](const ErrorSummary& error) { return error.points == 0; });
    if (!errors.empty()) return errors;
    const Series& series = measured.series.front();
    const Column& column = curve.columns[series.column];
    const Path::Range range = path.range(series.column);
    const auto [low, high] = std::minmax_element(series.values.begin(), series.values.end());
    throw Error(ExitCode::bad_input, measured.source, "no point lies on the path",
                column.quantity + " ranges from " + value_text(column, *low) + " to " + value_text(column, *high) +
                    " in the data and from " + value_text(column, range.lowest) + " to " +
                    value_text(column, range.highest) + " on the path");
}

std::string csv_text(const Curve& curve, const Measured& measured, std::span<const ErrorSummary> errors) {
    std::string text = "quantity,unit,at_equal,points,left_out,mean,mean_absolute,rms,largest,max_line,measured,r2\n";
    for (const ErrorSummary& error : errors) {
        const Column& of = curve.columns[error.of];
        std::vector<std::string> cells{of.quantity, of.unit, curve.columns[error.at].quantity,
                                       std::to_string(error.points), std::to_string(error.left_out)};
        for (const double value : {error.mean, error.mean_absolute, error.rms, error.largest})
            cells.push_back(core::number_text(value));
        cells.push_back(std::to_string(measured.lines[error.max_row]));
        cells.push_back(core::number_text(measured.find(error.of)->values[error.max_row]));
        cells.push_back(error.r2 ? core::number_text(*error.r2) : "");
        text += core::join(cells, ",") + "\n";
    }
    return text;
}

std::vector<std::string> summary_lines(const Curve& curve, const Measured& measured,
                                       std::span<const ErrorSummary> errors) {
    std::vector<std::string> lines, origins;
    for (const Series& series : measured.series)
        origins.push_back(curve.columns[series.column].quantity + " from " + series.origin);
    lines.push_back(measured.source + ": " + core::join(origins));
    for (const ErrorSummary& error : errors) {
        const Column& of = curve.columns[error.of];
        lines.push_back(name_of(curve, error) + ": mean error " + value_text(of, error.mean, 3) +
                        ", mean absolute error " + value_text(of, error.mean_absolute, 3) + ", RMS " +
                        value_text(of, error.rms, 3) + ", largest " + value_text(of, error.largest, 3) + " at " +
                        location_text(curve, measured, error) +
                        (error.r2 ? ", R2 " + core::rounded_text(*error.r2, 4) : "") + "; " + points_text(error));
    }
    return lines;
}

std::vector<Claim> check_max_error(const Curve& curve, const Measured& measured, std::span<const ErrorSummary> errors,
                                   std::string_view limit) {
    std::vector<Claim> claims;
    for (const ErrorSummary& error : errors) {
        const Column& of = curve.columns[error.of];
        const auto parsed = core::parse_quantity(limit, of.dimension);
        if (!std::holds_alternative<double>(parsed)) continue;
        const double allowed = in_column_unit(of, std::get<double>(parsed));
        if (allowed < 0)
            throw Error(ExitCode::usage, "--max-error", core::quoted(limit) + " is negative", "give a positive limit");
        Claim claim{"largest error of " + name_of(curve, error) + " is at most " + value_text(of, allowed) + " (" +
                        points_text(error) + ")",
                    ""};
        if (std::abs(error.largest) > allowed)
            claim.failure = "the largest error of " + name_of(curve, error) + " is " + value_text(of, error.largest) +
                            " at " + location_text(curve, measured, error) + ", allowed is " + value_text(of, allowed);
        else if (error.left_out > 0)
            claim.failure = core::counted(error.left_out, "measured point") + " of " +
                            std::to_string(error.points + error.left_out) + " lie beyond the path, so the limit of " +
                            value_text(of, allowed) + " of " + name_of(curve, error) +
                            " cannot be checked; extend the path (path.until), or remove them from " + measured.source;
        claims.push_back(std::move(claim));
    }
    if (!claims.empty()) return claims;
    for (const Series& series : measured.series)
        if (const Column& of = curve.columns[series.column];
            std::holds_alternative<double>(core::parse_quantity(limit, of.dimension)))
            return {{"largest error of " + of.quantity + " is at most " + std::string{limit},
                     "no measured point lies on the path, so the limit of " + std::string{limit} + " of " +
                         of.quantity + " cannot be checked"}};
    std::vector<std::string> units;
    for (const ErrorSummary& error : errors) units.push_back(curve.columns[error.of].unit);
    throw Error(ExitCode::usage, "--max-error", core::quoted(limit) + " does not have the unit of a compared quantity",
                "give a number with a unit like " + core::join(units, " or "));
}

}  // namespace soft::post
