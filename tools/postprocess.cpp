/// postprocess: a result -> the curve (CSV), the curve at given values, a picture.
///     postprocess bellows.h5 --at elongation=20mm,40mm,80mm,130mm
///     mesh-gen designs/bellows.yaml | solve | postprocess --plot curve.svg > curve.csv
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "post/csv.hpp"
#include "post/curve.hpp"
#include "post/plot.hpp"
#include "post/request.hpp"
#include "postprocess_summary.hpp"

namespace soft {
namespace {

struct PostprocessOptions {
    cli::CommonOptions common;
    std::string input;
    std::vector<std::string> at;
    std::string plot;
    bool comments = false;
};

std::vector<cli::Library> libraries() { return {{"HDF5", cli::built_with::hdf5}}; }

const cli::About about{.tool = "postprocess",
                       .summary = "the pressure curve of a result: table, values, picture",
                       .examples = {{"solve bellows-case.h5 | postprocess --plot curve.svg > curve.csv",
                                     "The whole curve as CSV, and a picture of it"},
                                    {"postprocess bellows.h5 --at pressure=10kPa,20kPa --at elongation=40mm",
                                     "The state at two pressures and at one elongation"}},
                       .libraries = libraries};

std::optional<PostprocessOptions> parse_options(int argc, char** argv) {
    PostprocessOptions options;
    CLI::App app;
    cli::add_input(app, options.input, "RESULT", "result written by solve");
    app.add_option("--at", options.at,
                   "Only the states at these values, by cubic interpolation along the path (repeatable)")
        ->type_name("QUANTITY=VALUE[,VALUE...]")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--plot", options.plot, "Draw the curve to FILE.svg or FILE.png; needs gnuplot")->type_name("FILE");
    app.add_flag("--comments", options.comments, "Lines '# ...' before the header: how the result was made");
    cli::add_common_options(app, options.common, about);
    app.footer(
        "Columns (those a case does not have are left out): step, time_s, stage (1, 2 ..., where there are several), pressure_kPa\n"
        "(of the first load; traction_kPa or load_factor where nothing is under pressure), <output>_mm (an angle: _deg),\n"
        "volume_mL, pressure_<load>_kPa and volume_<cavity>_mL (where there are several), of a motion kinetic_energy_mJ,\n"
        "stored_energy_mJ, load_work_mJ (done by the loads) and damping_work_mJ (taken by damping), stretch_p99 (largest principal\n"
        "stretch exceeded in 1 % of the rubber: converges under refinement), max_stretch (at a sharp corner it does not),\n"
        "min_J (least ratio of volumes), stable (1 or 0).\n"
        "--at takes what has a unit in the table, by its name without the unit: pressure, elongation, volume, bend=30deg. It\n"
        "gives one row for each crossing, in the order of the path; a value that the path does not reach is refused with\n"
        "exit code 65 and the range it does reach.\n"
        "The exit code is 0 also where the path ended early: solve has reported that.\n\n" +
        app.get_footer());
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));  // before any work
    return options;
}

post::Curve rows_at(const post::Curve& curve, const std::vector<std::string>& texts) {
    std::vector<post::Request> requests;
    for (const std::string& text : texts)
        for (const post::Request& request : post::parse_requests(text, curve)) requests.push_back(request);
    return post::rows_at(curve, requests);
}

std::vector<std::string> comments(const io::Result& result, const cli::CommonOptions& common) {
    std::vector<std::string> lines;
    for (const io::Provenance& stage : result.provenance) {
        lines.push_back(stage.tool + " " + stage.version + " (" + stage.revision + "): " + stage.command_line);
        lines.push_back("    " + core::join(stage.libraries));
    }
    lines.push_back("postprocess " + std::string{cli::version()} + " (" + std::string{cli::revision()} +
                    "): " + common.command_line);
    return lines;
}

ExitCode postprocess(const PostprocessOptions& options) {
    cli::Console console(about.tool, options.common.verbosity);
    cli::Input input = cli::read_input(options.input);
    const io::Result result = io::read_result(std::move(input.bytes), input.source);
    const post::Curve curve = post::make_curve(result.model, result.steps);
    const post::Curve table = options.at.empty() ? curve : rows_at(curve, options.at);
    const auto lines = options.comments ? comments(result, options.common) : std::vector<std::string>{};
    cli::write_output(options.common.output, post::csv_text(table, lines));
    if (!options.plot.empty())
        post::draw_plot(curve, result.end.value_or(solution::PathEnd{}), {result.model.name}, options.plot);
    const nlohmann::ordered_json json = postprocess_summary(result, curve, table.row_count());
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
    for (const std::string& line : summary_lines(json)) console.say(line);
    return ExitCode::ok;
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, soft::parse_options, soft::postprocess); }
