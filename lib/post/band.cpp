#include "post/band.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::post {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double no_variation = 1e-9;  // relative to the value: far below any error of a fit, above rounding

/// "pressure_kPa" -> "pressure_band_kPa"
std::string band_name(const Column& column, const char* kind) {
    return column.quantity + kind + column.name.substr(column.quantity.size());
}
constexpr const char* linear_kind = "_band";
constexpr const char* sampled_kind = "_sampled_band";

std::string cell(double value) { return std::isnan(value) ? "" : core::number_text(value + 0.0); }

/// Standard deviation of the numbers; NaN for fewer than two.
double deviation(const std::vector<double>& numbers) {
    if (numbers.size() < 2) return no_number;
    const auto n = static_cast<double>(numbers.size());
    double mean = 0, sum = 0;
    for (const double number : numbers) mean += number / n;
    for (const double number : numbers) sum += (number - mean) * (number - mean);
    return std::sqrt(sum / (n - 1));
}

bool is_prescribed(const Column& column, const Request& request) { return column.quantity == request.quantity; }

std::optional<std::size_t> heading_of(const core::Table& table, const std::string& name) {
    const auto found = std::ranges::find(table.headings, name, &core::Heading::name);
    if (found == table.headings.end()) return std::nullopt;
    return static_cast<std::size_t>(found - table.headings.begin());
}

std::vector<double> numbers_or_none(const core::Table& table, std::size_t column) {
    std::vector<double> numbers;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string& text = table.rows[row][column];
        if (core::trimmed(text).empty()) {
            numbers.push_back(no_number);
            continue;
        }
        numbers.push_back(core::quantity_or_throw(
            text, core::Dimension::ratio, ExitCode::bad_input,
            table.source + ":" + std::to_string(table.lines[row]) + ": " + core::column_text(table, column)));
    }
    return numbers;
}

std::vector<double> widths(const core::Table& table, const std::string& name) {
    const auto column = heading_of(table, name);
    if (!column) return std::vector<double>(table.rows.size(), no_number);
    std::vector<double> numbers = numbers_or_none(table, *column);
    for (std::size_t row = 0; row < numbers.size(); ++row)
        if (numbers[row] < 0)
            throw Error(
                ExitCode::bad_input,
                table.source + ":" + std::to_string(table.lines[row]) + ": " + core::column_text(table, *column),
                "the width of the band is negative");
    return numbers;
}

}  // namespace

double Band::Width::half(std::size_t row) const noexcept {
    return std::isnan(sampled[row]) ? linear[row] : sampled[row];
}

const Band::Width* Band::find(std::size_t column) const noexcept {
    const auto found = std::ranges::find(widths, column, &Width::column);
    return found == widths.end() ? nullptr : &*found;
}

BandSum::BandSum(const Curve& fitted, std::span<const Request> requests) {
    for (const Request& request : requests) {
        const Curve rows = rows_at(fitted, {&request, 1});
        for (std::size_t crossing = 0; crossing < rows.row_count(); ++crossing) {
            requests_.push_back(request);
            crossings_.push_back(crossing);
        }
    }
    rows_ = rows_at(fitted, requests);
    variance_.assign(requests_.size(), std::vector<double>(rows_.columns.size(), 0));
}

BandSum::Rows BandSum::rows_of(const Curve* curve) const {
    Rows rows(requests_.size());
    if (curve == nullptr) return rows;
    if (!std::ranges::equal(curve->columns, rows_.columns, {}, &Column::name, &Column::name))
        throw Error(ExitCode::bad_input, "", "the curves have different columns");
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (crossings_[row] > 0) continue;  // the first crossing reads all crossings of the value
        const std::vector<std::vector<double>> found = crossing_rows(*curve, requests_[row]);
        for (std::size_t k = 0; k < found.size() && row + k < rows.size() && crossings_[row + k] == k; ++k)
            rows[row + k] = found[k];
    }
    return rows;
}

void BandSum::add_pair(const Curve* plus, const Curve* minus) {
    const Rows up = rows_of(plus), down = rows_of(minus);
    for (std::size_t row = 0; row < variance_.size(); ++row) {
        std::vector<double>& variance = variance_[row];
        if (!up[row] || !down[row]) variance.clear();
        for (std::size_t c = 0; c < variance.size(); ++c) {
            const double half = ((*up[row])[c] - (*down[row])[c]) / 2;
            variance[c] += half * half;
        }
    }
}

void BandSum::add_sample(const Curve* sample) { samples_.push_back(rows_of(sample)); }

Band BandSum::band() const {
    Band band;
    for (std::size_t row = 0; row < requests_.size() && !samples_.empty(); ++row)
        band.samples.push_back(static_cast<int>(
            std::ranges::count_if(samples_, [row](const Rows& rows) { return rows[row].has_value(); })));
    for (std::size_t c = 0; c < rows_.columns.size(); ++c) {
        const Column& column = rows_.columns[c];
        if (column.role != Role::coordinate) continue;
        Band::Width width{c, column.values, {}, {}};
        for (std::size_t row = 0; row < requests_.size(); ++row) {
            const bool prescribed = is_prescribed(column, requests_[row]);
            std::vector<double> sampled;
            for (const Rows& rows : samples_)
                if (rows[row]) sampled.push_back((*rows[row])[c]);
            width.linear.push_back(prescribed || variance_[row].empty() ? no_number : std::sqrt(variance_[row][c]));
            width.sampled.push_back(prescribed ? no_number : deviation(sampled));
        }
        band.widths.push_back(std::move(width));
    }
    return band;
}

std::string BandSum::location(std::size_t row) const {
    const Request& request = requests_[row];
    const Column& column = *rows_.find(request.quantity);
    std::string text =
        request.quantity + "=" + core::rounded_text(in_column_unit(column, request.value_SI), 6) + column.unit;
    if (crossings_[row] > 0) text += " (crossing " + std::to_string(crossings_[row] + 1) + ")";
    return text;
}

std::vector<std::string> BandSum::notes() const {
    std::vector<std::string> notes;
    const Band found = band();
    for (std::size_t row = 0; row < requests_.size(); ++row) {
        if (variance_[row].empty())
            notes.push_back(
                location(row) +
                ": a curve with constants one standard error away does not reach it; the linear band is empty");
        const int missing = samples_.empty() ? 0 : static_cast<int>(samples_.size()) - found.samples[row];
        if (missing > 0)
            notes.push_back(location(row) + ": " + std::to_string(missing) + " of " +
                            core::counted(samples_.size(), "sample") + (missing == 1 ? " does" : " do") +
                            " not reach it and " + (missing == 1 ? "is" : "are") + " left out");
        const auto varies = [row](const Band::Width& width) {
            return width.half(row) > no_variation * std::abs(width.values[row]);
        };
        if (!variance_[row].empty() && std::ranges::none_of(found.widths, varies))
            notes.push_back(location(row) +
                            ": no quantity of the curve depends on the constants there; add an output that does, "
                            "such as the force of a prescribed motion (measure: force)");
    }
    return notes;
}

std::string band_csv(const Curve& rows, const Band& band) {
    std::string text;
    const std::vector<const Column*> shown = shown_columns(rows);
    const auto add = [&text](const std::string& cell) { text.append(cell).append(","); };
    const auto end_line = [&text] { text.back() = '\n'; };
    for (const Column* column : shown) add(column->name);
    for (const Band::Width& width : band.widths) add(band_name(rows.columns[width.column], linear_kind));
    if (!band.samples.empty()) {
        for (const Band::Width& width : band.widths) add(band_name(rows.columns[width.column], sampled_kind));
        add("samples");
    }
    end_line();
    for (std::size_t row = 0; row < rows.row_count(); ++row) {
        for (const Column* column : shown) add(cell(column->values[row]));
        for (const Band::Width& width : band.widths) add(cell(width.linear[row]));
        if (!band.samples.empty()) {
            for (const Band::Width& width : band.widths) add(cell(width.sampled[row]));
            add(std::to_string(band.samples[row]));
        }
        end_line();
    }
    return text;
}

Band read_band(const core::Table& table, const Curve& curve) {
    Band band;
    bool has_width = false;
    for (std::size_t c = 0; c < curve.columns.size(); ++c) {
        const Column& column = curve.columns[c];
        const auto values = heading_of(table, column.name);
        if (column.role != Role::coordinate || !values) continue;
        const std::string linear = band_name(column, linear_kind), sampled = band_name(column, sampled_kind);
        if (heading_of(table, linear) || heading_of(table, sampled)) has_width = true;
        band.widths.push_back({c, core::numbers(table, *values), widths(table, linear), widths(table, sampled)});
    }
    if (!has_width)
        throw Error(ExitCode::bad_input, table.source, "has no column such as pressure_band_kPa for this curve",
                    "give a table written by scripts/uncertainty");
    if (const auto samples = heading_of(table, "samples"))
        for (const double number : core::numbers(table, *samples)) band.samples.push_back(static_cast<int>(number));
    return band;
}

}  // namespace soft::post
