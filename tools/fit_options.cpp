#include "fit_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.hpp"
#include "core/units.hpp"
#include "library_versions.hpp"
#include "post/plot.hpp"

namespace soft::cli {
namespace {

/// What the options say as text.
struct Words {
    std::string input, law = "yeoh", range, strain, stress, weights = "uniform", stability = "enforced", decimal,
                       delimiter;
    std::map<fit::Mode, std::vector<std::string>> files;
    std::vector<std::string> mode_weights;
    std::string weight_floor, gauge_length, area, width, thickness;
    bool offset = false, any_order = false;
};

std::vector<Library> libraries() { return {{"Ceres", built_with::ceres}}; }

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
    if (colon > 0) range.least = value(text.substr(0, colon));
    if (colon + 1 < text.size()) range.most = value(text.substr(colon + 1));
    if (range.most > fit::max_ratio && std::isfinite(range.most) && !text.ends_with('%'))
        throw Error(ExitCode::usage, "--range", core::quoted(text) + " looks like percentages, and holds plain ratios",
                    "write 0:110% or 0:1.1");
    if (!(range.least < range.most))
        throw Error(ExitCode::usage, "--range", "its end is not above its start", "for example --range 0:110%");
    return range;
}

std::optional<char> delimiter_of(const std::string& word) {
    static const std::map<std::string, char> names = {
        {"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}, {"bar", '|'}};
    if (word.empty()) return std::nullopt;
    if (const auto found = names.find(word); found != names.end()) return found->second;
    if (word.size() == 1) return word.front();
    throw Error(ExitCode::usage, "--delimiter", core::quoted(word) + " is not one character",
                "one character, or tab, comma, semicolon, blank, bar");
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
        throw Error(ExitCode::usage, "--weight", core::quoted(text) + " is no weight of a mode that is given",
                    "for example --weight planar=2, more than 0");
}

std::string row_count_error(const std::string& text) {
    const bool is_count =
        !text.empty() && text.size() < 10 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
    return is_count ? "" : core::quoted(text) + " is no number of rows; give 0 or more";
}

std::vector<TestFile> files_of(const Words& words) {
    std::vector<TestFile> files;
    if (!words.input.empty() || words.files.empty()) files.push_back({words.input, fit::Mode::uniaxial});
    for (const auto& [mode, names] : words.files)
        for (const std::string& name : names) files.push_back({name, mode});
    for (const std::string& weight : words.mode_weights) apply_weight(weight, files);
    if (std::ranges::count_if(files, [](const TestFile& file) { return file.name.empty() || file.name == "-"; }) > 1)
        throw Error(ExitCode::usage, "-", "stdin can be read once only", "name a file for the other tests");
    return files;
}

std::optional<double> size_of(const std::string& text, const char* option, core::Dimension dimension) {
    if (text.empty()) return std::nullopt;
    const double size = core::quantity_or_throw(text, dimension, ExitCode::usage, option);
    if (!(size > 0.0))
        throw Error(ExitCode::usage, option, core::quoted(text) + " is not positive",
                    "the size of the undeformed specimen");
    return size;
}

fit::Specimen specimen_of(const Words& words) {
    fit::Specimen specimen{size_of(words.gauge_length, "--gauge-length", core::Dimension::length),
                           size_of(words.area, "--area", core::Dimension::area)};
    const auto width_m = size_of(words.width, "--width", core::Dimension::length),
               thickness_m = size_of(words.thickness, "--thickness", core::Dimension::length);
    if (width_m.has_value() != thickness_m.has_value())
        throw Error(ExitCode::usage, width_m ? "--width" : "--thickness", "is one side of the section only",
                    "give --width and --thickness, or --area");
    if (width_m && specimen.area_m2)
        throw Error(ExitCode::usage, "--area", "the section is stated twice",
                    "give --width and --thickness, or --area");
    if (width_m) specimen.area_m2 = *width_m * *thickness_m;
    return specimen;
}

void apply(const Words& words, FitOptions& options) {
    options.files = files_of(words);
    options.candidate = fit::find_candidate(words.law);
    if (options.candidate == nullptr)
        throw Error(ExitCode::usage, "--law", "no law is called " + core::quoted(words.law),
                    core::did_you_mean(words.law, law_names()));
    options.reading.range = range_of(words.range);
    options.reading.specimen = specimen_of(words);
    options.reading.format.delimiter = delimiter_of(words.delimiter);
    if (words.decimal == "point") options.reading.format.decimal = table::Decimal::point;
    if (words.decimal == "comma") options.reading.format.decimal = table::Decimal::comma;
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
            throw Error(ExitCode::usage, "--weight-floor", "needs relative weights", "add --weights relative");
        if (!(options.settings.weight_floor > 0.0 && options.settings.weight_floor < 1.0))
            throw Error(ExitCode::usage, "--weight-floor", core::quoted(words.weight_floor) + " is not between 0 and 1",
                        "for example 1%");
    }
    if (words.stability == "everywhere") options.settings.stability = fit::Stability::everywhere;
    if (words.stability == "reported") options.settings.stability = fit::Stability::reported;
    if (words.offset) options.settings.offset = fit::Offset::fitted;
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));  // before any work
}

void add_data_options(CLI::App& app, Words& words, FitOptions& options) {
    add_input(app, words.input, "TEST", "Uniaxial test data (CSV)");
    for (const fit::Mode mode : {fit::Mode::uniaxial, fit::Mode::equibiaxial, fit::Mode::planar})
        app.add_option("--" + std::string{fit::name_of(mode)}, words.files[mode],
                       "Data of a test of this mode, fitted with the others (repeatable)")
            ->type_name("FILE")
            ->allow_extra_args(false)
            ->take_all();
    app.add_option("--weight", words.mode_weights, "Weight of the squared residuals of a mode (default 1; repeatable)")
        ->type_name("MODE=NUMBER")
        ->allow_extra_args(false)
        ->take_all();
    app.add_option("--strain-column", options.reading.strain_column, "Column by (part of) its title, or number from 1")
        ->type_name("TITLE");
    app.add_option("--stress-column", options.reading.stress_column, "Column by (part of) its title, or number from 1")
        ->type_name("TITLE");
    app.add_option("--strain", words.strain, "What the strain is, where the title does not say it")
        ->check(CLI::IsMember({"engineering", "true", "stretch"}));
    app.add_option("--stress", words.stress, "What the stress is, where the title does not say it")
        ->check(CLI::IsMember({"engineering", "true"}));
    app.add_option("--strain-unit", options.reading.strain_unit, "1 or %; of a displacement mm, in, ...")
        ->type_name("UNIT");
    app.add_option("--stress-unit", options.reading.stress_unit,
                   "Pa, kPa, MPa, N/mm^2, psi, ...; of a force N, lbf, ...")
        ->type_name("UNIT");
    app.add_option("--gauge-length", words.gauge_length,
                   "The strain's column is a displacement; strain = it / this length")
        ->type_name("LENGTH");
    app.add_option("--area", words.area, "The stress's column is a force; stress = it / this undeformed area")
        ->type_name("AREA");
    app.add_option("--width", words.width, "With --thickness, in place of --area")->type_name("LENGTH");
    app.add_option("--thickness", words.thickness, "With --width, in place of --area")->type_name("LENGTH");
    app.add_option("--delimiter", words.delimiter, "One character, or tab, comma, semicolon, blank, bar")
        ->type_name("C");
    app.add_option("--decimal", words.decimal, "How decimals are written, where both could be meant (1,234)")
        ->check(CLI::IsMember({"point", "comma"}));
    app.add_option("--skip-rows", options.reading.skipped_rows, "Leave out the first N rows of data")
        ->type_name("N")
        ->check(row_count_error);
    app.add_flag("--any-order", words.any_order, "The rows are points in no order, not a pull");
}

void add_fit_options(CLI::App& app, Words& words, FitOptions& options) {
    app.add_option("--law", words.law, "Law to fit (default yeoh): " + core::join(law_names()))->type_name("LAW");
    app.add_flag("--rank", options.rank, "Fit all laws and print a table, the best first, in place of a material");
    app.add_option("--range", words.range, "Engineering strains that take part, e.g. 0:110% or :3")
        ->type_name("FROM:TO");
    app.add_option("--weights", words.weights, "uniform, or relative: 1/max(s, floor times the largest s)")
        ->check(CLI::IsMember({"uniform", "relative"}));
    app.add_option("--weight-floor", words.weight_floor, "Floor of relative weights (default 5%)")->type_name("SHARE");
    app.add_flag("--offset", words.offset, "A constant stress of each test is unknown too, within +-10 kPa");
    app.add_option("--stability", words.stability,
                   "enforced: signs that make the law stable, where the free fit is not as far as the data reach; "
                   "everywhere: these signs in any case; reported: the free fit")
        ->check(CLI::IsMember({"enforced", "everywhere", "reported"}));
    app.add_option("--plot", options.plot, "Draw data, fits and residuals to FILE.svg, .png or .pdf; needs gnuplot")
        ->type_name("FILE");
    app.add_option("--notice", options.notice, "Source and licence of the data, a comment in the material")
        ->type_name("TEXT");
    app.add_option("--protocol", options.protocol, "How the test was made, kept in the material")->type_name("TEXT");
}

}  // namespace

const About& fit_about() {
    static const About about{
        .tool = "fit-material",
        .summary = "tensile, equibiaxial and planar test data (CSV) to the constants of a law (YAML)",
        .examples =
            {{"fit-material dragon-skin-20.csv --law yeoh --range 0:110% --plot fit.svg > material.yaml",
              "Yeoh's constants over 110 % of strain, and a picture"},
             {"fit-material machine.csv --gauge-length 33mm --width 6mm --thickness 3mm --law yeoh-5 > material.yaml",
              "From displacement and force as a testing machine writes them"},
             {"fit-material --uniaxial ut.csv --equibiaxial et.csv --planar ps.csv --rank",
              "All laws on three modes together, the best first"}},
        .libraries = libraries};
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
        "Stress and strain are found by the titles of their columns (engineering before true); the stress needs a unit, in\n"
        "its title or by --stress-unit. The fit is least squares of the nominal stress with equal weight of all rows.\n"
        "Flags: unstable:<mode>@<stretch> (Drucker, up to the largest I1 of the data), mu0<=0, at-bound, ill-conditioned,\n"
        "offset>10%, signs-constrained, terms:<n>. Errors of constants are a lower bound: residuals are correlated.\n\n" +
        app.get_footer());
    if (!parse(app, fit_about(), options.common, argc, argv)) return std::nullopt;
    std::erase_if(words.files, [](const auto& entry) { return entry.second.empty(); });
    apply(words, options);
    std::vector<NamedFile> inputs;
    for (const TestFile& file : options.files) inputs.push_back({"TEST.csv", file.name});
    check_distinct(inputs,
                   {{"--output", options.common.output}, {"--json", options.common.json}, {"--plot", options.plot}});
    return options;
}

}  // namespace soft::cli
