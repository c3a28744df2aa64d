/// postprocess: writes the curve (CSV), plots, pictures, ParaView files and a report of a result, and checks it.
///     postprocess bellows.h5 --at elongation=20mm,40mm,80mm,130mm
///     mesh-gen designs/bellows.yaml | solve | postprocess --plot curve.svg > curve.csv
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"
#include "geometry/build.hpp"
#include "io/result_file.hpp"
#include "post/csv.hpp"
#include "post/curve.hpp"
#include "post/cycles.hpp"
#include "post/request.hpp"
#include "post/sensitivity.hpp"
#include "postprocess_checks.hpp"
#include "postprocess_errors.hpp"
#include "postprocess_options.hpp"
#include "postprocess_plot.hpp"
#include "postprocess_summary.hpp"

namespace soft {
namespace {

post::Curve rows_at(const post::Curve& curve, const std::vector<std::string>& texts) {
    std::vector<post::Request> requests;
    for (const std::string& text : texts)
        for (const post::Request& request : post::parse_requests(text, curve)) requests.push_back(request);
    return post::rows_at(curve, requests);
}

std::vector<int> limit_rows(const io::Result& result) {
    std::vector<int> rows;
    if (result.end)
        for (const model::LimitPoint& point : result.end->limit_points) rows.push_back(point.step);
    return rows;
}

std::vector<std::string> comments(const io::Result& result, const cli::CommonOptions& common) {
    std::vector<std::string> lines;
    for (const io::Provenance& stage : result.provenance) {
        lines.push_back(stage.tool + " " + stage.version + " (" + stage.revision + "): " + stage.command_line);
        lines.push_back("    " + core::join(stage.libraries));
    }
    lines.push_back(cli::stamp(postprocess_about(), common));
    return lines;
}

ExitCode postprocess(const PostprocessOptions& options) {
    cli::Console console{postprocess_about(), options.common};
    if (options.lists_outputs && options.input.empty()) {
        cli::write_output(options.common.output, post::column_text(post::all_columns()));
        return ExitCode::ok;
    }
    cli::Input input = cli::read_hdf5_input(options.input);
    const core::Bytes image = copies_result(options.pictures) ? input.bytes : core::Bytes{};
    io::Result result = io::read_result(std::move(input.bytes), input.source, geometry::rebuild_case);
    nlohmann::ordered_json cycles = cycles_json(result);
    if (options.cycle > 0) {
        model::PathEnd end = result.end.value_or(model::PathEnd{});
        post::keep_cycle(result.model, options.cycle, result.steps, end);
        if (result.end) result.end = std::move(end);
    }
    post::Curve curve = post::make_curve(result.model, result.steps, result.end.value_or(model::PathEnd{}));
    if (options.lists_outputs) {
        cli::write_output(options.common.output, post::column_text(curve.columns));
        return ExitCode::ok;
    }
    if (options.sensitivity && result.model.parameters.empty())
        throw Error(ExitCode::usage, "--sensitivity", "the result has no sensitivities",
                    "generate its case with mesh-gen --sensitivity KEY[,KEY...], and solve it");
    if (!options.tolerances.empty() || !options.errors.empty()) {
        post::Deviations deviations = post::parse_tolerances(options.tolerances, result.model);
        if (!options.errors.empty()) deviations.add(fitted_deviations(options.errors, result.model));
        const std::string key = post::add_tolerance_band(curve, result.model, deviations);
        console.say("tolerances: at the last row " + key + " contributes most");
    }
    post::show_also(curve, options.also);
    const post::Curve table = options.at.empty() ? curve : rows_at(curve, options.at);
    const std::optional<Comparison> comparison = compare(options.compare, curve);
    nlohmann::ordered_json json = postprocess_summary(result, curve, table.row_count());
    if (!cycles.empty()) json["cycles"] = std::move(cycles);
    const CheckReport checks = run_checks(options, curve, comparison, json);
    const auto lines = options.comments ? comments(result, options.common) : std::vector<std::string>{};
    if (options.wants_table)
        cli::write_output(options.common.output,
                          comparison            ? post::csv_text(curve, comparison->measured, comparison->errors)
                          : options.sensitivity ? post::sensitivity_csv(table, result.model, limit_rows(result))
                                                : post::csv_text(table, lines));
    std::vector<post::PlotSeries> series = plot_series(options.plot, result, curve);
    if (options.sensitivity && !options.plot.file.empty())
        post::run_gnuplot(post::sensitivity_script(table, result.model, post::picture_format(options.plot.file)),
                          options.plot.file);
    else
        draw_plot(options.plot, series, comparison ? &comparison->measured : nullptr, result.model.name);
    make_pictures(
        options.pictures,
        {result, image, curve, table, options.at.empty() ? PictureInput::Rows::last : PictureInput::Rows::requested},
        console);
    write_report(options, {.result = result, .curve = curve, .series = series, .material_notes = material_notes(json)},
                 comparison);
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
    for (const std::string& line : summary_lines(json)) console.say(line);
    if (const auto advice = material_advice(json)) console.warn(*advice);
    for (const std::string& line : checks.lines) console.say(line);
    finish_checks(options, checks);
    return ExitCode::ok;
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) {
    return soft::cli::run_guarded(argc, argv, soft::parse_postprocess_options, soft::postprocess);
}
