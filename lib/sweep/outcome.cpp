#include "sweep/outcome.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "core/units.hpp"
#include "post/request.hpp"

namespace soft::sweep {
namespace {

bool is_wanted(const Sweep& sweep, const post::Column& column) {
    if (sweep.outputs.empty()) return column.role != post::Role::counter;
    return std::ranges::find(sweep.outputs, column.name, &Written::text) != sweep.outputs.end();
}

/// The rows `curve` has at a place, all columns in the order of the curve; none where the path does not come there.
std::optional<std::vector<double>> row_at(const Written& place, const post::Curve& curve,
                                          std::span<const solution::LimitPoint> limit_points) {
    const auto row = [&curve](std::size_t r) {
        std::vector<double> values;
        for (const post::Column& column : curve.columns) values.push_back(column.values.at(r));
        return values;
    };
    if (place.text == "end") return curve.row_count() == 0 ? std::nullopt : std::optional{row(curve.row_count() - 1)};
    if (place.text == "limit")
        return limit_points.empty() ? std::nullopt
                                    : std::optional{row(static_cast<std::size_t>(limit_points.front().step))};
    std::vector<post::Request> requests;
    try {
        requests = post::parse_requests(place.text, curve);
    } catch (const Error& error) {
        throw Error(ExitCode::bad_input, place.place + ": at", error.what());
    }
    try {
        const post::Curve there = post::rows_at(curve, requests);
        std::vector<double> values;
        for (const post::Column& column : there.columns) values.push_back(column.values.front());
        return values;
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input) throw Error(ExitCode::bad_input, place.place + ": at", error.what());
        return std::nullopt;  // not reached
    }
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

std::vector<Cell> outputs_of(const Sweep& sweep, const post::Curve& curve,
                             std::span<const solution::LimitPoint> limit_points) {
    std::vector<Cell> cells;
    for (const Written& place : sweep.at) {
        const auto values = row_at(place, curve, limit_points);
        const std::string asked = place.text.substr(0, place.text.find('='));
        for (std::size_t c = 0; c < curve.columns.size(); ++c) {
            const post::Column& column = curve.columns[c];
            if (!is_wanted(sweep, column) || (sweep.outputs.empty() && column.quantity == asked)) continue;
            cells.push_back({column.name + "@" + place.text, values ? std::optional{(*values)[c]} : std::nullopt});
        }
    }
    return cells;
}

}  // namespace soft::sweep
