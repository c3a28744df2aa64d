/// Which columns there are, and which are shown: what writes the table is asked, so that the list cannot differ from it.
#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/curve.hpp"

namespace soft::post {

std::vector<Column> all_columns() {
    std::vector<Column> all;
    const auto take = [&](const model::Case& model, const solution::Step& step) {
        for (Column& column : make_curve(model, {&step, 1}).columns) {
            column.values.clear();
            column.slopes.clear();
            if (std::ranges::find(all, column.name, &Column::name) == all.end()) all.push_back(std::move(column));
        }
    };
    model::Case model;
    solution::Step step;
    for (const model::Measure measure : model::all_measures) {
        model.outputs.push_back({std::string{"<"}.append(model::name_of(measure)).append(">"), "<face>", {}, measure});
        step.outputs.push_back(0);
        step.output_errors.push_back(0);
    }
    model.path.stages.resize(2);
    step.volume_m3 = step.pressure_error_Pa = 0.0;
    step.extremes = solution::Step::Extremes{};
    step.energies = solution::Step::Energies{};
    model.cavities = {{"<cavity>", "", {}, {}}, {"<other>", "", {}, {}}};
    model.loads = {{.name = "<load>", .targets = {"<cavity>", "<other>"}, .gas = {}},
                   {.name = "<more>", .targets = {}, .gas = {}}};
    step.pressures_Pa = step.volumes_m3 = {0, 0};
    take(model, step);
    std::erase_if(all, [](const Column& column) {
        return column.name.find("<other>") != std::string::npos || column.name.find("<more>") != std::string::npos;
    });
    model.loads.clear();
    step.pressures_Pa.clear();
    step.volumes_m3.clear();
    take(model, step);
    model.tractions.resize(1);
    take(model, step);
    model.tractions[0].area_m2 = 1;
    model.kinematics = model::Kinematics::axisymmetric;
    step.motion = solution::Step::Motion{};
    step.energies.reset();
    take(model, step);
    return all;
}

void show_also(Curve& curve, std::span<const std::string> quantities) {
    for (const std::string& quantity : quantities) {
        std::vector<std::string> known;
        bool found = quantity == "all";
        for (Column& column : curve.columns) {
            if (quantity == "all" || column.quantity == quantity || column.name == quantity) {
                column.shown = Shown::always;
                found = true;
            }
            known.push_back(column.quantity);
        }
        if (!found)
            throw Error(ExitCode::usage, "--also", "the result has no column " + core::quoted(quantity),
                        core::did_you_mean(quantity, known) + "; --outputs lists them");
    }
}

std::vector<const Column*> shown_columns(const Curve& curve) {
    std::vector<const Column*> shown;
    for (const Column& column : curve.columns)
        if (column.shown == Shown::always) shown.push_back(&column);
    return shown;
}

std::string column_text(std::span<const Column> columns) {
    std::size_t widest = 0;
    for (const Column& column : columns) widest = std::max(widest, column.name.size());
    std::string text;
    for (const Column& column : columns) {
        constexpr std::size_t unit_width = 8;
        std::string line =
            column.name + std::string(widest + 2 - column.name.size(), ' ') + (column.unit.empty() ? "-" : column.unit);
        line += std::string(
            unit_width > column.unit.size() ? unit_width - std::max<std::size_t>(column.unit.size(), 1) : 1, ' ');
        text += line + column.meaning + (column.shown == Shown::on_demand ? " (--also " + column.quantity + ")" : "") +
                '\n';
    }
    return text;
}

}  // namespace soft::post
