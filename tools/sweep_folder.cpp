#include "sweep_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <future>
#include <optional>
#include <span>
#include <system_error>
#include <thread>

#include "cli.hpp"
#include "core/files.hpp"
#include "core/subprocess.hpp"
#include "core/text.hpp"
#include "geometry/build.hpp"
#include "io/result_file.hpp"
#include "post/csv.hpp"
#include "post/curve.hpp"
#include "sweep/derivatives.hpp"

namespace soft {
namespace {

namespace fs = std::filesystem;

bool has_curve(int exit_code) {
    return exit_code == static_cast<int>(ExitCode::ok) || exit_code == static_cast<int>(ExitCode::stopped_early);
}

bool is_present(const fs::path& file) {
    std::error_code unknown;
    return fs::exists(file, unknown);
}

constexpr std::size_t max_status = std::size_t{1} << 20;  // bytes; a few lines are usual

/// The folder of a design inside that of the sweep; a valid ID cannot point outside.
fs::path folder_of(const fs::path& folder, const sweep::PlannedDesign& design) {
    if (!sweep::is_design_id(design.id))
        throw Error(ExitCode::internal, core::quoted(design.id), "is not a valid design ID");
    return folder / design.id;
}

/// nullopt for a missing or invalid status; the design is then computed again.
std::optional<sweep::Status> status_in(const fs::path& folder) {
    std::error_code unknown;
    if (!fs::is_regular_file(folder / "status", unknown)) return std::nullopt;
    try {
        const core::Bytes bytes = core::read_regular_file(folder / "status", max_status);
        return sweep::read_status({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const Error& error) {
        if (error.code() != ExitCode::bad_input) throw;
        return std::nullopt;
    }
}

sweep::State state_in(const fs::path& folder, const sweep::PlannedDesign& design) {
    if (!design.refusal.empty()) return sweep::State::refused;
    const auto status = folder.empty() ? std::nullopt : status_in(folder_of(folder, design));
    const bool done = status && sweep::is_final(status->exit_code) &&
                      (!has_curve(status->exit_code) || is_present(folder_of(folder, design) / "result.h5"));
    return done ? sweep::State::done : sweep::State::waiting;
}

io::Result whole_result(const fs::path& file) {
    io::Result result =
        io::read_result(core::read_regular_file(file, core::no_limit), file.string(), geometry::rebuild_case);
    if (!result.end) throw Error(ExitCode::bad_input, file.string(), "contains an unfinished path");
    return result;
}

/// What is collected from each result.
struct Collection {
    const sweep::Sweep& sweep;
    std::size_t trace_points;
};

/// Also writes the curve to `table`. The engines leave this to sweep-plan because a separate process per design would cost more.
void add_curve(const io::Result& result, const fs::path& table, const Collection& wanted, sweep::Outcome& outcome) {
    const sweep::Sweep& sweep = wanted.sweep;
    const post::Curve curve = post::make_curve(result.model, result.steps, *result.end);
    if (!is_present(table)) cli::write_output(table.string(), post::csv_text(curve));
    sweep::Outputs outputs = sweep::outputs_of(sweep, curve, result.end->limit_points);
    outcome.outputs = std::move(outputs.cells);
    for (const post::Column& column : curve.columns) outcome.columns.push_back(column.name);
    if (wanted.trace_points > 0) outcome.trace = sweep::make_trace(curve, wanted.trace_points);
    const sweep::Outputs derivatives = sweep::derivatives_of(sweep, curve, {result.model, result.steps, *result.end});
    outcome.outputs.insert(outcome.outputs.end(), derivatives.cells.begin(), derivatives.cells.end());
    outputs.missing.insert(outputs.missing.end(), derivatives.missing.begin(), derivatives.missing.end());
    outcome.stop_reason = model::name(result.end->reason);
    if (outcome.exit_code != static_cast<int>(ExitCode::ok)) outcome.error = result.end->detail;
    for (const std::string& reason : outputs.missing)
        outcome.error.append(outcome.error.empty() ? "" : "; ").append(reason);
}

sweep::Outcome outcome_in(const fs::path& folder, const Collection& wanted, const sweep::PlannedDesign& design) {
    sweep::Outcome outcome;
    if (!design.refusal.empty()) {
        outcome.exit_code = static_cast<int>(ExitCode::bad_input);
        outcome.stop_reason = "refused";
        outcome.error = design.refusal;
        return outcome;
    }
    const fs::path own = folder_of(folder, design);
    const auto status = status_in(own);
    outcome.stop_reason = status ? "failed" : "not_computed";
    if (!status) return outcome;
    outcome.exit_code = status->exit_code;
    outcome.error = status->error;
    if (status->exit_code == static_cast<int>(ExitCode::bad_input)) outcome.stop_reason = "refused";
    if (!has_curve(status->exit_code)) return outcome;
    const fs::path file = own / "result.h5";
    if (!is_present(file)) return {.stop_reason = "not_computed", .error = "its result.h5 was removed"};
    std::optional<io::Result> result;
    try {
        result = whole_result(file);
    } catch (const Error& error) {
        outcome.exit_code = static_cast<int>(error.code());
        outcome.error = error.what() + std::string{"; remove its folder to compute it again"};
        return outcome;
    }
    add_curve(*result, own / "curve.csv", wanted, outcome);
    return outcome;
}

using Designs = std::span<const sweep::PlannedDesign>;

std::vector<sweep::Outcome> outcomes_of(const fs::path& folder, const Collection& wanted, Designs designs) {
    std::vector<sweep::Outcome> outcomes;
    for (const sweep::PlannedDesign& design : designs) outcomes.push_back(outcome_in(folder, wanted, design));
    return outcomes;
}

using Json = nlohmann::json;

template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

template <class Value>
std::optional<Value> value_of(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional{json.get<Value>()};
}

core::Bytes packed(const std::vector<sweep::Outcome>& outcomes) {
    Json rows = Json::array();
    for (const sweep::Outcome& outcome : outcomes) {
        Json outputs = Json::array();
        for (const auto& [column, value, label, unit] : outcome.outputs)
            outputs.push_back(Json::array({column, json_of(value), label, unit}));
        Json trace = Json::array();
        for (const auto& [name, label, unit, values] : outcome.trace)
            trace.push_back(Json::array({name, label, unit, values}));
        rows.push_back(Json::array({json_of(outcome.exit_code), outcome.stop_reason, outcome.error, outcome.columns,
                                    std::move(outputs), std::move(trace)}));
    }
    const std::vector<std::uint8_t> numbers = Json::to_cbor(rows);
    const auto bytes = std::as_bytes(std::span{numbers});
    return {bytes.begin(), bytes.end()};
}

std::vector<sweep::Outcome> unpacked(const core::Bytes& bytes) {
    std::vector<sweep::Outcome> outcomes;
    for (const Json& row : Json::from_cbor(bytes)) {
        sweep::Outcome& outcome = outcomes.emplace_back();
        outcome.exit_code = value_of<int>(row[0]);
        outcome.stop_reason = row[1];
        outcome.error = row[2];
        outcome.columns = row[3];
        for (const Json& output : row[4])
            outcome.outputs.push_back({output[0], value_of<double>(output[1]), output[2], output[3]});
        for (const Json& column : row[5]) outcome.trace.push_back({column[0], column[1], column[2], column[3]});
    }
    return outcomes;
}

/// Collects the outcomes in a subprocess; no result if it fails.
core::SubprocessOutcome pack_in_subprocess(const fs::path& folder, const Collection& wanted, Designs designs) {
    try {
        return core::run_in_subprocess([&] { return packed(outcomes_of(folder, wanted, designs)); },
                                       {std::chrono::hours{24}});
    } catch (const Error& error) {
        return {std::nullopt, error.what()};
    }
}

}  // namespace

std::vector<sweep::State> states_in(const fs::path& folder, const sweep::Plan& plan) {
    std::vector<sweep::State> states;
    for (const sweep::PlannedDesign& design : plan.designs) states.push_back(state_in(folder, design));
    return states;
}

std::vector<sweep::Outcome> outcomes_in(const fs::path& folder, const sweep::Sweep& sweep, const sweep::Plan& plan,
                                        std::size_t trace_points) {
    const Collection wanted{sweep, trace_points};
    // Reading a result takes a tenth of the time of a small solve, so results are read in parallel.
    const Designs designs{plan.designs};
    const std::size_t max_parts = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t parts = std::clamp<std::size_t>(designs.size() / 2, 1, max_parts);
    std::vector<std::pair<Designs, std::future<core::SubprocessOutcome>>> running;
    for (std::size_t part = 0, from = 0; part < parts; ++part) {
        const std::size_t to = designs.size() * (part + 1) / parts;
        const Designs share = designs.subspan(from, to - from);
        running.emplace_back(share, std::async(std::launch::async, [&folder, &wanted, share] {
                                 return pack_in_subprocess(folder, wanted, share);
                             }));
        from = to;
    }
    std::vector<std::optional<core::Bytes>> ends;  // wait for all before reading here: HDF5 is not thread-safe
    for (auto& [share, end] : running) ends.push_back(end.get().result);
    std::vector<sweep::Outcome> outcomes;
    for (std::size_t part = 0; part < parts; ++part) {
        // Repeat a failed part in this process, which then reports the error.
        const auto found = ends[part] ? unpacked(*ends[part]) : outcomes_of(folder, wanted, running[part].first);
        outcomes.insert(outcomes.end(), found.begin(), found.end());
    }
    return outcomes;
}

void write_designs(const fs::path& folder, const sweep::Plan& plan, const std::vector<sweep::State>& states) {
    const fs::path designs = folder / "designs";
    cli::make_folder(designs.string());
    for (std::size_t d = 0; d < states.size(); ++d) {
        fs::path file = folder_of(designs, plan.designs[d]);
        file += ".yaml";
        if (states[d] == sweep::State::waiting && !is_present(file))
            cli::write_output(file.string(), plan.designs[d].design_yaml);
    }
}

}  // namespace soft
