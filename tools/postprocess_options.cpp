#include "postprocess_options.hpp"

#include <CLI/CLI.hpp>

#include "core/text.hpp"
#include "library_versions.hpp"
#include "post/plot.hpp"
#include "report/report.hpp"

namespace soft {
namespace {

std::vector<cli::Library> libraries() { return {{"HDF5", cli::built_with::hdf5}}; }

/// One value each: CLI11 would let a list swallow the positional input.
CLI::Option* repeatable(CLI::Option* option) { return option->allow_extra_args(false)->take_all(); }

void add_plot_options(CLI::App& app, PlotOptions& plot) {
    app.add_option("--plot", plot.file, "Draw the curve to FILE.svg, FILE.png or FILE.pdf; needs gnuplot")
        ->type_name("FILE");
    app.add_option("--x", plot.x, "Quantity along the plot: a column of the table without its unit")
        ->type_name("QUANTITY");
    app.add_option("--y", plot.y, "Quantity up the plot")->type_name("QUANTITY");
    app.add_option("--colour", plot.colour, "Quantity shown by the colour of the curve, with a scale")
        ->type_name("QUANTITY");
    repeatable(
        app.add_option("--with", plot.with, "Another result in the same plot, also that of --report (repeatable)"))
        ->type_name("FILE[:LABEL]");
    app.add_option("--band", plot.band,
                   "In the plot: the band of the errors of the constants, a table by scripts/uncertainty")
        ->type_name("FILE.csv");
}

void add_compare_options(CLI::App& app, CompareOptions& compare) {
    app.add_option("--compare", compare.file,
                   "Compare with measured data: errors over the common range instead of the table; --plot shows both")
        ->type_name("FILE.csv");
    app.add_option("--columns", compare.columns,
                   "Where the measured quantities are, by number or name of the column, with the unit where the file "
                   "does not tell it: pressure=2:psi,elongation=1:mm")
        ->type_name("QUANTITY=COLUMN[:UNIT],...");
    app.add_option("--max-error", compare.max_error,
                   "Exit code 1 if the largest error is beyond this, e.g. 5kPa or 2mm")
        ->type_name("VALUE");
}

void add_check_options(CLI::App& app, CheckOptions& check) {
    app.add_option("--check", check.file, "Exit code 1 unless the path is that of this table, written by postprocess")
        ->type_name("GOLDEN.csv");
    app.add_option("--rtol", check.rtol, "Of --check: allowed difference relative to the golden value")
        ->type_name("RATIO")
        ->capture_default_str();
    repeatable(app.add_option("--atol", check.atol, "Of --check: and besides it, e.g. pressure=5Pa (repeatable)"))
        ->type_name("QUANTITY=VALUE");
    app.add_option("--junit", check.junit, "Of --check and --max-error: the verdict as JUnit XML")->type_name("FILE");
}

const std::string columns_help =
    "Columns (those a case does not have are left out): step, time_s, stage (1, 2 ..., where there are several), pressure_kPa\n"
    "(of the first load; traction_kPa, load_N or load_factor where nothing is under pressure), <output>_mm (_deg, _per_m, _N,\n"
    "_Nmm), volume_mL, pressure_<load>_kPa and volume_<cavity>_mL (where there are several), of a motion kinetic_energy_mJ,\n"
    "stored_energy_mJ, load_work_mJ (done by the loads) and damping_work_mJ (taken by damping), stretch_p99 (largest principal\n"
    "stretch exceeded in 1 % of the rubber: converges under refinement), max_stretch (at a sharp corner it does not),\n"
    "min_J (least ratio of volumes), stable (1 or 0). max_stretch and min_J are those of single integration points; colours\n"
    "and ParaView's nodes carry the linear part of each cell, which is nearer to the truth and does not show such peaks.\n"
    "With --also of a static path too stored_energy_mJ and load_work_mJ, and the undeformed place of max_stretch and the largest\n"
    "energy density; --plot --x and --y take them without it. --outputs lists all columns with their meaning.\n"
    "--at takes what has a unit in the table, by its name without the unit: pressure, elongation, volume, bend=30deg. It\n"
    "gives one row for each crossing, in the order of the path; a value that the path does not reach is refused with\n"
    "exit code 65 and the range it does reach.\n";

const std::string checks_help =
    "--check finds the place of each golden row on the smooth path (equal first output, cavity volume, time or load, whichever\n"
    "never turns back), so that other steps are a difference only as far as the curve between its rows is not known: some\n"
    "0.05 % with error-adaptive steps (solver.step_accuracy), more with others. Allowed is atol + rtol |golden|, |golden| no less\n"
    "than a thousandth of the column's largest; the column step is not compared.\n"
    "--compare knows the columns by their headers, 'Pressure (psi)' or elongation_mm, whatever stands between them; lines that\n"
    "start with # are comments. Errors are calculated minus measured: of the pressure at equal elongation, and the other way\n"
    "round. Points that the path does not reach are counted and left out.\n"
    "With --check, --report, --picture, --animate or --paraview the table is written only where -o says.\n";

/// Bad combinations are told before any work.
void check_combinations(const CLI::App& app) {
    const auto needs = [&](const char* option, std::initializer_list<const char*> any) {
        std::vector<std::string> names;
        for (const char* name : any) {
            if (app.count(name) > 0) return;
            names.emplace_back(name);
        }
        if (app.count(option) > 0)
            throw Error(ExitCode::usage, option, "says nothing without " + core::join(names, " or "));
    };
    for (const char* option : {"--with", "--x", "--y", "--colour", "--band"}) needs(option, {"--plot", "--report"});
    for (const char* option : {"--columns", "--max-error"}) needs(option, {"--compare"});
    for (const char* option : {"--rtol", "--atol"}) needs(option, {"--check"});
    needs("--junit", {"--check", "--max-error"});
    for (const char* option : {"--at", "--comments"})
        if (app.count(option) > 0 && app.count("--compare") > 0)
            throw Error(ExitCode::usage, option,
                        "says nothing with --compare, which writes errors in place of the table",
                        "leave out one of them");
}

/// No file twice, and those of the right kind.
void check_files(const PostprocessOptions& options) {
    std::vector<cli::NamedFile> inputs = {{"RESULT", options.input},
                                          {"--compare", options.compare.file},
                                          {"--check", options.check.file},
                                          {"--band", options.plot.band}};
    for (const std::string& other : options.plot.with) inputs.push_back({"--with", other.substr(0, other.rfind(':'))});
    const std::vector<cli::NamedFile> outputs = {{"--output", options.wants_table ? options.common.output : ""},
                                                 {"--json", options.common.json},
                                                 {"--plot", options.plot.file},
                                                 {"--picture", options.pictures.picture},
                                                 {"--animate", options.pictures.animate},
                                                 {"--paraview", options.pictures.paraview},
                                                 {"--report", options.report},
                                                 {"--junit", options.check.junit}};
    cli::check_distinct(inputs, outputs);
    if (!options.report.empty() && !options.report.ends_with(".html") && !options.report.ends_with(".htm"))
        throw Error(ExitCode::usage, "--report " + options.report, "a report is a .html file");
}

}  // namespace

const cli::About& postprocess_about() {
    static const cli::About about{.tool = "postprocess",
                                  .summary = "a result to look at: table, plots, pictures, comparison, report",
                                  .examples = {{"solve bellows-case.h5 | postprocess --plot curve.svg > curve.csv",
                                                "The whole curve as CSV, and a picture of it"},
                                               {"postprocess bellows.h5 --at pressure=10kPa,20kPa --at elongation=40mm",
                                                "The state at two pressures and at one elongation"}},
                                  .libraries = libraries};
    return about;
}

std::optional<PostprocessOptions> parse_postprocess_options(int argc, char** argv) {
    PostprocessOptions options;
    CLI::App app;
    const cli::About& about = postprocess_about();
    cli::add_input(app, options.input, "RESULT", "result written by solve");
    repeatable(app.add_option("--at", options.at,
                              "Only the states at these values, by cubic interpolation along the path (repeatable)"))
        ->type_name("QUANTITY=VALUE[,VALUE...]");
    app.add_option("--also", options.also, "Columns besides, by name, or all: --outputs lists them")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("QUANTITY[,QUANTITY...]");
    app.add_flag("--outputs", options.lists_outputs,
                 "List the columns of RESULT (- is stdin), or without one all there can be: name, unit, meaning");
    app.add_flag("--comments", options.comments, "Lines '# ...' before the header: how the result was made");
    add_plot_options(app, options.plot);
    add_compare_options(app, options.compare);
    add_check_options(app, options.check);
    add_picture_options(app, options.pictures);
    app.add_option("--report", options.report,
                   "One page for the browser: curve, moving body, table, design, provenance")
        ->type_name("FILE.html");
    cli::add_common_options(app, options.common, about);
    app.footer(columns_help + checks_help + pictures_help() +
               "The exit code is 0 also where the path ended early: solve has reported that.\n\n" + app.get_footer());
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    check_combinations(app);
    check_picture_options(app, options.pictures);
    options.wants_table = app.count("--output") > 0 || app.count("--check") + app.count("--report") +
                                                               app.count("--picture") + app.count("--animate") +
                                                               app.count("--paraview") ==
                                                           0;
    check_files(options);
    if (!options.plot.file.empty()) static_cast<void>(post::picture_format(options.plot.file));  // before any work
    if (!options.report.empty()) report::require_viewer();
    return options;
}

}  // namespace soft
