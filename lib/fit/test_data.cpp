#include "fit/test_data.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "fit/columns.hpp"

namespace soft::fit {
namespace {

// Range limits are entered in decimals: a row at 1.1 belongs to a range up to 110 % despite rounding.
constexpr double end_tolerance = 1e-9;
// Relative to the range of the displacement.
constexpr double machine_noise = 2e-3;

struct Point {
    double stretch = 0, nominal_Pa = 0, time_s = 0;
    std::size_t line = 0;
};

[[noreturn]] void refuse(const core::Table& table, std::size_t line, const std::string& problem,
                         const std::string& remedy) {
    throw Error(ExitCode::bad_input, table.source + ":" + std::to_string(line), problem, remedy);
}

/// If one of the two columns contains a decimal point, a comma is not a decimal separator: "1,234" next to "0.1" is not 1.234.
void resolve_decimal_separator(core::Table& table, const Columns& columns) {
    if (table.decimal != core::Decimal::either) return;
    const bool has_point = std::ranges::any_of(table.rows, [&](const std::vector<std::string>& row) {
        return row[columns.strain].find('.') != std::string::npos || row[columns.stress].find('.') != std::string::npos;
    });
    if (has_point) table.decimal = core::Decimal::point;
}

double stretch_of(double strain, StrainMeasure measure) {
    switch (measure) {
        case StrainMeasure::engineering: return 1.0 + strain;
        case StrainMeasure::logarithmic: return std::exp(strain);
        case StrainMeasure::stretch: break;
    }
    return strain;
}

std::vector<Point> points_of(const core::Table& table, const Columns& columns, const ReadSettings& settings) {
    const Specimen& specimen = settings.specimen;
    auto strains = core::values_SI(table, columns.strain, columns.strain_unit,
                                   specimen.gauge_length_m ? core::Dimension::length : core::Dimension::ratio);
    auto stresses = core::values_SI(table, columns.stress, columns.stress_unit,
                                    specimen.area_m2 ? core::Dimension::force : core::Dimension::pressure);
    std::vector<double> times_s;
    if (settings.wants_time) times_s = core::values_SI(table, columns.time, columns.time_unit, core::Dimension::time);
    for (double& strain : strains) strain /= specimen.gauge_length_m.value_or(1.0);
    for (double& stress : stresses) stress /= specimen.area_m2.value_or(1.0);
    const bool unit_stated = !settings.strain_unit.empty() || !columns.strain_unit.empty();
    std::vector<Point> points;
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const std::size_t line = table.lines[i];
        if (!unit_stated && strains[i] > max_ratio)
            refuse(table, line, "a strain of " + core::number_text(strains[i]) + " looks like a percentage",
                   "give --strain-unit % (or --strain-unit 1)");
        const double stretch = stretch_of(strains[i], columns.strain_measure);
        if (!(stretch > 0.0))
            refuse(table, line, "a stretch of " + core::rounded_text(stretch, 6) + " is not positive",
                   "a strain must exceed -100 %; is it a strain or a stretch (--strain)?");
        const bool is_cauchy = columns.stress_measure == StressMeasure::cauchy;
        points.push_back(
            {stretch, is_cauchy ? stresses[i] / stretch : stresses[i], times_s.empty() ? 0.0 : times_s[i], line});
    }
    return points;
}

void check_path(const core::Table& table, const std::vector<Point>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double first = points[1].stretch - points[0].stretch, step = points[i].stretch - points[i - 1].stretch;
        if (step == 0.0)
            refuse(table, points[i].line, "the strain equals that of the previous row",
                   "give one row per strain, or --any-order for rows in any order");
        if (step * first < 0.0)
            refuse(table, points[i].line, "the strain reverses direction",
                   "give one loading ramp, or --any-order for rows in any order");
    }
}

/// The displacement of a testing machine may repeat and fluctuate within its resolution; a larger reversal starts another ramp.
void check_machine_path(const core::Table& table, const std::vector<Point>& points) {
    const auto [min, max] = std::ranges::minmax(points, {}, &Point::stretch);
    const double sign = max.stretch - 1.0 >= 1.0 - min.stretch ? 1.0 : -1.0;
    const double noise = machine_noise * (max.stretch - min.stretch);
    double furthest = points.front().stretch;
    for (const Point& point : points) {
        if (sign * (furthest - point.stretch) > noise)
            refuse(table, point.line, "the displacement reverses direction",
                   "give one loading ramp, or --any-order for rows in any order");
        furthest = sign > 0 ? std::max(furthest, point.stretch) : std::min(furthest, point.stretch);
    }
}

void skip_rows(core::Table& table, std::size_t count) {
    const auto rows = static_cast<std::ptrdiff_t>(std::min(count, table.rows.size()));
    table.rows.erase(table.rows.begin(), table.rows.begin() + rows);
    table.lines.erase(table.lines.begin(), table.lines.begin() + rows);
}

}  // namespace

std::string_view name_of(Mode mode) {
    switch (mode) {
        case Mode::uniaxial: return "uniaxial";
        case Mode::equibiaxial: return "equibiaxial";
        case Mode::planar: return "planar";
        case Mode::simple_shear: return "simple shear";
    }
    return "";
}

TestCurve read_test(std::string_view text, std::string_view source, Mode mode, const ReadSettings& settings) {
    core::Table table = core::read_table(text, source, settings.format);
    const Columns columns = columns_of(table, settings);
    const std::size_t last_line = table.lines.back();
    skip_rows(table, settings.skipped_rows);
    resolve_decimal_separator(table, columns);
    const std::vector<Point> points = points_of(table, columns, settings);
    if (!settings.wants_time && settings.order == RowOrder::path && points.size() > 1)
        settings.specimen.gauge_length_m ? check_machine_path(table, points) : check_path(table, points);
    TestCurve test{.mode = mode, .source = std::string{source}, .sha256 = core::sha256_hex(text)};
    test.measured = columns.stress_measure;
    for (const Point& point : points) {
        const double strain = point.stretch - 1.0;
        if (strain < settings.range.min - end_tolerance || strain > settings.range.max + end_tolerance) continue;
        test.stretch.push_back(point.stretch);
        test.nominal_Pa.push_back(point.nominal_Pa);
        if (settings.wants_time) test.time_s.push_back(point.time_s);
    }
    if (test.stretch.size() < 2)
        refuse(table, last_line,
               "only " + std::to_string(test.stretch.size()) + " of the rows up to this line can be used",
               "at least two rows must lie in --range after --skip-rows");
    return test;
}

double first_invariant(Mode mode, double l) {
    switch (mode) {
        case Mode::uniaxial: return l * l + 2.0 / l;
        case Mode::equibiaxial: return 2.0 * l * l + 1.0 / (l * l * l * l);
        case Mode::planar: return l * l + 1.0 + 1.0 / (l * l);
        case Mode::simple_shear: return 3.0 + l * l;
    }
    return 3.0;
}

double max_invariant(const std::vector<TestCurve>& tests) {
    double largest = 3.0;
    for (const TestCurve& test : tests)
        for (const double stretch : test.stretch) largest = std::max(largest, first_invariant(test.mode, stretch));
    return largest;
}

}  // namespace soft::fit
