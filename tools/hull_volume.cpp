/// hull-volume: computes the volume of the convex hull of a table of points.
///     hull-volume workspace.csv
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli.hpp"
#include "core/table.hpp"
#include "core/text.hpp"
#include "library_versions.hpp"
#include "surface/hull.hpp"

namespace {

using namespace soft;

const cli::About about{.tool = "hull-volume",
                       .summary = "computes the volume of the convex hull of points (CSV)",
                       .examples = {{"hull-volume workspace.csv", "Convex hull of the columns x_mm, y_mm and z_mm"},
                                    {"hull-volume points.csv --json -", "Number of points and volume in SI units"}},
                       .libraries = [] {
                           return std::vector<cli::Library>{{"CGAL", cli::built_with::cgal}};
                       }};

struct HullOptions {
    cli::CommonOptions common;
    std::string input;
};

std::optional<HullOptions> parse_hull_options(int argc, char** argv) {
    HullOptions options;
    CLI::App app;
    cli::add_input(app, options.input, "TABLE", "CSV with columns x, y and z with length units");
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    cli::check_distinct({{"TABLE", options.input}}, options.common);
    return options;
}

std::vector<double> lengths_m(const core::Table& points, const std::string& quantity) {
    const auto found = std::ranges::find(points.headings, quantity, &core::Heading::quantity);
    if (found == points.headings.end() || core::dimension_of(found->unit) != core::Dimension::length)
        throw Error(ExitCode::bad_input, points.source, "there is no column " + quantity + " with a length unit",
                    "use the header x_mm,y_mm,z_mm");
    return core::values_SI(points, static_cast<std::size_t>(found - points.headings.begin()), found->unit,
                           core::Dimension::length);
}

ExitCode hull_volume(const HullOptions& options) {
    const cli::Input input = cli::read_input(options.input, cli::max_table_bytes);
    const core::Table table = core::read_table(input.text(), input.source);
    const std::array columns{lengths_m(table, "x"), lengths_m(table, "y"), lengths_m(table, "z")};
    std::vector<mesh::Point> points;
    for (std::size_t row = 0; row < columns[0].size(); ++row)
        points.push_back({columns[0][row], columns[1][row], columns[2][row]});
    const double volume_m3 = surface::hull_volume_m3(points);
    cli::write_output(options.common.output, "points,volume_mm3\n" + std::to_string(points.size()) + "," +
                                                 core::number_text(1e9 * volume_m3) + "\n");
    nlohmann::ordered_json json = cli::summary_head(about.tool);
    json.update({{"points", points.size()}, {"volume_m3", volume_m3}});
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
    return ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, parse_hull_options, hull_volume); }
