#include "postprocess_options.hpp"

#include <CLI/CLI.hpp>

#include "core/text.hpp"
#include "library_versions.hpp"
#include "post/plot.hpp"
#include "view/report.hpp"

namespace soft {
namespace {

/// One value per option: otherwise CLI11 would take the positional input as a further value.
CLI::Option* repeatable(CLI::Option* option) { return option->allow_extra_args(false)->take_all(); }

void add_plot_options(CLI::App& app, PlotOptions& plot) {
    app.add_option("--plot", plot.file, "Draw the curve to FILE.svg, FILE.png or FILE.pdf; needs gnuplot")
        ->type_name("FILE");
    app.add_option("--x", plot.x, "Quantity on the x axis: a column of the table without its unit")
        ->type_name("QUANTITY");
    app.add_option("--y", plot.y, "Quantity on the y axis")->type_name("QUANTITY");
    app.add_option("--colour", plot.colour, "Quantity shown by the colour of the curve, with a scale")
        ->type_name("QUANTITY");
    repeatable(app.add_option("--with", plot.with, "Another result in the same plot, also for --report (repeatable)"))
        ->type_name("FILE[:LABEL]");
}

void add_compare_options(CLI::App& app, CompareOptions& compare) {
    app.add_option("--compare", compare.file,
                   "Compare with measured data: errors over the common range instead of the table; --plot shows both")
        ->type_name("FILE.csv");
    app.add_option("--columns", compare.columns,
                   "Columns of the measured quantities, by number or name, with the unit if the file "
                   "does not state it: pressure=2:psi,elongation=1:mm")
        ->type_name("QUANTITY=COLUMN[:UNIT],...");
    app.add_option("--max-error", compare.max_error, "Exit code 1 if the largest error exceeds VALUE, e.g. 5kPa or 2mm")
        ->type_name("VALUE");
}

void add_check_options(CLI::App& app, CheckOptions& check) {
    app.add_option("--check", check.file, "Exit code 1 unless the path agrees with this table, written by postprocess")
        ->type_name("GOLDEN.csv");
    app.add_option("--rtol", check.rtol, "With --check: allowed difference relative to the golden value")
        ->type_name("RATIO")
        ->capture_default_str();
    repeatable(app.add_option("--atol", check.atol,
                              "With --check: additional absolute allowance, e.g. pressure=5Pa (repeatable)"))
        ->type_name("QUANTITY=VALUE");
    app.add_option("--junit", check.junit, "With --check or --max-error: write the outcome as JUnit XML")
        ->type_name("FILE");
}

const std::string columns_help =
    "Columns (only those that apply to the case): step, time_s, cycle and stage (1, 2 ..., if there are several), pressure_kPa (of\n"
    "the first load; traction_kPa, load_N or load_factor if no load is a pressure), <output>_mm (_deg, _per_m, _N, _Nmm), volume_mL,\n"
    "pressure_<load>_kPa and volume_<cavity>_mL (if there are several), for dynamics kinetic_energy_mJ, stored_energy_mJ,\n"
    "load_work_mJ (work of the loads) and damping_work_mJ (energy dissipated by damping), stretch_p99 (largest principal stretch\n"
    "exceeded in 1 % of the rubber: converges under refinement), max_stretch (does not converge at a sharp corner), min_J\n"
    "(smallest volume ratio), stable (1 or 0; not in motions). max_stretch and min_J are values of single integration points; pictures and\n"
    "ParaView's nodal fields use the linear part of each cell, which is more accurate and does not show such peaks.\n"
    "--also adds for static paths stored_energy_mJ and load_work_mJ, dissipated_energy_mJ (by inelastic rubber and snaps) and\n"
    "friction_work_mJ (dissipated by friction), and the undeformed positions of max_stretch and of the largest energy density;\n"
    "--plot --x and --y accept these without --also.\n"
    "--outputs lists all columns with their meaning.\n"
    "--at accepts every column with a unit, by its name without the unit: pressure, elongation, volume, bend=30deg. It prints\n"
    "one row per crossing, in the order of the path; for a value that the path does not reach, it prints the reached range and\n"
    "returns exit code 65.\n";

const std::string checks_help =
    "--check locates each golden row on the interpolated path (at equal first output, cavity volume, time or load, whichever is\n"
    "monotonic). Different step sizes therefore cause only interpolation differences: about 0.05 % with error-adaptive steps\n"
    "(solver.step_accuracy), more otherwise. The allowed difference is atol + rtol |golden|, with |golden| at least 0.001 times\n"
    "the column's maximum; the column step is not compared.\n"
    "--compare finds the columns by their headers, such as 'Pressure (psi)' or elongation_mm; other columns are ignored, and lines\n"
    "that start with # are comments. Errors are calculated minus measured: of the pressure at equal elongation, and of the\n"
    "elongation at equal pressure. Points that the path does not reach are counted and left out.\n"
    "With --check, --report, --picture, --animate or --paraview the table is written only with -o.\n";

/// Rejects invalid combinations before any work.
void check_combinations(const CLI::App& app) {
    const auto needs = [&](const char* option, std::initializer_list<const char*> any) {
        std::vector<std::string> names;
        for (const char* name : any) {
            if (app.count(name) > 0) return;
            names.emplace_back(name);
        }
        if (app.count(option) > 0)
            throw Error(ExitCode::usage, option, "has no effect without " + core::join(names, " or "));
    };
    for (const char* option : {"--with", "--x", "--y", "--colour"}) needs(option, {"--plot", "--report"});
    for (const char* option : {"--columns", "--max-error"}) needs(option, {"--compare"});
    for (const char* option : {"--rtol", "--atol"}) needs(option, {"--check"});
    needs("--junit", {"--check", "--max-error"});
    for (const char* option : {"--picture", "--animate", "--paraview", "--report"})
        if (app.count("--cycle") > 0 && app.count(option) > 0)
            throw Error(ExitCode::usage, "--cycle", "a part of the path has no pictures and no report",
                        "omit one of them");
    for (const char* option : {"--tolerances", "--errors"})
        if (app.count("--sensitivity") > 0 && app.count(option) > 0)
            throw Error(ExitCode::usage, option, "has no effect with --sensitivity", "omit one of them");
    for (const char* option : {"--at", "--comments", "--sensitivity", "--tolerances", "--errors"})
        if (app.count(option) > 0 && app.count("--compare") > 0)
            throw Error(ExitCode::usage, option,
                        "has no effect with --compare, which writes errors instead of the table", "omit one of them");
}

/// Rejects files that are named twice or have the wrong extension.
void check_files(const PostprocessOptions& options) {
    std::vector<cli::NamedFile> inputs = {{"RESULT", options.input},
                                          {"--compare", options.compare.file},
                                          {"--check", options.check.file},
                                          {"--errors", options.errors}};
    for (const std::string& other : options.plot.with) inputs.push_back({"--with", other.substr(0, other.rfind(':'))});
    cli::CommonOptions written = options.common;
    if (!options.wants_table) written.output.clear();
    cli::check_distinct(inputs, written,
                        {{"--plot", options.plot.file},
                         {"--picture", options.pictures.picture},
                         {"--animate", options.pictures.animate},
                         {"--paraview", options.pictures.paraview},
                         {"--report", options.report},
                         {"--junit", options.check.junit}});
    if (!options.report.empty() && !options.report.ends_with(".html") && !options.report.ends_with(".htm"))
        throw Error(ExitCode::usage, "--report " + options.report, "a report is an HTML file; use the extension .html");
}

}  // namespace

const cli::About& postprocess_about() {
    static const cli::About about{.tool = "postprocess",
                                  .summary = "evaluates a result: table, plots, pictures, comparison, report",
                                  .examples = {{"solve bellows-case.h5 | postprocess --plot curve.svg > curve.csv",
                                                "The whole curve as CSV, and a plot of it"},
                                               {"postprocess bellows.h5 --at pressure=10kPa,20kPa --at elongation=40mm",
                                                "The state at two pressures and at one elongation"}},
                                  .libraries =
                                      [] {
                                          return std::vector<cli::Library>{{"HDF5", cli::built_with::hdf5}};
                                      },
                                  .exit_codes = {{ExitCode::check_failed, "--check or --max-error failed"}}};
    return about;
}

std::optional<PostprocessOptions> parse_postprocess_options(int argc, char** argv) {
    PostprocessOptions options;
    CLI::App app;
    const cli::About& about = postprocess_about();
    cli::add_input(app, options.input, "RESULT", "Result written by solve");
    repeatable(
        app.add_option("--at", options.at,
                       "Print only the states at these values, by cubic interpolation along the path (repeatable)"))
        ->type_name("QUANTITY=VALUE[,VALUE...]");
    app.add_option("--also", options.also, "Additional columns, by name, or all: --outputs lists them")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("QUANTITY[,QUANTITY...]");
    app.add_option("--cycle", options.cycle,
                   "Only this cycle of a programme with path.repeat, from the state in which it starts")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    app.add_flag(
        "--sensitivity", options.sensitivity,
        "Print the derivatives of the curve by the numbers of the design that mesh-gen --sensitivity named: of the load at "
        "a fixed first output, and of the output at a fixed load; --plot draws the relative ones at the last row as bars");
    app.add_option(
           "--tolerances", options.tolerances,
           "Add the band of the load that these tolerances cause (columns band_rss and band_worst); --plot draws it")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("KEY=VALUE[,KEY=VALUE...]");
    app.add_option(
           "--errors", options.errors,
           "Add the band that the errors of fitted constants cause, with their correlations: the --json file of "
           "fit-material or optimize")
        ->type_name("FIT.json");
    app.add_flag("--outputs", options.lists_outputs,
                 "List the columns of RESULT (-: stdin), or without RESULT all possible columns: name, unit, meaning");
    app.add_flag("--comments", options.comments,
                 "Print the provenance of the result in lines '# ...' before the header");
    add_plot_options(app, options.plot);
    add_compare_options(app, options.compare);
    add_check_options(app, options.check);
    add_picture_options(app, options.pictures);
    app.add_option("--report", options.report,
                   "Write a report for the browser: curve, animated actuator, table, design, provenance")
        ->type_name("FILE.html");
    cli::add_common_options(app, options.common, about);
    app.footer(columns_help + checks_help + pictures_help() +
               "The exit code is 0 even if the path ended early; solve reports that.\n\n" + app.get_footer());
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    check_combinations(app);
    check_picture_options(app, options.pictures);
    options.wants_table = app.count("--output") > 0 || app.count("--check") + app.count("--report") +
                                                               app.count("--picture") + app.count("--animate") +
                                                               app.count("--paraview") ==
                                                           0;
    check_files(options);
    if (!options.plot.file.empty()) static_cast<void>(post::picture_format(options.plot.file));  // before any work
    if (!options.report.empty()) view::require_viewer();
    return options;
}

}  // namespace soft
