#include "view/sweep_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/text.hpp"
#include "view/page.hpp"
#include "view/palette.hpp"
#include "view/sweep_script.hpp"
#include "view/text.hpp"

namespace soft::view {
namespace {

using Json = nlohmann::json;

constexpr std::string_view sweep_style = R"(
:root { color-scheme: light; }
body { font: 16px/1.45 system-ui, sans-serif; color: #1a1a1a; background: #fff; max-width: 96rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin: 0 0 .4rem; } section { margin-top: 1.8rem; min-width: 0; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(28rem, 1fr)); gap: 0 2rem; }
.chart { position: relative; height: 27rem; } #parallel, #parallel-over { height: 24rem; } .wide .chart { height: 24rem; }
.chart canvas { position: absolute; inset: 0; width: 100%; height: 100%; } canvas:focus-visible { outline: 2px solid #0072B2; }
.chart canvas + canvas { touch-action: none; cursor: crosshair; }
.controls, #axes, #intervals, #legend { display: flex; flex-wrap: wrap; gap: .4rem 1rem; align-items: center; margin: .5rem 0; }
label { white-space: nowrap; } select { max-width: 22rem; font: inherit; } input[type=number] { width: 7rem; }
fieldset { border: 1px solid #ccc; padding: .1rem .6rem .3rem; } legend { font-size: .85rem; }
.swatch { width: 1rem; height: 1rem; margin-right: -.6rem; } .bar { width: 10rem; height: 1rem; border: 1px solid #999; }
#status { font-weight: 600; } .note, .hint { color: #555; font-size: .9rem; margin: .2rem 0; }
#tip { position: fixed; z-index: 2; background: #fff; border: 1px solid #777; padding: .3rem .6rem; white-space: pre-wrap; font-size: .85rem;
       pointer-events: none; max-width: 30rem; overflow-wrap: anywhere; }
.scroll { overflow: auto; max-height: 32rem; } table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .8rem .15rem 0; text-align: left; vertical-align: top; } thead th { background: #fff; position: sticky; top: 0; }
th button { font: inherit; border: 0; background: none; padding: 0; text-align: left; cursor: pointer; text-decoration: underline dotted; }
tbody tr { border-bottom: 1px solid #eee; cursor: pointer; } tr.hovered { background: #e6f0fa; } tr.picked td:first-child { font-weight: 700; }
pre { background: #f6f6f6; padding: .8rem; overflow-x: auto; white-space: pre-wrap; } [hidden] { display: none !important; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
)";

constexpr std::string_view charts = R"(
<p id='status' role='status'></p>
<div class='controls'><label>Colour <select id='colour'></select></label><span id='legend'></span>
<button id='clear' type='button'>Clear selection (Escape)</button></div>
<div class='pair'>
<section><h2>Scatter plot</h2>
<div class='controls'><label>x <select id='x'></select></label><label>y <select id='y'></select></label></div>
<div class='controls'><label><input id='front' type='checkbox'> Pareto front</label>
<label>x: <select id='x-goal'><option value='-1'>smaller is better</option><option value='1'>larger is better</option></select></label>
<label>y: <select id='y-goal'><option value='-1'>smaller is better</option><option value='1'>larger is better</option></select></label></div>
<div class='chart'><canvas id='scatter'></canvas><canvas id='scatter-over' tabindex='0' role='img'
 aria-label='Scatter plot of the designs; arrow keys go from design to design, Enter selects one'></canvas></div>
<p class='hint'>Drag a rectangle to select designs, click a design to add it. A cross is a design that ended early or failed.</p></section>
<section><h2>Curves</h2>
<div class='controls'><label>x <select id='curve-x'></select></label><label>y <select id='curve-y'></select></label></div>
<div class='controls note' id='curve-note'></div>
<div class='chart'><canvas id='curves'></canvas><canvas id='curves-over' tabindex='0' role='img'
 aria-label='Curves of the selected designs; arrow keys go from design to design, Enter selects one'></canvas></div>
<p class='hint'>Selected designs in colour, the others grey.</p></section>
</div>
<section class='wide'><h2>Parallel coordinates</h2>
<div class='chart'><canvas id='parallel'></canvas><canvas id='parallel-over' tabindex='0' role='img'
 aria-label='Parallel coordinates; the fields below set the same intervals'></canvas></div>
<p class='hint'>Drag along an axis to set an interval, on several axes to combine them; click an axis to clear its interval. Dashed: ended early or
failed.</p>
<details><summary>Intervals as numbers</summary><div id='intervals'></div></details>
<details><summary>Axes</summary><div id='axes'></div></details></section>
<section><h2>Selected designs</h2><p class='note' id='rows-note'></p>
<div class='scroll' tabindex='0'><table><thead><tr id='selected-head'></tr></thead><tbody id='selected-rows'></tbody></table></div></section>
<section id='early-section'><h2>Designs that failed or ended early</h2><p class='note' id='early-note'></p>
<div class='scroll' tabindex='0'><table><thead><tr id='early-head'></tr></thead><tbody id='early-rows'></tbody></table></div></section>
<div id='tip' hidden></div><p id='focused' class='unseen' aria-live='polite'></p>
)";

/// Numbers as JSON; null for a missing value.
template <class Text>
std::string number_list(std::span<const double> values, Text text_of_number) {
    std::string text = "[";
    for (const double value : values) {
        if (text.size() > 1) text += ',';
        text += std::isfinite(value) ? text_of_number(value) : "null";
    }
    return text + "]";
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// One column: numbers, or indices into a list of words.
std::string column_json(const sweep::TableColumn& column, bool is_parameter) {
    Json head = {{"name", column.name}, {"label", column.label}, {"unit", column.unit}, {"parameter", is_parameter}};
    std::vector<double> values;
    const auto numbers = column.numbers();
    for (const auto& number : numbers) values.push_back(number.value_or(NAN));
    if (numbers.empty()) {
        std::vector<std::string> words;
        for (const std::string& cell : column.cells) {
            auto found = std::ranges::find(words, cell);
            if (found == words.end()) found = words.insert(words.end(), cell);
            values.push_back(static_cast<double>(found - words.begin()));
        }
        head["words"] = words;
    }
    std::string text = text_of(head);
    text.insert(text.size() - 1,
                ",\"values\":" + number_list(values, [](double value) { return core::number_text(value); }));
    return text;
}

/// The columns of all curves, in order of first appearance.
std::vector<const sweep::TraceColumn*> trace_columns(std::span<const sweep::Outcome> outcomes) {
    std::vector<const sweep::TraceColumn*> columns;
    for (const sweep::Outcome& outcome : outcomes)
        for (const sweep::TraceColumn& column : outcome.trace)
            if (std::ranges::find(columns, column.name, &sweep::TraceColumn::name) == columns.end())
                columns.push_back(&column);
    return columns;
}

std::string traces_json(std::span<const sweep::Outcome> outcomes) {
    const auto few_digits = [](double value) { return core::rounded_text(value, 5); };  // a third of the exact text
    const auto columns = trace_columns(outcomes);
    Json heads = Json::array(), axes = {0, 0};
    for (const auto* column : columns)
        heads.push_back({{"name", column->name}, {"label", column->label}, {"unit", column->unit}});
    std::string lists;
    for (const sweep::Outcome& outcome : outcomes) {
        std::string own;
        for (const auto* column : columns) {
            const auto found = std::ranges::find(outcome.trace, column->name, &sweep::TraceColumn::name);
            own += own.empty() ? "" : ",";
            own += found == outcome.trace.end() ? "null" : number_list(found->values, few_digits);
        }
        lists += (lists.empty() ? "" : ",\n") + (outcome.trace.empty() ? std::string{"null"} : "[" + own + "]");
    }
    const auto solved = std::ranges::find_if(outcomes, [](const auto& outcome) { return !outcome.trace.empty(); });
    if (solved != outcomes.end()) axes = sweep::usual_axes(solved->trace);
    return "\"trace_columns\":" + text_of(heads) + ",\"curve_axes\":" + text_of(axes) + ",\n\"traces\":[" + lists + "]";
}

std::string designs_json(const SweepContent& content) {
    Json designs = Json::array();
    for (std::size_t d = 0; d < content.outcomes.size(); ++d) {
        const sweep::Outcome& outcome = content.outcomes[d];
        designs.push_back({{"id", content.ids[d]},
                           {"stop", outcome.stop_reason},
                           {"code", outcome.exit_code ? Json(*outcome.exit_code) : Json()},
                           {"error", outcome.error}});
    }
    return text_of(designs);
}

/// viridis without its lightest tenth, which has little contrast on white.
std::string palette_json() {
    constexpr int count = 32;
    Json colours = Json::array();
    for (int i = 0; i < count; ++i) {
        const Rgb rgb = viridis_at(0.9 * i / (count - 1));
        const auto part = [](double share) { return std::to_string(std::lround(255 * share)); };
        colours.push_back("rgb(" + part(rgb.red) + " " + part(rgb.green) + " " + part(rgb.blue) + ")");
    }
    return text_of(colours);
}

std::string data_json(const SweepContent& content) {
    std::string columns;
    for (const bool is_parameter : {true, false})
        for (const sweep::TableColumn& column : is_parameter ? content.factors : content.outputs)
            columns += (columns.empty() ? "" : ",\n") + column_json(column, is_parameter);
    return "{\"columns\":[" + columns + "],\n\"designs\":" + designs_json(content) +
           ",\n\"palette\":" + palette_json() + ",\n" + traces_json(content.outcomes) + "}";
}

}  // namespace

std::size_t trace_points(std::size_t designs) {
    constexpr std::size_t bytes = 24'000'000, bytes_per_point = 60, least = 8, most = 40;
    return std::clamp(bytes / (bytes_per_point * std::max<std::size_t>(designs, 1)), least, most);
}

std::string make_sweep_report(const SweepContent& content) {
    const auto with_curve =
        std::ranges::count_if(content.outcomes, [](const sweep::Outcome& outcome) { return !outcome.trace.empty(); });
    std::string body = "<p>" + core::counted(content.outcomes.size(), "design") + ", " + std::to_string(with_curve) +
                       " with a curve.</p>\n" + std::string{charts};
    body += "<section><h2>Sweep</h2>\n<pre>" + escaped(content.sweep_text) +
            "</pre>\n<p class='note'>This page: " + escaped(content.made_by) +
            "</p>\n<p class='note'>Colours: viridis by S. van der Walt and N. Smith, public " +
            "domain (CC0); Okabe and Ito (2008).</p></section>\n";
    body += "<script type='application/json' id='data'>" + json_in_page(data_json(content)) + "</script>\n";
    return html_page(content.title, sweep_style, body, joined(sweep_script()));
}

}  // namespace soft::view
