#include "sweep/outcome.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "core/units.hpp"
#include "post/request.hpp"

namespace soft::sweep {
namespace {

bool is_requested(const Sweep& sweep, const post::Column& column) {
    if (sweep.outputs.empty()) return column.role != post::Role::counter;
    return std::ranges::find(sweep.outputs, column.name, &SourceText::text) != sweep.outputs.end();
}

std::vector<post::Request> requests_of(const SourceText& point, const post::Curve& curve) {
    try {
        return post::parse_requests(point.text, curve);
    } catch (const Error& error) {
        throw Error(ExitCode::bad_input, point.location + ": at", error.what());
    }
}

bool is_named_point(const SourceText& point) { return point.text == "end" || point.text == "limit"; }

struct Row {
    std::optional<std::vector<double>> values;  ///< all columns, in the order of the curve
    std::string missing;                        ///< the reason if there are no values
};

Row row_at(const SourceText& point, const post::Curve& curve, std::span<const model::LimitPoint> limit_points) {
    const auto row = [&curve](std::size_t r) {
        std::vector<double> values;
        for (const post::Column& column : curve.columns) values.push_back(column.values.at(r));
        return values;
    };
    if (curve.row_count() == 0) return {std::nullopt, "at " + point.text + ": the path has no rows"};
    if (point.text == "end") return {row(curve.row_count() - 1), ""};
    if (point.text == "limit") {
        if (limit_points.empty()) return {std::nullopt, "at limit: the path has no limit point"};
        return {row(static_cast<std::size_t>(limit_points.front().step)), ""};
    }
    try {
        const post::Curve there = post::rows_at(curve, requests_of(point, curve));
        std::vector<double> values;
        for (const post::Column& column : there.columns) values.push_back(column.values.front());
        return {values, ""};
    } catch (const Error& error) {
        const std::string_view reason = error.what();
        constexpr std::string_view option = "--at ";
        if (!reason.starts_with(option)) throw;  // not a point that any path could reach
        return {std::nullopt, "at " + std::string{reason.substr(option.size())}};
    }
}

/// A value or a unit as part of a column name.
std::string name_part(std::string_view text) {
    std::string name;
    for (const char c : text) {
        const bool is_plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
        if (is_plain) name += c;
        if (c == '.') name += 'p';
        if (c == '-') name += "minus";
        if (c == '%') name += "percent";
        if (c == '/') name += "_per_";
    }
    return name;
}

}  // namespace

std::optional<Status> read_status(std::string_view text) {
    Status status;
    bool known = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t blank = std::min(line.find(' '), line.size());
        const std::string_view key = line.substr(0, blank), value = core::trimmed(line.substr(blank));
        if (key == "error") status.error = value;
        if (key != "exit_code") continue;
        const auto parsed = core::parse_count(value);
        if (!std::holds_alternative<long>(parsed)) return std::nullopt;
        status.exit_code = static_cast<int>(std::get<long>(parsed));
        known = true;
    }
    return known ? std::optional{status} : std::nullopt;
}

bool is_final(int exit_code) noexcept {
    constexpr std::array finals{ExitCode::ok,    ExitCode::check_failed, ExitCode::stopped_early,
                                ExitCode::usage, ExitCode::bad_input,    ExitCode::internal};
    return std::ranges::any_of(finals, [exit_code](ExitCode code) { return static_cast<int>(code) == exit_code; });
}

std::string column_at(const std::string& column, const std::string& point, const post::Curve& curve) {
    const std::size_t equals = point.find('=');
    if (equals == std::string::npos) return column + "_at_" + point;
    const std::string quantity{core::trimmed(std::string_view{point}.substr(0, equals))};
    const core::QuantityParts value = core::quantity_parts(point.substr(equals + 1));
    const post::Column* named = curve.find(quantity);
    const bool is_load = named != nullptr && named->source == post::Source::load;
    const std::string number = name_part(value.number), unit = name_part(value.unit);
    const bool needs_separator = !unit.empty() && unit.front() >= '0' && unit.front() <= '9';  // "3 1/m"
    return column + "_at_" + (is_load ? "" : quantity + "_") + number + (needs_separator ? "_" : "") + unit;
}

Outputs outputs_of(const Sweep& sweep, const post::Curve& curve, std::span<const model::LimitPoint> limit_points) {
    Outputs outputs;
    for (const SourceText& point : sweep.at) {
        const auto [values, missing] = row_at(point, curve, limit_points);
        if (!values) outputs.missing.push_back(missing);
        const std::string requested_quantity = point.text.substr(0, point.text.find('='));
        for (std::size_t c = 0; c < curve.columns.size(); ++c) {
            const post::Column& column = curve.columns[c];
            if (!is_requested(sweep, column) || (sweep.outputs.empty() && column.quantity == requested_quantity))
                continue;
            outputs.cells.push_back(
                {column_at(column.name, point.text, curve), values ? std::optional{(*values)[c]} : std::nullopt});
        }
    }
    return outputs;
}

post::Curve unsolved_curve(const model::Case& model) {
    model::Step step;
    step.outputs.assign(model.outputs.size(), 0);
    if (model.loads.size() > 1) step.pressures_Pa.assign(model.loads.size(), 0);
    const std::size_t cavities = model::measured_cavities(model).size();
    if (cavities > 0) step.volume_m3 = 0;
    if (cavities > 1) step.volumes_m3.assign(cavities, 0);
    if (model.dynamics) step.motion = model::Step::Motion{};
    step.energies = model::Step::Energies{};
    step.extremes = model::Step::Extremes{};
    return post::make_curve(model, {&step, 1});
}

void check_outputs(const Sweep& sweep, std::span<const std::string> known) {
    for (const SourceText& output : sweep.outputs)
        if (std::ranges::find(known, output.text) == known.end())
            throw Error(ExitCode::bad_input, output.location + ": outputs",
                        "no curve has a column " + core::quoted(output.text), core::did_you_mean(output.text, known));
}

void check_requests(const Sweep& sweep, const post::Curve& curve) {
    for (const SourceText& point : sweep.at)
        if (!is_named_point(point)) static_cast<void>(requests_of(point, curve));
    std::vector<std::string> known;
    for (const post::Column& column : curve.columns) known.push_back(column.name);
    check_outputs(sweep, known);
}

}  // namespace soft::sweep
