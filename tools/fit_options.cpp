#include "fit_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.hpp"
#include "core/units.hpp"
#include "fit_elastic.hpp"
#include "library_versions.hpp"
#include "post/plot.hpp"

namespace soft::cli {
namespace {

/// Option values as text, before conversion.
struct Words {
    std::string input, law, range, strain, stress, weights = "uniform", stability = "enforced", decimal, delimiter;
    std::map<fit::Mode, std::vector<std::string>> files;
    std::vector<std::string> mode_weights;
    std::string weight_floor, gauge_length, area, width, thickness;
    std::string elastic;
    bool offset = false, any_order = false;
};

std::vector<std::string> law_names() {
    std::vector<std::string> names;
    for (const fit::Candidate& candidate : fit::candidates()) names.emplace_back(candidate.name);
    return names;
}

fit::StrainRange range_of(const std::string& text) {
    fit::StrainRange range;
    if (text.empty()) return range;
    const auto colon = text.find(':');
    const auto value = [](const std::string& word) {
        return core::quantity_or_throw(word, core::Dimension::ratio, ExitCode::usage, "--range");
    };
    if (colon == std::string::npos)
        throw Error(ExitCode::usage, "--range", core::quoted(text) + " has no colon", "for example --range 0:110%");
    if (colon > 0) range.min = value(text.substr(0, colon));
    if (colon + 1 < text.size()) range.max = value(text.substr(colon + 1));
    if (range.max > fit::max_ratio && std::isfinite(range.max) && !text.ends_with('%'))
        throw Error(ExitCode::usage, "--range", core::quoted(text) + " looks like percentages without a % sign",
                    "write 0:110% or 0:1.1");
    if (!(range.min < range.max))
        throw Error(ExitCode::usage, "--range", "the end is not above the start", "for example --range 0:110%");
    return range;
}

std::optional<char> delimiter_of(const std::string& word) {
    static const std::map<std::string, char> names = {
        {"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}, {"bar", '|'}};
    if (word.empty()) return std::nullopt;
    if (const auto found = names.find(word); found != names.end()) return found->second;
    if (word.size() == 1) return word.front();
    throw Error(ExitCode::usage, "--delimiter", core::quoted(word) + " is not one character",
                "use one character, or tab, comma, semicolon, blank, bar");
}

/// "planar=2"
void apply_weight(const std::string& text, std::vector<TestFile>& files) {
    const auto equals = text.find('=');
    const std::string mode = text.substr(0, equals);
    double weight = -1;
    if (equals != std::string::npos)
        weight = core::quantity_or_throw(text.substr(equals + 1), core::Dimension::ratio, ExitCode::usage, "--weight");
    bool found = false;
    for (TestFile& file : files)
        if (fit::name_of(file.mode) == mode) file.weight = weight, found = true;
    if (!found || !(weight > 0.0))
        throw Error(ExitCode::usage, "--weight", core::quoted(text) + " is not a positive weight of a given mode",
                    "for example --weight planar=2");
}

std::string row_count_error(const std::string& text) {
    const bool is_count =
        !text.empty() && text.size() < 10 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
    return is_count ? "" : core::quoted(text) + " is not a number of rows; give 0 or more";
}

std::vector<TestFile> files_of(const Words& words) {
    std::vector<TestFile> files;
    if (!words.input.empty() || words.files.empty()) files.push_back({words.input, fit::Mode::uniaxial});
    for (const auto& [mode, names] : words.files)
        for (const std::string& name : names) files.push_back({name, mode});
    for (const std::string& weight : words.mode_weights) apply_weight(weight, files);
    if (std::ranges::count_if(files, [](const TestFile& file) { return file.name.empty() || file.name == "-"; }) > 1)
        throw Error(ExitCode::usage, "-", "stdin can be read only once", "give files for the other tests");
    return files;
}

std::optional<double> size_of(const std::string& text, const char* option, core::Dimension dimension) {
    if (text.empty()) return std::nullopt;
    const double size = core::quantity_or_throw(text, dimension, ExitCode::usage, option);
    if (!(size > 0.0))
        throw Error(ExitCode::usage, option, core::quoted(text) + " is not positive",
                    "give the size of the undeformed specimen");
    return size;
}

fit::Specimen specimen_of(const Words& words) {
    fit::Specimen specimen{size_of(words.gauge_length, "--gauge-length", core::Dimension::length),
                           size_of(words.area, "--area", core::Dimension::area)};
    const auto width_m = size_of(words.width, "--width", core::Dimension::length),
               thickness_m = size_of(words.thickness, "--thickness", core::Dimension::length);
    if (width_m.has_value() != thickness_m.has_value())
        throw Error(ExitCode::usage, width_m ? "--width" : "--thickness", "defines only one side of the cross-section",
                    "give --width and --thickness, or --area");
    if (width_m && specimen.area_m2)
        throw Error(ExitCode::usage, "--area", "the cross-section is given twice",
                    "give --width and --thickness, or --area");
    if (width_m) specimen.area_m2 = *width_m * *thickness_m;
    return specimen;
}

void apply(const Words& words, FitOptions& options) {
    options.files = files_of(words);
    options.candidate = fit::find_candidate(words.law.empty() ? "yeoh" : words.law);
    if (options.candidate == nullptr)
        throw Error(ExitCode::usage, "--law", "no law is called " + core::quoted(words.law),
                    core::did_you_mean(words.law, law_names()));
    options.reading.range = range_of(words.range);
    options.reading.specimen = specimen_of(words);
    options.reading.format.delimiter = delimiter_of(words.delimiter);
    if (words.decimal == "point") options.reading.format.decimal = core::Decimal::point;
    if (words.decimal == "comma") options.reading.format.decimal = core::Decimal::comma;
    if (words.any_order) options.reading.order = fit::RowOrder::points;
    if (words.strain == "engineering") options.reading.strain_measure = fit::StrainMeasure::engineering;
    if (words.strain == "true") options.reading.strain_measure = fit::StrainMeasure::logarithmic;
    if (words.strain == "stretch") options.reading.strain_measure = fit::StrainMeasure::stretch;
    if (words.stress == "engineering") options.reading.stress_measure = fit::StressMeasure::engineering;
    if (words.stress == "true") options.reading.stress_measure = fit::StressMeasure::cauchy;
    if (words.weights == "relative") options.settings.weights = fit::RowWeights::relative;
    if (!words.weight_floor.empty()) {
        options.settings.weight_floor =
            core::quantity_or_throw(words.weight_floor, core::Dimension::ratio, ExitCode::usage, "--weight-floor");
        if (options.settings.weights != fit::RowWeights::relative)
            throw Error(ExitCode::usage, "--weight-floor", "requires relative weights", "add --weights relative");
        if (!(options.settings.weight_floor > 0.0 && options.settings.weight_floor < 1.0))
            throw Error(ExitCode::usage, "--weight-floor", core::quoted(words.weight_floor) + " is not between 0 and 1",
                        "for example 1%");
    }
    if (words.stability == "everywhere") options.settings.stability = fit::Stability::everywhere;
    if (words.stability == "reported") options.settings.stability = fit::Stability::reported;
    if (words.offset) options.settings.offset = fit::Offset::fitted;
    if (!words.elastic.empty()) {
        if (!options.in_time())
            throw Error(ExitCode::usage, "--elastic", "has no effect without --viscoelastic or --softening", "omit it");
        if (options.rank) throw Error(ExitCode::usage, "--rank", "has no effect with --elastic", "omit one of them");
        if (!words.law.empty()) throw Error(ExitCode::usage, "--law", "is stated by --elastic too", "omit one of them");
        options.history.elastic = elastic_law(words.elastic);
    }
    options.reading.wants_time = options.in_time();
    if (options.in_time()) {
        options.reading.order = fit::RowOrder::points;  // the elastic fit, the start of the search, takes them so
        if (words.offset)
            throw Error(ExitCode::usage, "--offset", "tests in time are fitted without an offset", "omit it");
    } else if (!options.reading.time_column.empty() || !options.reading.time_unit.empty()) {
        throw Error(ExitCode::usage, options.reading.time_column.empty() ? "--time-unit" : "--time-column",
                    "has no effect without --viscoelastic or --softening");
    }
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));  // before any work
}

void add_data_options(CLI::App& app, Words& words, FitOptions& options) {
    add_input(app, words.input, "TEST", "Uniaxial test data (CSV)");
    for (const fit::Mode mode : {fit::Mode::uniaxial, fit::Mode::equibiaxial, fit::Mode::planar})
        app.add_option("--" + std::string{fit::name_of(mode)}, words.files[mode],
                       "Test data in " + std::string{fit::name_of(mode)} +
                           " tension; all tests are fitted together (repeatable)")
            ->type_name("FILE")
            ->allow_extra_args(false)
            ->take_all();
    app.add_option("--weight", words.mode_weights, "Weight of the squared residuals of a mode (default 1; repeatable)")
        ->type_name("MODE=NUMBER")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--strain-column", options.reading.strain_column,
                   "Strain column: (part of) its title, or its number from 1")
        ->type_name("TITLE");
    app.add_option("--stress-column", options.reading.stress_column,
                   "Stress column: (part of) its title, or its number from 1")
        ->type_name("TITLE");
    app.add_option("--strain", words.strain, "Strain measure, if the column title does not state it")
        ->check(CLI::IsMember({"engineering", "true", "stretch"}));
    app.add_option("--stress", words.stress, "Stress measure, if the column title does not state it")
        ->check(CLI::IsMember({"engineering", "true"}));
    app.add_option("--strain-unit", options.reading.strain_unit,
                   "Unit of the strain column, if its title does not state it: 1 or %; for a displacement mm, in, ...")
        ->type_name("UNIT");
    app.add_option(
           "--stress-unit", options.reading.stress_unit,
           "Unit of the stress column, if its title does not state it: Pa, kPa, MPa, N/mm^2, psi, ...; for a force N, lbf, ...")
        ->type_name("UNIT");
    app.add_option("--gauge-length", words.gauge_length,
                   "The strain column is a displacement; strain = displacement / LENGTH")
        ->type_name("LENGTH");
    app.add_option("--area", words.area, "The stress column is a force; stress = force / AREA (undeformed)")
        ->type_name("AREA");
    app.add_option("--width", words.width, "With --thickness: replaces --area")->type_name("LENGTH");
    app.add_option("--thickness", words.thickness, "With --width: replaces --area")->type_name("LENGTH");
    app.add_option("--delimiter", words.delimiter,
                   "Column delimiter: one character, or tab, comma, semicolon, blank, bar")
        ->type_name("C");
    app.add_option("--decimal", words.decimal, "Decimal sign, if the file is ambiguous (1,234)")
        ->check(CLI::IsMember({"point", "comma"}));
    app.add_option("--skip-rows", options.reading.skipped_rows, "Skip the first N rows of data")
        ->type_name("N")
        ->check(row_count_error);
    app.add_option("--time-column", options.reading.time_column,
                   "With --viscoelastic or --softening: time column, by (part of) its title or its number from 1")
        ->type_name("TITLE");
    app.add_option("--time-unit", options.reading.time_unit,
                   "Unit of the time column, if its title does not state it (default s)")
        ->type_name("UNIT");
    app.add_flag("--any-order", words.any_order, "The rows are unordered points, not a loading sequence");
}

void add_fit_options(CLI::App& app, Words& words, FitOptions& options) {
    app.add_option("--law", words.law, "Law to fit (default yeoh): " + core::join(law_names()))->type_name("LAW");
    app.add_option(
           "--viscoelastic", options.history.branches,
           "Fit N Maxwell elements with the law, to tests with a time column: relaxation, creep, cycles, ramps at several "
           "rates")
        ->check(CLI::Range(1, 8))
        ->type_name("N");
    app.add_flag("--softening", options.history.softening,
                 "Fit Ogden-Roxburgh softening with the law, to tests with cycles and a time column");
    app.add_option(
           "--elastic", words.elastic,
           "With --viscoelastic or --softening: keep the constants of this law, a material file or a silicone of "
           "the library, and fit the others")
        ->type_name("MATERIAL");
    app.add_flag("--rank", options.rank, "Fit all laws and print a table, best first, instead of a material");
    app.add_option("--range", words.range, "Range of engineering strain to fit, e.g. 0:110% or :3")
        ->type_name("FROM:TO");
    app.add_option("--weights", words.weights,
                   "Weights of the rows: uniform, or relative: 1/max(s, floor * largest s), where s is the stress")
        ->check(CLI::IsMember({"uniform", "relative"}));
    app.add_option("--weight-floor", words.weight_floor, "Floor of relative weights (default 5%)")->type_name("SHARE");
    app.add_flag("--offset", words.offset, "Also fit a constant stress offset per test, within +-10 kPa");
    app.add_option("--stability", words.stability,
                   "enforced: constrain the signs of the constants if the free fit is unstable within the data; "
                   "everywhere: always constrain them; reported: free fit, only report instability")
        ->check(CLI::IsMember({"enforced", "everywhere", "reported"}));
    app.add_option("--plot", options.plot, "Draw data, fits and residuals to FILE.svg, .png or .pdf; needs gnuplot")
        ->type_name("FILE");
    app.add_option("--notice", options.notice, "Source and licence of the data, written as a comment in the material")
        ->type_name("TEXT");
    app.add_option("--protocol", options.protocol, "How the test was performed, stored in the material")
        ->type_name("TEXT");
}

}  // namespace

const About& fit_about() {
    static const About about{
        .tool = "fit-material",
        .summary = "fits the constants of a material law (YAML) to tensile, equibiaxial and planar test data (CSV)",
        .examples =
            {{"fit-material dragon-skin-20.csv --law yeoh --range 0:110% --plot fit.svg > material.yaml",
              "Yeoh constants up to 110 % strain, and a plot"},
             {"fit-material machine.csv --gauge-length 33mm --width 6mm --thickness 3mm --law yeoh-5 > material.yaml",
              "Displacement and force data of a testing machine"},
             {"fit-material relaxation.csv --uniaxial cycles.csv --viscoelastic 2 --softening > material.yaml",
              "A law with relaxation and softening, from two tests with a time column"},
             {"fit-material --uniaxial ut.csv --equibiaxial et.csv --planar ps.csv --rank",
              "Fits all laws to three modes together, best first"}},
        .libraries = [] {
            return std::vector<Library>{{"Ceres", built_with::ceres}};
        }};
    return about;
}

std::optional<FitOptions> parse_fit_options(int argc, char** argv) {
    FitOptions options;
    Words words;
    CLI::App app;
    add_data_options(app, words, options);
    add_fit_options(app, words, options);
    add_common_options(app, options.common, fit_about());
    app.footer(
        "Stress and strain columns are found by their titles (engineering before true); the stress needs a unit, in its\n"
        "title or by --stress-unit. The fit is a least-squares fit of the nominal stress; by default all\n"
        "rows have equal weight.\n"
        "Flags of the --rank table: unstable:<mode>@<stretch> (Drucker, up to the largest I1 of the data), mu0<=0, at-bound, ill-conditioned,\n"
        "offset>10%, signs-constrained, terms:<n>. The standard errors of the constants are lower bounds,\n"
        "because the residuals are correlated.\n\n" +
        app.get_footer());
    if (!parse(app, fit_about(), options.common, argc, argv)) return std::nullopt;
    std::erase_if(words.files, [](const auto& entry) { return entry.second.empty(); });
    apply(words, options);
    std::vector<NamedFile> inputs;
    for (const TestFile& file : options.files) inputs.push_back({"TEST.csv", file.name});
    check_distinct(inputs, options.common, {{"--plot", options.plot}});
    return options;
}

}  // namespace soft::cli
