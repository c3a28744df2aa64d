#include "post/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::post {
namespace {

constexpr const char *rss = "band_rss_", *worst = "band_worst_";

std::string cell(double value) { return std::isfinite(value) ? core::number_text(value + 0.0) : ""; }

const Column& load_of(const Curve& curve) { return *curve.find(Source::load); }

const Column& derivative_of(const Curve& curve, const Column& quantity, const model::DesignParameter& parameter) {
    return *curve.find(quantity.quantity + "_by_" + parameter.key);
}

/// Whether the load is constant along the path there: then derivatives are those of the first output at the same progress of the loads.
bool load_is_held(const Curve& curve, std::size_t row) {
    const Column* held = curve.find("load_is_held");
    return held != nullptr && held->values[row] != 0;
}

/// The quantity whose derivatives decide: the load at a fixed first output, in time and where the load is held that output.
const Column& leading_of(const Curve& curve, const model::Case& model) {
    const bool by_output = model::is_timed(model) || load_is_held(curve, curve.row_count() - 1);
    return *curve.find(by_output ? Source::output : Source::load);
}

}  // namespace

std::string sensitivity_csv(const Curve& table, const model::Case& model, std::span<const int> limit_rows) {
    const Column *load = table.find(Source::load), *output = table.find(Source::output);
    const Column &step = *table.find("step"), *stiffness = table.find("stiffness");
    const Column* time = table.find(Source::time);
    std::string text = "step," + (time == nullptr ? "" : time->name + ",") + load->name + "," + output->name +
                       ",parameter,value,unit,d_load,d_output,d_load_percent,d_output_percent\n";
    for (std::size_t row = 0; row < table.row_count(); ++row)
        for (const model::DesignParameter& parameter : model.parameters) {
            const bool is_limit = std::ranges::find(limit_rows, step.values[row]) != limit_rows.end();
            const double value = parameter.value / parameter.SI_per_unit;
            // Between the last row of one stage and the first of another the column is not that of either.
            const bool is_held = load_is_held(table, row);
            const bool stands_still = stiffness != nullptr && !std::isfinite(stiffness->values[row]);
            const double d_load = is_held ? 0 : derivative_of(table, *load, parameter).values[row];
            const double d_output = stiffness == nullptr || is_held
                                        ? derivative_of(table, *output, parameter).values[row]
                                    : is_limit     ? std::numeric_limits<double>::quiet_NaN()
                                    : stands_still ? 0
                                                   : -d_load / stiffness->values[row];
            text += core::number_text(step.values[row]) + "," + (time == nullptr ? "" : cell(time->values[row]) + ",") +
                    cell(load->values[row]) + "," + cell(output->values[row]) + "," + parameter.key + "," +
                    cell(value) + "," + parameter.unit;
            for (const double number :
                 {d_load, d_output, d_load * value / load->values[row], d_output * value / output->values[row]})
                text += "," + cell(number);
            text += '\n';
        }
    return text;
}

std::string sensitivity_script(const Curve& table, const model::Case& model, PictureFormat format) {
    const Column &shown = leading_of(table, model),
                 &at = *table.find(model::is_timed(model)           ? Source::time
                                   : shown.source == Source::output ? Source::load
                                                                    : Source::output);
    if (shown.values.back() == 0)
        throw Error(ExitCode::bad_input, "--plot",
                    "in the last row the " + shown.quantity + " is 0, so there are no percentages",
                    "choose another row with --at");
    struct Bar {
        std::string key;
        double percent;
    };
    std::vector<Bar> bars;
    for (const model::DesignParameter& parameter : model.parameters)
        bars.push_back({parameter.key, derivative_of(table, shown, parameter).values.back() * parameter.value /
                                           parameter.SI_per_unit / shown.values.back()});
    std::ranges::stable_sort(bars, {}, [](const Bar& bar) { return std::abs(bar.percent); });  // upwards
    std::string data, names;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        data += core::number_text(bars[i].percent) + " " + std::to_string(i) + "\n";
        names += (i == 0 ? "" : ", ") + gnuplot_text(bars[i].key) + " " + std::to_string(i);
    }
    constexpr const char* bar =
        "using (0.5*$1):2:(0.5*abs($1)):(0.35) with boxxyerror fillstyle solid linecolor rgb '#0072B2' notitle";
    return terminal(format) + axes_style() + "set title " +
           gnuplot_text(model.name + ": " + shown.quantity + " at " + value_text(at, at.values.back()) + " " +
                        at.quantity) +
           " noenhanced\nset xlabel " + gnuplot_text("change of the " + shown.quantity + " (%) per 1 %") +
           " noenhanced\nset ytics (" + names + ") noenhanced\nset yrange [-0.6:" + std::to_string(bars.size() - 1) +
           ".6]\nset yzeroaxis\nset offsets graph 0.03, graph 0.03, 0, 0\n$bars << EOD\n" + data + "EOD\nplot $bars " +
           bar + "\n";
}

void Deviations::add(const Deviations& others) {
    const std::size_t own = parameters.size(), more = others.parameters.size(), size = own + more;
    std::vector<double> all(size * size);
    for (std::size_t i = 0; i < own; ++i)
        for (std::size_t j = 0; j < own; ++j) all[i * size + j] = covariance[i * own + j];
    for (std::size_t i = 0; i < more; ++i)
        for (std::size_t j = 0; j < more; ++j) all[(own + i) * size + own + j] = others.covariance[i * more + j];
    parameters.insert(parameters.end(), others.parameters.begin(), others.parameters.end());
    covariance = std::move(all);
}

Deviations parse_tolerances(std::span<const std::string> texts, const model::Case& model) {
    Deviations tolerances;
    for (const std::string& text : texts) {
        const std::string option = "--tolerances " + text;
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos)
            throw Error(ExitCode::usage, option, "is not KEY=VALUE", "for example geometry.wall=0.1mm");
        const std::string key{core::trimmed(text.substr(0, equals))}, given = text.substr(equals + 1);
        const auto found = std::ranges::find(model.parameters, key, &model::DesignParameter::key);
        if (found == model.parameters.end()) {
            std::vector<std::string> known;
            for (const model::DesignParameter& parameter : model.parameters) known.push_back(parameter.key);
            throw Error(ExitCode::usage, option, "the result has no sensitivity to this number",
                        known.empty() ? "name it in mesh-gen --sensitivity" : core::did_you_mean(key, known));
        }
        if (std::ranges::find(tolerances.parameters, static_cast<std::size_t>(found - model.parameters.begin())) !=
            tolerances.parameters.end())
            throw Error(ExitCode::usage, option, "the tolerance of this number is given twice", "omit one of them");
        const bool is_share = core::quantity_parts(given).unit == "%";
        const auto dimension = is_share || found->unit.empty()
                                   ? core::Dimension::ratio
                                   : core::dimension_of(found->unit).value_or(core::Dimension::ratio);
        const double value = core::quantity_or_throw(given, dimension, ExitCode::usage, option);
        if (!(value >= 0)) throw Error(ExitCode::usage, option, "a tolerance is not negative");
        const double size_SI = is_share ? value * std::abs(found->value) : value;
        tolerances.add({{static_cast<std::size_t>(found - model.parameters.begin())}, {size_SI * size_SI}});
    }
    return tolerances;
}

std::string add_tolerance_band(Curve& curve, const model::Case& model, const Deviations& deviations) {
    const Column load = load_of(curve), output = *curve.find(Source::output), leading = leading_of(curve, model);
    const std::size_t rows = curve.row_count(), count = deviations.parameters.size();
    std::string dominant;
    struct Band {
        std::vector<double> root, sum;
    };
    const auto band_of = [&](const Column& quantity) {
        Band band{std::vector<double>(rows), std::vector<double>(rows)};
        for (std::size_t row = 0; row < rows; ++row) {
            std::vector<double> by;  // SI
            for (const std::size_t k : deviations.parameters)
                by.push_back(derivative_of(curve, quantity, model.parameters[k]).values[row] /
                             model.parameters[k].SI_per_unit);
            double square = 0, largest = -1;
            for (std::size_t i = 0; i < count; ++i) {
                const double own = std::abs(by[i]) * std::sqrt(deviations.covariance[i * count + i]);
                band.sum[row] += own;
                for (std::size_t j = 0; j < count; ++j) square += by[i] * by[j] * deviations.covariance[i * count + j];
                if (own > largest && quantity.name == leading.name) {
                    largest = own;
                    dominant = model.parameters[deviations.parameters[i]].key;
                }
            }
            band.root[row] = std::sqrt(std::max(0.0, square));
        }
        return band;
    };
    Band of_load = band_of(load);
    const Column* stiffness = curve.find("stiffness");
    std::vector<double> of_output = band_of(output).root;
    for (std::size_t row = 0; stiffness != nullptr && row < rows; ++row)
        if (!load_is_held(curve, row)) of_output[row] = of_load.root[row] / std::abs(stiffness->values[row]);
    const std::string at = stiffness == nullptr ? "at a fixed time" : "at a fixed output",
                      at_load = stiffness == nullptr ? at : "at a fixed load";
    const auto add = [&](const char* kind, const Column& of, std::vector<double> values, std::string meaning) {
        Column column = of;
        column.name = kind + of.name;
        column.quantity = kind + of.quantity;
        column.meaning = std::move(meaning);
        column.role = Role::dependent;
        column.source = Source::other;
        column.values = std::move(values);
        column.slopes.clear();
        curve.columns.push_back(std::move(column));
    };
    add(rss, load, std::move(of_load.root),
        "half width of the band of the tolerances " + at + ": root of the sum of squares");
    add(worst, load, std::move(of_load.sum), "half width of the band of the tolerances " + at + ": sum");
    add(rss, output, std::move(of_output), "half width of the band of the tolerances " + at_load);
    return dominant;
}

}  // namespace soft::post
