#include "sweep/plot.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::sweep {
namespace {

constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
constexpr const char* cross = "with points pointtype 2 pointsize 0.5 linewidth 1.5 linecolor rgb '#000000'";
constexpr int digits = 6;

using Columns = std::span<const TableColumn>;

std::string axis_text(const std::string& label, const std::string& unit) {
    return post::gnuplot_text(unit.empty() ? label : label + " (" + unit + ")") + " noenhanced\n";
}

const TraceColumn* find_in(const Trace& trace, const std::string& name) {
    const auto found = std::ranges::find_if(
        trace, [&](const TraceColumn& column) { return column.name == name || column.label == name; });
    return found == trace.end() ? nullptr : &*found;
}

const TableColumn* find_in(Columns factors, Columns outputs, const std::string& name) {
    const TableColumn* factor = find_column(factors, name);
    return factor != nullptr ? factor : find_column(outputs, name);
}

/// The lines or points of the designs with one colour value.
struct Group {
    std::string title, data;
};

/// Data with the colour value as third column, or one group for each value.
class Colours {
public:
    explicit Colours(const TableColumn& column) : column_{column}, numbers_{column.numbers()} {
        constexpr std::size_t max_values = colours.size();
        for (const std::string& cell : column.cells)
            if (!cell.empty() && std::ranges::find(values_, cell) == values_.end()) values_.push_back(cell);
        is_scale_ = !numbers_.empty() && values_.size() > max_values;
        groups_.resize(is_scale_ ? 1 : values_.size());
        for (std::size_t g = 0; !is_scale_ && g < values_.size(); ++g)
            groups_[g].title = column.label + " " + values_[g] + (column.unit.empty() ? "" : " " + column.unit);
    }
    /// Adds lines "x y"; nothing for a design without a colour value.
    void add(std::size_t design, const std::vector<std::string>& lines) {
        const std::string& cell = column_.cells[design];
        if (cell.empty()) return;
        const auto group = is_scale_ ? 0 : std::ranges::find(values_, cell) - values_.begin();
        std::string& data = groups_[static_cast<std::size_t>(group)].data;
        for (const std::string& line : lines) data += line + (is_scale_ ? " " + cell : "") + "\n";
        if (lines.size() > 1) data += "\n";  // gnuplot starts a new line
    }
    [[nodiscard]] bool is_empty() const {
        return std::ranges::all_of(groups_, [](const Group& group) { return group.data.empty(); });
    }
    /// Data blocks, and the entries of the plot command; `how` is "with lines linewidth 1".
    [[nodiscard]] std::string blocks() const {
        std::string text = is_scale_ ? "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 "
                                       "'#fde725')\nset cblabel " +
                                           axis_text(column_.label, column_.unit)
                                     : "";
        for (std::size_t g = 0; g < groups_.size(); ++g)
            text += "$group" + std::to_string(g) + " << EOD\n" + groups_[g].data + "EOD\n";
        return text;
    }
    [[nodiscard]] std::string entries(const std::string& how) const {
        std::vector<std::string> entries;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const std::string block = "$group" + std::to_string(g) + " ";
            if (is_scale_) entries.push_back(block + "using 1:2:3 " + how + " linecolor palette notitle");
            if (is_scale_ || groups_[g].data.empty()) continue;
            const std::string colour = std::string{" linecolor rgb '"} + colours[g % colours.size()] + "'";
            entries.push_back(block + how + colour + " title " + post::gnuplot_text(groups_[g].title));
        }
        return core::join(entries);
    }

private:
    const TableColumn& column_;
    std::vector<std::optional<double>> numbers_;
    std::vector<std::string> values_;  ///< distinct cells
    bool is_scale_ = false;
    std::vector<Group> groups_;
};

struct Drawing {
    bool are_points = false;
    Colours lines;
    std::string x_axis = {}, y_axis = {};
    std::string ends = {};  ///< of paths that ended early
};

bool ended_early(const Outcome& outcome) { return outcome.exit_code != 0; }

std::string text_of(double x, double y) { return core::rounded_text(x, digits) + " " + core::rounded_text(y, digits); }

void add_curves(Drawing& drawing, std::span<const Outcome> outcomes, const std::string& x, const std::string& y) {
    for (std::size_t d = 0; d < outcomes.size(); ++d) {
        const TraceColumn *over = find_in(outcomes[d].trace, x), *of = find_in(outcomes[d].trace, y);
        if (over == nullptr || of == nullptr) continue;
        drawing.x_axis = axis_text(over->label, over->unit);
        drawing.y_axis = axis_text(of->label, of->unit);
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < over->values.size(); ++i) lines.push_back(text_of(over->values[i], of->values[i]));
        drawing.lines.add(d, lines);
        if (ended_early(outcomes[d])) drawing.ends += lines.back() + "\n";
    }
}

void add_points(Drawing& drawing, std::span<const Outcome> outcomes, const TableColumn& x, const TableColumn& y) {
    drawing.x_axis = axis_text(x.label, x.unit);
    drawing.y_axis = axis_text(y.label, y.unit);
    const auto over = x.numbers(), of = y.numbers();
    for (std::size_t d = 0; d < std::min(over.size(), of.size()); ++d) {
        if (!over[d] || !of[d]) continue;
        drawing.lines.add(d, {text_of(*over[d], *of[d])});
        if (ended_early(outcomes[d])) drawing.ends += text_of(*over[d], *of[d]) + "\n";
    }
}

[[noreturn]] void refuse(const char* option, const std::string& name, const Trace& trace, Columns factors,
                         Columns outputs) {
    std::vector<std::string> known;
    for (const TraceColumn& column : trace) known.push_back(column.label);
    for (const Columns columns : {factors, outputs})
        for (const TableColumn& column : columns) known.push_back(column.name);
    throw Error(ExitCode::usage, option, "neither the curves nor the results have a column " + core::quoted(name),
                core::did_you_mean(name, known));
}

std::string script_of(const Drawing& drawing, const post::PlotRequest& request, post::PictureFormat format) {
    const std::string entries = drawing.lines.entries(drawing.are_points ? "with points pointtype 7 pointsize 0.6"
                                                                         : "with lines linewidth 1.3");
    return post::terminal(format) + "set encoding utf8\nset xlabel " + drawing.x_axis + "set ylabel " + drawing.y_axis +
           post::axes_style() + "set key outside top center horizontal reverse Left samplen 2 noenhanced\n" +
           "set autoscale fix\nset offsets graph " +
           (drawing.are_points ? "0.03, graph 0.03, graph 0.05, graph 0.03\n" : "0, graph 0.03, graph 0.05, 0\n") +
           (request.title.empty() ? "" : "set title " + post::gnuplot_text(request.title) + " noenhanced\n") +
           drawing.lines.blocks() +
           (drawing.ends.empty() ? "plot " + entries
                                 : "$ends << EOD\n" + drawing.ends + "EOD\nplot " + entries + ", $ends " + cross +
                                       " title 'ended early'") +
           "\n";
}

}  // namespace

std::string plot_script(Columns factors, Columns outputs, std::span<const Outcome> outcomes,
                        const post::PlotRequest& request, post::PictureFormat format) {
    const auto solved = std::ranges::find_if(outcomes, [](const Outcome& outcome) { return !outcome.trace.empty(); });
    if (solved == outcomes.end()) throw Error(ExitCode::bad_input, "--plot", "no design has a curve");
    const Trace& trace = solved->trace;
    const TableColumn* colour = request.colour.empty() ? &factors.front() : find_in(factors, outputs, request.colour);
    if (colour == nullptr) refuse("--colour", request.colour, {}, factors, outputs);
    const TableColumn *x = find_in(factors, outputs, request.x), *y = find_in(factors, outputs, request.y);
    if (!request.x.empty() && x == nullptr && find_in(trace, request.x) == nullptr)
        refuse("--x", request.x, trace, factors, outputs);
    if (!request.y.empty() && y == nullptr && find_in(trace, request.y) == nullptr)
        refuse("--y", request.y, trace, factors, outputs);
    if (request.y.empty() && x != nullptr && !outputs.empty()) y = &outputs.front();
    if (request.x.empty() && y != nullptr) x = &factors.front();
    if ((x == nullptr) != (y == nullptr))
        throw Error(ExitCode::usage, x == nullptr ? "--x" : "--y",
                    "is a column of the curves, the other one of the results",
                    "name two columns of the curves, or two of results.csv");
    Drawing drawing{.are_points = x != nullptr, .lines = Colours{*colour}};
    const auto usual_name = [&](std::size_t axis) { return trace[usual_axes(trace)[axis]].name; };
    if (x == nullptr)
        add_curves(drawing, outcomes, request.x.empty() ? usual_name(0) : request.x,
                   request.y.empty() ? usual_name(1) : request.y);
    else
        add_points(drawing, outcomes, *x, *y);
    if (drawing.lines.is_empty())
        throw Error(ExitCode::bad_input, "--plot", "no design has numbers in both columns",
                    "choose others with --x and --y");
    return script_of(drawing, request, format);
}

}  // namespace soft::sweep
