/// workspace-grid: writes a design whose path passes through all combinations of chamber pressures; from its result it prints the
/// points reached by the end face and the volume of their convex hull, and draws a plot.
///     workspace-grid designs/segment.yaml --pressures chamber_1=12kPa,chamber_2=12kPa > grid.yaml
///     workspace-grid --results result.h5 > workspace.csv
/// scripts/workspace runs mesh-gen and solve between the two.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "design/design.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "post/gnuplot.hpp"
#include "post/plot.hpp"
#include "surface/hull.hpp"
#include "sweep/sampling.hpp"

namespace {

using namespace soft;

constexpr double max_points = 5000;  // stages of one path
constexpr std::array axes{"x", "y", "z"};

const cli::About about{
    .tool = "workspace-grid",
    .summary = "writes a grid of chamber pressures as one path, or the points that its result reaches (CSV)",
    .examples = {{"workspace-grid designs/segment.yaml --pressures chamber_1=12kPa,chamber_2=12kPa -o grid.yaml",
                  "Writes a design whose path passes through 3 x 3 combinations"},
                 {"workspace-grid --results result.h5 --plot reach.svg > workspace.csv",
                  "Prints the points reached, also of an unfinished path"}},
    .libraries = [] {
        return std::vector<cli::Library>{
            {"CGAL", cli::built_with::cgal}, {"HDF5", cli::built_with::hdf5}, {"yaml-cpp", cli::built_with::yaml_cpp}};
    }};

struct GridOptions {
    cli::CommonOptions common;
    std::string input, pressures, face = "end", results, plot;
    std::vector<std::string> sets;
    int steps = 2;
};

std::optional<GridOptions> parse_grid_options(int argc, char** argv) {
    GridOptions options;
    std::string steps = "2";
    CLI::App app;
    cli::add_input(app, options.input, "DESIGN", "The design (YAML)");
    app.add_option("--pressures", options.pressures,
                   "Maximum pressure of each chamber: chamber_1=12kPa,chamber_2=12kPa")
        ->type_name("LIST");
    app.add_option("--steps", steps, "Number of pressure steps per chamber (number of values minus one)")
        ->type_name("N");
    app.add_option("--face", options.face, "Face whose mean displacement defines the point")->capture_default_str();
    app.add_option("--results", options.results, "Print the points of this result of a grid")->type_name("FILE");
    app.add_option("--plot", options.plot, "Draw the points (.svg, .png or .pdf)")->type_name("FILE");
    cli::add_set_option(app, options.sets);
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    const auto count = core::parse_count(steps);
    const long* number = std::get_if<long>(&count);
    if (number == nullptr || *number < 1 || *number > 99)
        throw Error(ExitCode::usage, "--steps", core::quoted(steps) + " is not a number from 1 to 99");
    options.steps = static_cast<int>(*number);
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));
    if (options.results.empty() && options.pressures.empty())
        throw Error(ExitCode::usage, "--pressures", "is missing",
                    "give the maximum pressure of each chamber: --pressures chamber_1=12kPa,chamber_2=12kPa");
    cli::check_distinct({{"DESIGN", options.input}, {"--results", options.results}}, options.common,
                        {{"--plot", options.plot}});
    return options;
}

struct Chamber {
    std::string name;
    double number;  ///< maximum pressure in `unit`
    std::string unit;
};

std::vector<Chamber> chambers_of(std::string_view list) {
    std::vector<Chamber> chambers;
    for (const std::string& entry : core::split(list, ',')) {
        const std::size_t equals = std::min(entry.find('='), entry.size());
        const auto refuse = [&entry](const std::string& problem) {
            return Error(ExitCode::usage, "--pressures", core::quoted(entry) + problem, "write chamber_1=12kPa");
        };
        if (equals == 0 || equals == entry.size()) throw refuse(" is not of the form chamber=pressure");
        const std::string text = entry.substr(equals + 1);
        const auto pressure = core::parse_quantity(text, core::Dimension::pressure);
        if (const auto* refusal = std::get_if<core::Refusal>(&pressure)) throw refuse(": " + refusal->problem);
        const core::QuantityParts parts = core::quantity_parts(text);
        Chamber chamber{std::string{core::trimmed(entry.substr(0, equals))}, 0, parts.unit};
        std::from_chars(parts.number.data() + (parts.number.starts_with('+') ? 1 : 0),
                        parts.number.data() + parts.number.size(), chamber.number);
        if (std::ranges::find(chambers, chamber.name, &Chamber::name) != chambers.end())
            throw refuse(" repeats a chamber");
        chambers.push_back(std::move(chamber));
    }
    return chambers;
}

/// Every point is an equilibrium to the residual tolerance, and no value is interpolated between two rows, so the steps may be long.
constexpr const char* step_accuracy = "0.02";

std::string pressure_text(const Chamber& chamber, double share) {
    return "{pressure: " + core::rounded_text(share * chamber.number, 12) + " " + chamber.unit + "}";
}

/// One stage per point except the first, the unloaded state; each stage changes the pressure of one chamber.
std::string stages_text(const std::vector<Chamber>& chambers, const sweep::GrayCode& code, int steps) {
    std::string text;
    std::vector<int> last(chambers.size(), 0);
    for (std::size_t point = 1; point < static_cast<std::size_t>(code.size()); ++point) {
        const std::vector<int> now = code.at(point);
        const auto changed = static_cast<std::size_t>(std::ranges::mismatch(now, last).in1 - now.begin());
        text.append(point == 1 ? "" : ", ").append("p").append(std::to_string(point)).append(": {loads: {cavities: {");
        text.append(chambers[changed].name).append(": ");
        text.append(pressure_text(chambers[changed], static_cast<double>(now[changed]) / steps)).append("}}}");
        last = now;
    }
    return "{stages: {" + text + "}, contact: ignore}";
}

ExitCode write_grid(const GridOptions& options) {
    const std::vector<Chamber> chambers = chambers_of(options.pressures);
    const sweep::GrayCode code{static_cast<int>(chambers.size()), options.steps + 1};
    if (code.size() > max_points)
        throw Error(ExitCode::usage, "--steps " + std::to_string(options.steps),
                    core::counted(chambers.size(), "chamber") + " make " + core::rounded_text(code.size(), 9) +
                        " points, more than " + core::rounded_text(max_points, 6),
                    "use fewer steps");
    std::string loads, outputs;
    for (const Chamber& chamber : chambers)
        loads.append(loads.empty() ? "" : ", ").append(chamber.name + ": " + pressure_text(chamber, 1));
    for (const std::string axis : axes)
        outputs.append(outputs.empty() ? "" : ", ")
            .append(axis + ": {face: " + options.face + ", along: " + axis + "}");
    std::vector<design::Override> settings{{"loads", "{cavities: {" + loads + "}}", "--pressures"},
                                           {"path", stages_text(chambers, code, options.steps), "--pressures"},
                                           {"outputs", "{" + outputs + "}", "--face"},
                                           {"solver.step_accuracy", step_accuracy, "--steps"}};
    for (const std::string& set : options.sets) settings.push_back(design::parse_override(set));
    const cli::Input input = cli::read_design(options.input);
    const auto read = [&] {
        return design::read_design(input.text(), input.source, geometry::catalogue_keys(), settings);
    };
    design::Design grid = read();
    for (const char* key :
         {"geometry.file", "geometry.profile"}) {  // absolute, so that the grid design can be stored anywhere
        if (!grid.values.has(key)) continue;
        const std::filesystem::path file = design::file_from(grid.values.location(key), grid.values.text(key));
        settings.push_back({key, std::filesystem::absolute(file).lexically_normal().string()});
        grid = read();
    }
    cli::write_output(options.common.output, grid.effective_yaml);
    return ExitCode::ok;
}

/// The unloaded state and the last row of each completed stage; the last stage is complete only if the path is done.
std::vector<std::size_t> point_rows(const io::Result& result) {
    std::vector<std::size_t> rows;
    const std::vector<model::Step>& steps = result.steps;
    const bool is_done = result.end && result.end->reason == model::StopReason::done;
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const bool is_last = row + 1 == steps.size();
        const bool ends_stage = row > 0 && (is_last ? is_done : steps[row + 1].stage != steps[row].stage);
        if (row == 0 || ends_stage) rows.push_back(row);
    }
    return rows;
}

struct Points {
    std::vector<std::string> names;            ///< of the columns
    std::vector<std::vector<double>> columns;  ///< the pressures [kPa], then x, y, z [mm]
};

Points points_of(const io::Result& result) {
    Points points;
    const std::vector<std::size_t> rows = point_rows(result);
    const auto add = [&](const std::string& name, auto value) {
        points.names.push_back(name);
        std::vector<double>& column = points.columns.emplace_back();
        for (const std::size_t row : rows) column.push_back(value(result.steps[row]));
    };
    const auto& loads = result.model.loads;
    for (std::size_t i = 0; i < loads.size(); ++i)
        add("pressure_" + loads[i].name + "_kPa", [&, i](const model::Step& step) {
            return (loads.size() > 1 ? step.pressures_Pa[i] : step.pressure_Pa) / 1e3;
        });
    for (const std::string axis : axes) {
        const auto output = std::ranges::find(result.model.outputs, axis, &model::Output::name);
        if (output == result.model.outputs.end())
            throw Error(ExitCode::bad_input, result.model.name, "the result has no output " + core::quoted(axis),
                        "give the result of a design that workspace-grid has written");
        const auto index = static_cast<std::size_t>(output - result.model.outputs.begin());
        add(axis + "_mm", [index](const model::Step& step) { return step.outputs[index] * 1e3; });
    }
    return points;
}

std::string csv_text(const Points& points) {
    std::string text = core::join(points.names, ",") + "\n";
    for (std::size_t row = 0; row < points.columns.front().size(); ++row)
        for (std::size_t c = 0; c < points.columns.size(); ++c)
            text.append(core::number_text(points.columns[c][row] + 0.0))
                .append(c + 1 < points.columns.size() ? "," : "\n");
    return text;
}

/// Both panels have the same scale; an axis with almost no displacement still has a tenth of the longest range.
std::string range_text(const std::vector<double>& column, double half_extent) {
    const auto [low, high] = std::ranges::minmax(column);
    const double half = 1.1 * std::max({(high - low) / 2, half_extent / 10, 1e-9}), middle = (low + high) / 2;
    return "[" + core::number_text(middle - half) + ":" + core::number_text(middle + half) + "]\n";
}

/// Plots the points projected along x and along y.
void draw(const Points& points, const std::string& file) {
    const std::size_t n = points.columns.size();
    std::string data, script = post::terminal(post::picture_format(file), 2) + post::axes_style();
    for (std::size_t row = 0; row < points.columns.front().size(); ++row) {
        for (std::size_t c = n - 3; c < n; ++c) data += core::number_text(points.columns[c][row]) + " ";
        data += "\n";
    }
    double half_extent = 0;
    for (std::size_t c = n - 3; c < n; ++c) {
        const auto [low, high] = std::ranges::minmax(points.columns[c]);
        half_extent = std::max(half_extent, (high - low) / 2);
    }
    const auto range = [&](std::size_t axis) { return range_text(points.columns[n - 3 + axis], half_extent); };
    script += "$points << END\n" + data + "END\nset multiplot layout 1,2\nset size ratio -1\n";
    for (const std::size_t axis : {1U, 0U})
        script += "set xlabel '" + std::string{axes[axis]} + " (mm)'\nset ylabel 'z (mm)'\nset xrange " + range(axis) +
                  "set yrange " + range(2) + "plot $points using " + std::to_string(axis + 1) +
                  ":3 with points pointtype 7 pointsize 1 linecolor rgb '#0072B2' notitle\n";
    post::run_gnuplot(script + "unset multiplot\n", file);
}

ExitCode write_points(const GridOptions& options) {
    cli::Input input = cli::read_hdf5_input(options.results);
    const io::Result result = io::read_result(std::move(input.bytes), input.source, geometry::rebuild_case);
    if (result.steps.empty()) throw Error(ExitCode::bad_input, input.source, "the path has no rows");
    const Points points = points_of(result);
    cli::write_output(options.common.output, csv_text(points));
    std::vector<mesh::Point> positions;
    const std::size_t n = points.columns.size(), count = points.columns.front().size();
    for (std::size_t row = 0; row < count; ++row)
        positions.push_back(
            {points.columns[n - 3][row] / 1e3, points.columns[n - 2][row] / 1e3, points.columns[n - 1][row] / 1e3});
    const double volume_m3 = surface::hull_volume_m3(positions);
    if (!options.plot.empty()) draw(points, options.plot);
    const std::size_t all = result.model.path.stages.size() + 1;
    const std::string of_all = count < all ? " of " + std::to_string(all) : "";
    cli::Console{about, options.common}.say(std::to_string(count) + of_all + " points; volume of their convex hull " +
                                            core::rounded_text(1e9 * volume_m3, 6) + " mm^3");
    nlohmann::ordered_json json = cli::summary_head(about.tool);
    json.update({{"points", count}, {"points_of_the_grid", all}, {"volume_m3", volume_m3}});
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
    return ExitCode::ok;
}

ExitCode workspace_grid(const GridOptions& options) {
    return options.results.empty() ? write_grid(options) : write_points(options);
}

}  // namespace

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, parse_grid_options, workspace_grid); }
