#include "view/sections.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "model/location.hpp"
#include "post/csv.hpp"
#include "post/gnuplot.hpp"
#include "view/text.hpp"
#include "view/viewer_bundle.hpp"

namespace soft::view {
namespace {

std::string paragraph(const std::string& text) { return "<p>" + escaped(text) + "</p>\n"; }

/// The values at a limit point, bifurcation or first contact: "pressure 44.3 kPa, elongation 20 mm".
std::string location_text(const post::Curve& curve, const model::LimitPoint& point) {
    std::vector<std::string> words;
    for (const post::Column& column : curve.columns)
        if (const auto value = post::value_at(column, point))
            words.push_back(column.quantity + " " + post::value_text(column, *value, 4));
    return core::join(words);
}

/// The range of each coordinate: "pressure 0 to 24.7 kPa".
std::string coordinate_range_text(const post::Curve& curve) {
    std::vector<std::string> words;
    for (const post::Column& column : curve.columns) {
        if (column.role != post::Role::coordinate || column.values.empty()) continue;
        const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
        words.push_back(column.quantity + " " + core::rounded_text(*low, 4) + " to " +
                        post::value_text(column, *high, 4));
    }
    return core::join(words);
}

}  // namespace

std::string html_table(std::span<const std::string> head, std::span<const Row> rows, std::string_view id) {
    std::string html = id.empty() ? "<table>" : "<table id='" + std::string{id} + "'>";
    html += "<thead><tr>";
    for (const std::string& cell : head) html += "<th>" + escaped(cell) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const Row& row : rows) {
        html += row.attributes.empty() ? "<tr>" : "<tr " + row.attributes + ">";
        for (const std::string& cell : row.cells) html += "<td>" + escaped(cell) + "</td>";
        html += "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string summary_section(const Content& content) {
    const io::Result& result = content.result;
    const auto& end = result.end;
    std::string html = paragraph(std::to_string(result.steps.size()) +
                                 " converged steps: " + coordinate_range_text(content.curve) + ".");
    if (!end) return html + paragraph("The path is not finished: solve was stopped or is still running.");
    html += paragraph("The path ended: " + std::string{model::name(end->reason)} +
                      (end->detail.empty() ? "" : " (" + end->detail + ")") + ".");
    for (const model::LimitPoint& point : end->limit_points)
        html += paragraph("Limit point: " + location_text(content.curve, point) + ".");
    for (const model::Bifurcation& branch : end->bifurcations)
        html += paragraph("Bifurcation: " + location_text(content.curve, branch.at) + ".");
    for (const model::FirstContact& contact : end->first_contacts)
        html += paragraph("First contact: " + location_text(content.curve, contact.at) + ": " +
                          model::contact_text(result.model, contact) + ".");
    return html;
}

std::string curve_section(const Content& content) {
    const std::string script =
        post::plot_script(content.series, content.measured, content.plot, post::PictureFormat::svg);
    const std::string svg = post::gnuplot_output(script, "--report");
    // Embedded as an image, so that no script or style in a label can affect the page.
    return "<h2>Curve</h2>\n<img id='curve' alt='" + escaped(content.result.model.name) +
           "' src='data:image/svg+xml;base64," + base64(svg) + "'>\n";
}

std::string body_section(const Scene& scene) {
    if (scene.json.empty())
        return "<h2>Actuator</h2>\n" +
               paragraph("This result contains no fields; run solve with --fields all to store them.");
    const std::string left_out =
        scene.frames == scene.stored
            ? ""
            : paragraph(std::to_string(scene.frames) + " of " + std::to_string(scene.stored) +
                        " stored steps are shown to keep this page small enough for a browser.");
    return R"(<h2>Actuator</h2>
<p>Drag to rotate, scroll to zoom, drag with the right button to pan.</p>
<canvas id='body' aria-label='the deformed actuator'></canvas>
<p id='viewer-error' hidden></p>
<div class='controls'>
<label class='wide'>Step <input id='frame' type='range' min='0' step='1' value='0'></label>
<button id='play' type='button'>Play</button> <button id='reset' type='button'>Reset view</button>
<label>Colour <select id='field'></select></label>
<label><input id='outline' type='checkbox' checked> undeformed outline</label>
<label hidden><input id='cut' type='checkbox'> cut open</label>
</div>
<p><strong id='step'></strong><br><span id='size'></span></p>
<div class='colourbar'><span id='low'></span><div id='colours'></div><span id='high'></span></div>
<p id='meaning'></p>
)" + left_out +
           "<script type='application/json' id='scene'>" + scene.json + "</script>\n";
}

std::string comparison_section(const Content& content) {
    if (content.measured == nullptr) return {};
    const std::vector<std::string> head = {"error of",  "at equal", "points",  "beyond the path", "mean",
                                           "mean size", "RMS",      "largest", "largest at",      "R2"};
    std::vector<Row> rows;
    for (const post::ErrorSummary& error : content.errors) {
        const post::Column& of = content.curve.columns[error.of];
        const post::Column& at = content.curve.columns[error.at];
        rows.push_back({{of.quantity, at.quantity, std::to_string(error.points), std::to_string(error.left_out),
                         post::value_text(of, error.mean, 3), post::value_text(of, error.mean_absolute, 3),
                         post::value_text(of, error.rms, 3), post::value_text(of, error.largest, 3),
                         post::value_text(at, content.measured->find(error.at)->values[error.max_row], 4),
                         error.r2 ? core::rounded_text(*error.r2, 4) : ""}});
    }
    return "<h2>Comparison with measured data</h2>\n" +
           paragraph(
               content.measured->source +
               "; errors are computed minus measured values at the measured points within the range of the path.") +
           html_table(head, rows);
}

std::string table_section(const Content& content) {
    std::vector<std::string> head;
    const std::vector<const post::Column*> shown = post::shown_columns(content.curve);
    for (const post::Column* column : shown) head.push_back(column->name);
    std::vector<Row> rows;
    for (std::size_t row = 0; row < content.curve.row_count(); ++row) {
        Row& line = rows.emplace_back(Row{{}, "data-step='" + std::to_string(row) + "'"});
        for (const post::Column* column : shown) line.cells.push_back(core::rounded_text(column->values[row], 6));
    }
    return "<h2>Results</h2>\n<p><a download='curve.csv' href='data:text/csv;base64," +
           base64(post::csv_text(content.curve)) +
           "'>Download the table as CSV with all digits</a></p>\n<div class='scroll'>" +
           html_table(head, rows, "results") + "</div>\n";
}

std::string design_section(const Content& content) {
    const io::DesignText& design =
        content.result.changed_design ? *content.result.changed_design : content.result.design;
    std::string html = "<h2>Design</h2>\n";
    if (!design.overrides.empty())
        html += paragraph("Changed on the command line: " + core::join(design.overrides) + ".");
    return html + "<details open><summary>With defaults and overrides applied</summary>\n<pre>" +
           escaped(design.effective_yaml) + "</pre></details>\n";
}

std::string provenance_section(const Content& content) {
    std::vector<Row> rows;
    for (const io::Provenance& stage : content.result.provenance)
        rows.push_back(
            {{stage.tool + " " + stage.version, stage.revision, stage.command_line, core::join(stage.libraries)}});
    const std::vector<std::string> head = {"program", "revision", "command", "libraries"};
    return "<h2>Provenance</h2>\n" + html_table(head, rows) + paragraph("This page: " + content.made_by);
}

std::string licence_section() {
    const ViewerBundle bundle = viewer_bundle();
    return "<h2>Licences</h2>\n<details><summary>" + escaped(bundle.library) +
           ", used for the 3D view</summary>\n<pre>" + escaped(joined(bundle.licence)) + "</pre></details>\n" +
           paragraph("Colours: viridis by S. van der Walt and N. Smith, public domain (CC0).");
}

}  // namespace soft::view
