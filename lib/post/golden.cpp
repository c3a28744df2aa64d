#include "post/golden.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/align.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

// Of the largest value in the column: smaller values are treated as this large, see the header.
constexpr double small_share = 1e-3;
constexpr std::size_t absent = static_cast<std::size_t>(-1);

/// A column of the golden table and the matching column of the curve.
struct Pair {
    std::string name;
    std::size_t column = absent;
    std::vector<double> golden;
    double largest = 0;   ///< |golden|
    double absolute = 0;  ///< absolute tolerance

    [[nodiscard]] double allowed(double value, double relative) const {
        return absolute + relative * std::max(std::abs(value), small_share * largest);
    }
};

std::vector<Pair> pair_columns(const Curve& curve, const core::Table& golden, const Tolerance& tolerance) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < golden.headings.size(); ++i) {
        Pair pair{golden.headings[i].name, absent, core::numbers(golden, i)};
        for (const double value : pair.golden) pair.largest = std::max(pair.largest, std::abs(value));
        for (std::size_t k = 0; k < curve.columns.size(); ++k)
            if (curve.columns[k].name == pair.name) pair.column = k;
        if (pair.column != absent && curve.columns[pair.column].role == Role::counter) continue;  // step numbers differ
        for (const Allowance& allowance : tolerance.absolute)
            if (allowance.quantity.empty() ||
                (pair.column != absent && curve.columns[pair.column].quantity == allowance.quantity))
                pair.absolute = std::max(pair.absolute, allowance.value);
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

/// The coordinates present in both tables, in order of preference as leader.
std::vector<Track> make_tracks(const Curve& curve, std::span<const Pair> pairs) {
    std::vector<Track> tracks;
    for (const Source source : {Source::time, Source::output, Source::volume, Source::load, Source::other})
        for (const Pair& pair : pairs)
            if (pair.column != absent && curve.columns[pair.column].role == Role::coordinate &&
                curve.columns[pair.column].source == source)
                tracks.push_back({pair.column, pair.golden});
    return tracks;
}

/// Quantities that decide where all coordinates stay constant, as the work of friction where a body slides steadily; a difference in them
/// counts less than one of 1e-4 of the range in a coordinate.
void add_dependents(const Curve& curve, std::span<const Pair> pairs, std::vector<Track>& tracks) {
    constexpr double largest = 1e-8, rounding = 1e-6;
    for (const Pair& pair : pairs) {
        if (pair.column == absent || curve.columns[pair.column].role != Role::dependent) continue;
        const auto [low, high] = std::ranges::minmax(pair.golden);
        if (high - low > rounding * pair.largest)  // false for NaN
            tracks.push_back({pair.column, pair.golden, largest});
    }
}

/// A position between two rows of the path.
struct PathPosition {
    double t;                 ///< fraction of the interval
    std::size_t first, last;  ///< rows whose stage and stability are accepted here
};

PathPosition locate(const Path& path, std::size_t row_count, double s) {
    const auto parameters = path.row_parameters();
    if (parameters.size() < 2) return {0, 0, row_count - 1};
    const auto above = std::upper_bound(parameters.begin() + 1, parameters.end() - 1, s);
    const auto i = static_cast<std::size_t>(above - parameters.begin());
    const double t = (s - parameters[i - 1]) / (parameters[i] - parameters[i - 1]);
    PathPosition position{t, path.rows()[i - 1], path.rows()[i]};
    if (t < at_a_row && i > 1) position.first = path.rows()[i - 2];
    if (t > 1 - at_a_row) position.last = i + 1 < parameters.size() ? path.rows()[i + 1] : row_count - 1;
    return position;
}

/// Additional tolerance for a column that the solver computes at the rows only, with the `ends` of its interval.
double interpolation_allowance(const Column& column, const PathPosition& position, std::array<double, 2> ends,
                               double found, double golden) {
    const double t = position.t, chord = ends[1] - ends[0];
    switch (column.role) {
        case Role::counter: return 0;
        case Role::coordinate:
            if (column.source != Source::output || !column.slopes.empty()) return 0;
            // A contact area or pressure, a force in a motion: the slope may be anything from zero to twice that of the chord.
            return std::abs(chord) * t * (1 - t);
        case Role::dependent: return std::abs(found - (ends[0] + t * chord));
        case Role::flag:
        case Role::stage: break;
    }
    for (std::size_t row = position.first; row <= position.last; ++row)
        if (column.values[row] == golden) return HUGE_VAL;  // the golden value equals one of the accepted ones
    return 0;
}

/// Values of a coordinate; a value that misses the path by less than its tolerance is replaced by the nearest end.
std::vector<double> within_reach(const Pair& pair, const Path::Range& range, double relative) {
    std::vector<double> targets;
    for (const double value : pair.golden) {
        const double nearest = std::clamp(value, range.lowest, range.highest);
        targets.push_back(std::abs(value - nearest) <= pair.allowed(value, relative) ? nearest : value);
    }
    return targets;
}

double covered_fraction(std::span<const double> positions, const Path& path) {
    if (!(path.length() > 0)) return 1;
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (const double position : positions)
        if (!std::isnan(position)) {
            first = std::min(first, position);
            last = std::max(last, position);
        }
    return std::max(last - first, 0.0) / path.length();
}

/// Compares row by row and collects the result in a verdict.
struct RowCheck {
    const Curve& curve;
    const Path& path;
    std::span<const Pair> pairs;
    double relative;
    Verdict& verdict;
    std::size_t differences = 0;

    void compare(std::size_t i, Difference difference) {
        const double off = std::abs(difference.found - difference.golden);
        if (off > 0)
            verdict.nearest_miss =
                std::max(verdict.nearest_miss, difference.allowed > 0 ? off / difference.allowed : HUGE_VAL);
        if (off <= difference.allowed) return;
        if (!verdict.columns[i].first) verdict.columns[i].first = difference;
        ++verdict.columns[i].differing_rows;
        ++differences;
    }
    void unreached(std::size_t row, std::size_t lead) {
        const double value = pairs[lead].golden[row];
        const Path::Range range = path.range(pairs[lead].column);
        compare(lead, {row, value, std::clamp(value, range.lowest, range.highest), pairs[lead].allowed(value, relative),
                       false});
    }
    void at(std::size_t row, double s) {
        const std::vector<double> found = path.at(s);
        const PathPosition position = locate(path, curve.row_count(), s);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const Pair& pair = pairs[i];
            if (pair.column == absent) continue;
            const double value = pair.golden[row], here = found[pair.column];
            const double allowance =
                interpolation_allowance(curve.columns[pair.column], position, path.ends(pair.column, s), here, value);
            compare(i, {row, value, here, pair.allowed(value, relative) + allowance});
        }
    }
};

double not_negative(double value, std::string_view text, const std::string& option) {
    if (value < 0)
        throw Error(ExitCode::usage, option, core::quoted(text) + " is negative", "give a positive tolerance");
    return value;
}

std::string number(double value) { return core::rounded_text(value, 7); }

}  // namespace

bool Verdict::agrees() const noexcept {
    return differing_rows == 0 &&
           std::all_of(columns.begin(), columns.end(), [](const auto& column) { return column.present; });
}

Allowance parse_allowance(std::string_view text, const Curve& curve) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
        return {"", not_negative(core::quantity_or_throw(text, core::Dimension::ratio, ExitCode::usage, "--atol"), text,
                                 "--atol")};
    const std::string quantity{core::trimmed(text.substr(0, equals))};
    const Column* column = curve.find(quantity);
    if (column == nullptr) {
        std::vector<std::string> known;
        for (const Column& candidate : curve.columns) known.push_back(candidate.quantity);
        throw Error(ExitCode::usage, "--atol", "the curve has no " + core::quoted(quantity),
                    core::did_you_mean(quantity, known));
    }
    const double value =
        core::quantity_or_throw(text.substr(equals + 1), column->dimension, ExitCode::usage, "--atol " + quantity);
    return {quantity, not_negative(in_column_unit(*column, value), text.substr(equals + 1), "--atol " + quantity)};
}

Verdict check_golden(const Curve& curve, const core::Table& golden, const Tolerance& tolerance) {
    if (golden.headings.empty())
        throw Error(ExitCode::bad_input, golden.source, "has no header", "give a table written by postprocess");
    const std::vector<Pair> pairs = pair_columns(curve, golden, tolerance);
    std::vector<Track> tracks = make_tracks(curve, pairs);
    if (tracks.empty())
        throw Error(ExitCode::bad_input, golden.source, "has no column that locates its rows on the path",
                    "it needs one of " + curve.coordinate_names());
    const auto known =
        std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.column != absent; });
    if (known < 2)
        throw Error(ExitCode::bad_input, golden.source, "has no column to check besides the one that locates its rows",
                    "give a table with at least two quantities");
    const std::size_t leader = leading_track(tracks), coordinates = tracks.size();
    add_dependents(curve, pairs, tracks);
    const Path path(curve);
    const auto pair_of = [&](const Track& track) { return std::ranges::find(pairs, track.column, &Pair::column); };
    const auto lead = pair_of(tracks[leader]);
    std::vector<std::vector<double>> targets;
    for (const Track& track : std::span(tracks).first(coordinates))
        targets.push_back(within_reach(*pair_of(track), path.range(track.column), tolerance.relative));
    const std::vector<double> positions = align(path, tracks, leader, targets);

    Verdict verdict{lead->name, {}, golden.rows.size(), 0, 0, covered_fraction(positions, path)};
    for (const Pair& pair : pairs) verdict.columns.push_back({pair.name, pair.column != absent, std::nullopt, 0});
    RowCheck check{curve, path, pairs, tolerance.relative, verdict};
    for (std::size_t row = 0; row < positions.size(); ++row) {
        const std::size_t before = check.differences;
        if (std::isnan(positions[row]))
            check.unreached(row, static_cast<std::size_t>(lead - pairs.begin()));
        else
            check.at(row, positions[row]);
        verdict.differing_rows += check.differences > before ? 1 : 0;
    }
    return verdict;
}

std::string failure_text(const Verdict& verdict, const ColumnVerdict& column, const core::Table& golden) {
    if (!column.present) return golden.source + ": the result has no column " + core::quoted(column.name);
    if (!column.first) return {};
    const Difference& first = *column.first;
    const std::string line = golden.source + ":" + std::to_string(golden.lines[first.row]) + ": ";
    if (!first.reached)
        return line + "the path does not reach " + column.name + " " + number(first.golden) + "; it ends at " +
               number(first.found);
    std::string where;
    for (std::size_t i = 0; i < golden.headings.size(); ++i)
        if (golden.headings[i].name == verdict.leader && column.name != verdict.leader)
            where = " where " + verdict.leader + " is " + number(core::numbers(golden, i)[first.row]);
    return line + column.name + " is " + number(first.found) + where + ", golden " + number(first.golden) + ": " +
           core::rounded_text(std::abs(first.found - first.golden), 3) + " apart, allowed " +
           core::rounded_text(first.allowed, 3);
}

std::string failure_text(const Verdict& verdict, const core::Table& golden) {
    const ColumnVerdict* worst = nullptr;
    for (const ColumnVerdict& column : verdict.columns) {
        if (!column.present) return failure_text(verdict, column, golden);
        if (column.first && (worst == nullptr || column.first->row < worst->first->row)) worst = &column;
    }
    if (worst == nullptr) return {};
    return failure_text(verdict, *worst, golden) + "; " + std::to_string(verdict.differing_rows) + " of " +
           core::counted(verdict.rows, "row") + (verdict.differing_rows == 1 ? " differs" : " differ");
}

}  // namespace soft::post
