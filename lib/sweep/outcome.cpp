#include "sweep/outcome.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "core/units.hpp"
#include "sweep/point.hpp"

namespace soft::sweep {
namespace {

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
            outputs.cells.push_back({column_at(column.name, point.text, curve),
                                     values ? std::optional{(*values)[c]} : std::nullopt,
                                     label_at(column.quantity, point.text), column.unit});
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
    if (model::is_timed(model)) step.time_s = 0;
    step.energies = model::Step::Energies{};
    if (model::is_inelastic(model)) step.energies->dissipated_J = 0;
    if (model::has_friction(model)) step.friction_J = 0;
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
