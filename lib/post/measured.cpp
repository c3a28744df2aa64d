#include "post/measured.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::post {
namespace {

/// "Tip displacement" and tip_displacement are the same name.
std::string folded(std::string_view name) {
    std::string text{core::trimmed(name)};
    for (char& c : text) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// A column of the file assigned to a column of the curve.
struct Match {
    std::size_t of_curve, of_file;
    std::string unit;
};

class Matcher {
public:
    Matcher(const core::Table& file, const Curve& curve) : file_(file), curve_(curve), assigned_(file.width(), 0) {}

    void choose(const ColumnChoice& choice) {
        const Column* column = curve_.find(choice.quantity);
        if (column == nullptr || column->role != Role::coordinate)
            throw Error(ExitCode::usage, "--columns", "the curve has no " + core::quoted(choice.quantity),
                        "it has " + curve_.coordinate_names());
        const std::size_t number = numbered(choice);
        if (has(curve_.index_of(*column)))
            throw Error(ExitCode::usage, "--columns", core::quoted(choice.quantity) + " is given twice",
                        "name each quantity once");
        if (assigned_[number] != 0)
            throw Error(ExitCode::usage, "--columns " + choice.quantity,
                        core::column_text(file_, number) + " is already assigned", "name each column once");
        add(curve_.index_of(*column), number, choice.unit);
    }

    void match_names() {
        for (std::size_t i = 0; i < curve_.columns.size(); ++i) {
            const Column& column = curve_.columns[i];
            if (column.role != Role::coordinate || has(i)) continue;
            for (std::size_t k = 0; k < file_.headings.size(); ++k) {
                const core::Heading& heading = file_.headings[k];
                const bool same =
                    folded(heading.quantity) == folded(column.quantity) || folded(heading.name) == folded(column.name);
                if (!same || assigned_[k] != 0) continue;
                add(i, k, "");
                break;
            }
        }
    }

    /// Assigns the only free column of the file with a given dimension to the only quantity of the curve with that dimension.
    void match_units(auto wanted) {
        std::vector<std::size_t> quantities;
        for (std::size_t i = 0; i < curve_.columns.size(); ++i)
            if (curve_.columns[i].role == Role::coordinate && wanted(curve_.columns[i])) quantities.push_back(i);
        for (const std::size_t i : quantities) {
            const core::Dimension kind = curve_.columns[i].dimension;
            const auto same_kind = [&](std::size_t q) { return curve_.columns[q].dimension == kind; };
            const auto fits = [&](std::size_t k) {
                return assigned_[k] == 0 && core::dimension_of(file_.headings[k].unit) == kind;
            };
            std::vector<std::size_t> columns;
            for (std::size_t k = 0; k < file_.headings.size(); ++k)
                if (fits(k)) columns.push_back(k);
            if (columns.size() == 1 && std::count_if(quantities.begin(), quantities.end(), same_kind) == 1)
                add(i, columns.front(), "");
        }
    }

    [[nodiscard]] bool has(std::size_t of_curve) const {
        return std::any_of(matches_.begin(), matches_.end(),
                           [&](const Match& match) { return match.of_curve == of_curve; });
    }
    [[nodiscard]] const std::vector<Match>& matches() const noexcept { return matches_; }

private:
    [[nodiscard]] std::size_t numbered(const ColumnChoice& choice) const {
        std::size_t number = 0;
        const std::string& text = choice.column;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc{} && end == text.data() + text.size()) {
            if (number >= 1 && number <= file_.width()) return number - 1;
            throw Error(ExitCode::usage, "--columns " + choice.quantity,
                        file_.source + " has columns 1 to " + std::to_string(file_.width()) + ", not " + text);
        }
        std::vector<std::string> names;
        for (const core::Heading& heading : file_.headings) names.push_back(heading.name);
        for (std::size_t k = 0; k < names.size(); ++k)
            if (folded(names[k]) == folded(text) || folded(file_.headings[k].quantity) == folded(text)) return k;
        throw Error(ExitCode::usage, "--columns " + choice.quantity,
                    file_.source + " has no column " + core::quoted(text), core::did_you_mean(text, names));
    }

    void add(std::size_t of_curve, std::size_t of_file, std::string unit) {
        const Column& column = curve_.columns[of_curve];
        const std::string location = file_.source + ": " + core::column_text(file_, of_file);
        if (unit.empty() && !file_.headings.empty()) unit = file_.headings[of_file].unit;
        if (unit.empty() && column.dimension != core::Dimension::ratio)
            throw Error(
                ExitCode::bad_input, location, "the unit is missing",
                "give it, e.g. --columns " + column.quantity + "=" + std::to_string(of_file + 1) + ":" + column.unit);
        if (!unit.empty() && core::dimension_of(unit) != column.dimension)
            throw Error(ExitCode::bad_input, location,
                        core::quoted(unit) + " is not a unit of " + std::string{core::name(column.dimension)},
                        "give " + column.quantity + " for example in " + column.unit);
        assigned_[of_file] = 1;
        matches_.push_back({of_curve, of_file, unit});
    }

    const core::Table& file_;
    const Curve& curve_;
    std::vector<char> assigned_;  ///< columns of the file
    std::vector<Match> matches_;
};

std::string column_list(const core::Table& file) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min<std::size_t>(file.width(), 12); ++k)
        names.push_back(core::column_text(file, k));
    return core::one_line(core::join(names), 300);
}

}  // namespace

const Series* Measured::find(std::size_t column) const noexcept {
    const auto hit =
        std::find_if(series.begin(), series.end(), [&](const Series& one) { return one.column == column; });
    return hit == series.end() ? nullptr : &*hit;
}

std::vector<ColumnChoice> parse_column_choices(std::string_view text) {
    std::vector<ColumnChoice> choices;
    if (core::trimmed(text).empty()) return choices;
    for (const std::string& part : core::split(text, ',')) {
        const std::size_t equals = part.find('=');
        const std::string right = equals == std::string::npos ? "" : part.substr(equals + 1);
        const std::size_t colon = right.rfind(':');
        ColumnChoice choice{std::string{core::trimmed(part.substr(0, equals))},
                            std::string{core::trimmed(right.substr(0, colon))},
                            colon == std::string::npos ? "" : std::string{core::trimmed(right.substr(colon + 1))}};
        if (choice.quantity.empty() || choice.column.empty())
            throw Error(ExitCode::usage, "--columns", core::quoted(part) + " names no column",
                        "write e.g. pressure=2,elongation=1:mm");
        choices.push_back(std::move(choice));
    }
    return choices;
}

Measured read_measured(const core::Table& file, const Curve& curve, std::span<const ColumnChoice> choices) {
    Matcher matcher(file, curve);
    for (const ColumnChoice& choice : choices) matcher.choose(choice);
    matcher.match_names();

    const Source base = curve.find(Source::time) != nullptr ? Source::time : Source::load;
    const auto found = [&](auto wanted) {
        for (std::size_t i = 0; i < curve.columns.size(); ++i)
            if (wanted(curve.columns[i]) && matcher.has(i)) return true;
        return false;
    };
    const auto is_base = [&](const Column& column) { return column.source == base; };
    const auto is_other = [&](const Column& column) { return column.source != base; };
    if (!found(is_base)) matcher.match_units(is_base);
    if (!found(is_other))
        matcher.match_units(
            [](const Column& column) { return column.source == Source::output || column.source == Source::volume; });
    if (!found(is_base) || !found(is_other)) {
        const Column& column = *curve.find(base);
        const auto lacks = std::ranges::find_if(curve.columns, [&](const Column& c) {
            return found(is_base) ? c.role == Role::coordinate && is_other(c) : is_base(c);
        });
        const std::string unit = lacks == curve.columns.end() || lacks->unit.empty() ? "" : ":" + lacks->unit;
        throw Error(
            ExitCode::bad_input, file.source,
            found(is_base)
                ? "no quantity to compare with the " + column.quantity + " was found among " + column_list(file)
                : "no " + column.quantity + " was found among " + column_list(file),
            (lacks == curve.columns.end() ? std::string{}
                                          : "name its column, e.g. --columns " + lacks->quantity + "=1" + unit + "; ") +
                "the case has " + curve.coordinate_names());
    }

    Measured measured{file.source, file.lines, {}};
    for (const Match& match : matcher.matches()) {
        const Column& column = curve.columns[match.of_curve];
        Series series{match.of_curve, core::values_SI(file, match.of_file, match.unit, column.dimension),
                      core::column_text(file, match.of_file)};
        for (double& value : series.values) value = in_column_unit(column, value);
        measured.series.push_back(std::move(series));
    }
    std::sort(measured.series.begin(), measured.series.end(),
              [](const Series& a, const Series& b) { return a.column < b.column; });
    return measured;
}

}  // namespace soft::post
