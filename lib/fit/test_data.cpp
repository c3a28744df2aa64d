#include "fit/test_data.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "fit/columns.hpp"

namespace soft::fit {
namespace {

// A strain of 30 is past what any rubber bears, and a small percentage.
constexpr double largest_ratio = 30.0;
// The ends of a range are typed in decimals: a row at 1.1 belongs to 110 % whatever the last bit says.
constexpr double end_tolerance = 1e-9;

struct Point {
    double stretch = 0, nominal_Pa = 0;
    std::size_t line = 0;
};

class Reader {
public:
    Reader(const Table& table, const ReadSettings& settings)
        : table_(table), settings_(settings), columns_(columns_of(table, settings)) {}

    [[nodiscard]] const Columns& columns() const { return columns_; }

    [[nodiscard]] std::vector<Point> points() const {
        std::vector<Point> points;
        for (std::size_t i = settings_.skipped_rows; i < table_.rows.size(); ++i)
            points.push_back(point(table_.rows[i]));
        return points;
    }

    [[noreturn]] void refuse(std::size_t line, const std::string& problem, const std::string& remedy) const {
        throw Error(ExitCode::bad_input, table_.source + ":" + std::to_string(line), problem, remedy);
    }

private:
    [[nodiscard]] double number(const Table::Row& row, std::size_t column, std::string_view what) const {
        const std::string field = column < row.fields.size() ? row.fields[column] : "";
        const std::string name = "the " + std::string{what} + " (column " + std::to_string(column + 1) + ")";
        if (field.empty()) refuse(row.line, name + " is missing", "fill it in or take the line out");
        const auto value = number_of(field, settings_.format.decimal);
        if (!value)
            refuse(row.line, name + " is no number: " + core::quoted(field),
                   number_of(field, Decimal::comma) ? "give --decimal comma" : "correct it or take the line out");
        return *value;
    }

    [[nodiscard]] Point point(const Table::Row& row) const {
        const double strain = columns_.strain_factor * number(row, columns_.strain, "strain");
        const double stress_Pa = columns_.stress_Pa * number(row, columns_.stress, "stress");
        const bool unit_stated = !settings_.strain_unit.empty();
        if (!unit_stated && columns_.strain_factor == 1.0 && strain > largest_ratio)
            refuse(row.line, "a strain of " + core::number_text(strain) + " looks like a percentage",
                   "give --strain-unit % (or --strain-unit 1)");
        const double stretch = columns_.strain_measure == StrainMeasure::engineering   ? 1.0 + strain
                               : columns_.strain_measure == StrainMeasure::logarithmic ? std::exp(strain)
                                                                                       : strain;
        if (!(stretch > 0.0))
            refuse(row.line, "a stretch of " + core::rounded_text(stretch, 6) + " is not positive",
                   "a strain is more than -100 %; is it a strain or a stretch (--strain)?");
        const bool is_cauchy = columns_.stress_measure == StressMeasure::cauchy;
        return {stretch, is_cauchy ? stress_Pa / stretch : stress_Pa, row.line};
    }

    const Table& table_;
    const ReadSettings& settings_;
    Columns columns_;
};

void check_path(const Reader& reader, const std::vector<Point>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double first = points[1].stretch - points[0].stretch, step = points[i].stretch - points[i - 1].stretch;
        if (step == 0.0)
            reader.refuse(points[i].line, "the strain is that of the row before", "one row for each strain");
        if (step * first < 0.0)
            reader.refuse(points[i].line, "the strain turns back",
                          "fit one pull; --any-order takes rows that are points in no order");
    }
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
    const Table table = read_table(text, source, settings.format);
    const Reader reader{table, settings};
    const std::vector<Point> points = reader.points();
    if (settings.order == RowOrder::path && points.size() > 1) check_path(reader, points);
    TestCurve test{.mode = mode, .source = std::string{source}, .sha256 = core::sha256_hex(text)};
    test.measured = reader.columns().stress_measure;
    for (const Point& point : points) {
        const double strain = point.stretch - 1.0;
        if (strain < settings.range.least - end_tolerance || strain > settings.range.most + end_tolerance) continue;
        test.stretch.push_back(point.stretch);
        test.nominal_Pa.push_back(point.nominal_Pa);
    }
    if (test.stretch.size() < 2)
        reader.refuse(table.rows.back().line,
                      "only " + std::to_string(test.stretch.size()) + " of the rows to this one take part",
                      "two or more must lie in --range behind --skip-rows");
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

double largest_invariant(const std::vector<TestCurve>& tests) {
    double largest = 3.0;
    for (const TestCurve& test : tests)
        for (const double stretch : test.stretch) largest = std::max(largest, first_invariant(test.mode, stretch));
    return largest;
}

}  // namespace soft::fit
