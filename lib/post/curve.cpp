#include "post/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/error.hpp"

namespace soft::post {
namespace {

struct Unit {
    std::string_view name, suffix;  // "1/m", and the suffix of the column name: "per_m"
    core::Dimension dimension;
    double SI_per_unit;
};
constexpr Unit kilopascal{"kPa", "kPa", core::Dimension::pressure, 1e3}, newton{"N", "N", core::Dimension::force, 1},
    millilitre{"mL", "mL", core::Dimension::volume, 1e-6}, second{"s", "s", core::Dimension::time, 1},
    hertz{"Hz", "Hz", core::Dimension::rate, 1}, millijoule{"mJ", "mJ", core::Dimension::energy, 1e-3},
    millimetre{"mm", "mm", core::Dimension::length, 1e-3},
    per_volume{"kJ/m^3", "kJ_m3", core::Dimension::pressure, 1e3}, none{"", "", core::Dimension::ratio, 1};

Unit column_unit(model::Measure measure) {
    const model::MeasureUnit& unit = model::unit_of(measure);
    return {unit.shown, unit.suffix, unit.dimension, unit.SI_per_shown};
}

Column with_unit(const std::string& quantity, const Unit& unit, Role role, std::string meaning) {
    Column column;
    column.name = unit.name.empty() ? quantity : quantity + "_" + std::string{unit.suffix};
    column.quantity = quantity;
    column.unit = unit.name;
    column.meaning = std::move(meaning);
    column.dimension = unit.dimension;
    column.SI_per_unit = unit.SI_per_unit;
    column.role = role;
    return column;
}

Column coordinate(const std::string& quantity, const Unit& unit, Source source, std::string meaning,
                  std::size_t index = 0) {
    Column column = with_unit(quantity, unit, Role::coordinate, std::move(meaning));
    column.source = source;
    column.index = index;
    return column;
}

Column plain(const std::string& name, Role role, std::string meaning) {
    return with_unit(name, none, role, std::move(meaning));
}

/// Column with the half width of the error of a coordinate: "pressure_error_kPa".
Column error_column(const Column& of) {
    Column column = of;
    column.quantity += "_error";
    column.name = column.quantity + of.name.substr(of.quantity.size());
    column.meaning = of.source == Source::load
                         ? "half width of the mesh error of " + of.quantity + ", at equal first output"
                         : "half width of the mesh error of " + of.quantity + ", at equal load";
    column.role = Role::dependent;
    column.source = Source::other;
    return column;
}

Column leading_column(const model::Case& model) {
    switch (model::leading_load(model)) {
        case model::LeadingLoad::pressure:
            return coordinate("pressure", kilopascal, Source::load, "gauge pressure of the first load");
        case model::LeadingLoad::traction:
            return coordinate("traction", kilopascal, Source::load, "first traction, if the case has no pressure load");
        case model::LeadingLoad::force:
            return coordinate("load", newton, Source::load, "first force on a face, if the case has no pressure load");
        case model::LeadingLoad::load_factor: break;
    }
    return coordinate("load_factor", none, Source::load,
                      "fraction of the loads, if the case has no pressure, traction or force");
}

/// Quantities of a step that are part of the table only on request.
struct OnDemand {
    using Number = std::function<std::optional<double>(const model::Step&)>;
    Column column;
    Number value_SI;
    Number slope_SI = [](const model::Step&) { return std::nullopt; };
};

std::vector<OnDemand> on_demand(const model::Case& model) {
    std::vector<OnDemand> list;
    const auto add = [&](const char* name, const Unit& unit, const char* meaning, auto value) {
        list.push_back({with_unit(name, unit, Role::dependent, meaning), value});
        list.back().column.shown = Shown::on_demand;
    };
    using Step = model::Step;
    using Value = std::optional<double>;
    add("stored_energy", millijoule, "strain energy stored in the whole actuator",
        [](const Step& s) { return s.energies ? Value(s.energies->stored_J) : std::nullopt; });
    add("load_work", millijoule, "work done by the loads since the start of the path",
        [](const Step& s) { return s.energies ? Value(s.energies->load_work_J) : std::nullopt; });
    for (OnDemand& energy : list) energy.slope_SI = [](const Step& s) { return s.energies->tangent_J; };
    const auto position = [](std::size_t i) {
        return [i](const Step& s) { return s.extremes ? Value(s.extremes->stretch_at_m[i]) : std::nullopt; };
    };
    add("max_stretch_x", millimetre, "undeformed position of max_stretch", position(0));
    if (model.kinematics == model::Kinematics::axisymmetric)
        add("max_stretch_r", millimetre, "undeformed position of max_stretch", position(1));
    else
        add("max_stretch_y", millimetre, "undeformed position of max_stretch", position(1));
    if (model.kinematics == model::Kinematics::solid)
        add("max_stretch_z", millimetre, "undeformed position of max_stretch", position(2));
    add("max_energy_density", per_volume, "largest strain energy per undeformed volume at a quadrature point",
        [](const Step& s) { return s.extremes ? Value(s.extremes->energy_J_m3) : std::nullopt; });
    return list;
}

/// Columns of dynamic cases only: the time, which parametrises the path, and the energies.
struct MotionColumns {
    using Motion = model::Step::Motion;
    struct Energy {
        Column column;
        double Motion::*value;
    };
    Column time = coordinate("time", second, Source::time, "time since the undeformed state at rest");
    std::vector<Energy> energies;

    MotionColumns() {
        const auto add = [&](const char* name, double Motion::*value, const char* meaning) {
            energies.push_back({with_unit(name, millijoule, Role::dependent, meaning), value});
        };
        add("kinetic_energy", &Motion::kinetic_energy_J, "kinetic energy of the whole actuator, dynamic cases only");
        add("stored_energy", &Motion::stored_energy_J, "strain energy stored in the whole actuator");
        add("load_work", &Motion::load_work_J, "work done by the loads since the start of the path");
        add("damping_work", &Motion::damping_work_J, "energy dissipated by damping, dynamic cases only");
    }
    void push(const Motion& motion) {
        time.values.push_back(motion.time_s);
        time.slopes.push_back(1);  // the other slopes are derivatives by time
        for (Energy& energy : energies)
            energy.column.values.push_back(in_column_unit(energy.column, motion.*energy.value));
    }
};

/// Columns of the list members of a step: outputs, and pressures and volumes of cases with several.
struct ListColumns {
    std::vector<Column> columns;
    std::vector<double> model::Step::*values;
    std::vector<double> model::Step::*slopes;
    const char* what;
};

ListColumns output_columns(const model::Case& model) {
    ListColumns list{{}, &model::Step::outputs, &model::Step::tangent_outputs, "outputs"};
    for (std::size_t i = 0; i < model.outputs.size(); ++i) {
        const model::Output& output = model.outputs[i];
        list.columns.push_back(coordinate(
            output.name, column_unit(output.measure), Source::output,
            std::string{model::info_of(output.measure).meaning} + ": " + (output.point_m ? "a point" : output.face),
            i));
    }
    return list;
}

ListColumns pressure_columns(const model::Case& model) {
    ListColumns list{{}, &model::Step::pressures_Pa, &model::Step::tangent_pressures, "pressures"};
    if (model.loads.size() > 1)
        for (const model::PressureLoad& load : model.loads)
            list.columns.push_back(coordinate("pressure_" + load.name, kilopascal, Source::other,
                                              "gauge pressure of each load, if there are several"));
    return list;
}

ListColumns volume_columns(const model::Case& model) {
    ListColumns list{{}, &model::Step::volumes_m3, &model::Step::tangent_volumes, "volumes"};
    const auto cavities = model::measured_cavities(model);
    if (cavities.size() > 1)
        for (const model::Cavity* cavity : cavities)
            list.columns.push_back(coordinate("volume_" + cavity->name, millilitre, Source::other,
                                              "volume enclosed by each cavity, if there are several"));
    return list;
}

void push(Column& column, double value_SI, double slope_SI) {
    column.values.push_back(in_column_unit(column, value_SI));
    column.slopes.push_back(in_column_unit(column, slope_SI));
}

void push(ListColumns& list, const model::Step& step) {
    const auto& values = step.*list.values;
    const auto& slopes = step.*list.slopes;
    for (std::size_t i = 0; i < list.columns.size(); ++i)
        push(list.columns[i], values[i], i < slopes.size() ? slopes[i] : 0);
}

void check(std::span<const model::Step> steps, std::span<const ListColumns> lists) {
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const model::Step& step = steps[row];
        const std::string location = "path, step " + std::to_string(row);
        for (const ListColumns& list : lists)
            if ((step.*list.values).size() != list.columns.size())
                throw Error(ExitCode::bad_input, location,
                            std::to_string((step.*list.values).size()) + " " + list.what +
                                " are recorded, the case has " + std::to_string(list.columns.size()));
        if (step.volume_m3.has_value() != steps.front().volume_m3.has_value())
            throw Error(ExitCode::bad_input, location, "the cavity volume is recorded at some of the steps only");
        if (step.motion.has_value() != steps.front().motion.has_value())
            throw Error(ExitCode::bad_input, location, "the time is recorded at some of the steps only");
        if (step.frequencies_Hz.size() != steps.front().frequencies_Hz.size())
            throw Error(ExitCode::bad_input, location,
                        "the natural frequencies are recorded at some of the steps only");
        const bool has_errors = steps.front().pressure_error_Pa.has_value();
        if (step.pressure_error_Pa.has_value() != has_errors ||
            step.output_errors.size() != (has_errors ? lists.front().columns.size() : 0))
            throw Error(ExitCode::bad_input, location, "the errors are recorded at some of the steps only");
    }
}

}  // namespace

double in_column_unit(const Column& column, double value_SI) noexcept {
    // 1000 is an exact double, 1e-3 is not: multiply by the inverse if that is a whole number
    const double inverse = 1 / column.SI_per_unit, whole = std::round(inverse);
    if (std::abs(inverse - whole) <= 1e-12 * inverse) return value_SI * whole;
    return value_SI / column.SI_per_unit;
}

const Column* Curve::find(std::string_view quantity) const noexcept {
    const auto hit =
        std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.quantity == quantity; });
    return hit == columns.end() ? nullptr : &*hit;
}

std::string Curve::coordinate_names() const {
    std::string names;
    for (const Column& column : columns)
        if (column.role == Role::coordinate) names.append(names.empty() ? "" : ", ").append(column.quantity);
    return names;
}

Curve make_curve(const model::Case& model, std::span<const model::Step> steps) {
    std::array lists{output_columns(model), pressure_columns(model), volume_columns(model)};
    check(steps, lists);
    const bool has_volume = !steps.empty() && steps.front().volume_m3.has_value();
    const bool moves = !steps.empty() && steps.front().motion.has_value();
    MotionColumns motion;

    Column number = plain("step", Role::counter, "number of the row");
    Column stage = plain("stage", Role::stage, "number of the stage, from 1, if the path has several");
    Column load = leading_column(model);
    Column volume = coordinate("volume", millilitre, Source::volume,
                               "volume enclosed by the cavities of the first load, whole actuator");
    std::vector<Column> errors;
    if (!steps.empty() && steps.front().pressure_error_Pa) {
        errors.push_back(error_column(load));
        for (const Column& output : lists[0].columns) errors.push_back(error_column(output));
    }
    Column p99 = plain("stretch_p99", Role::dependent,
                       "principal stretch exceeded in 1 % of the rubber; converges with the mesh");
    Column largest = plain("max_stretch", Role::dependent, "largest principal stretch at a quadrature point");
    Column jacobian = plain("min_J", Role::dependent, "smallest volume ratio J at a quadrature point");
    Column stable = plain("stable", Role::flag, "1 if the state is stable under the loads as stated in the design");
    Column controlled = plain("stable_under_control", Role::flag,
                              "1 if the state is stable under the control used, such as a prescribed volume");
    const bool has_controlled = !steps.empty() && std::ranges::all_of(steps, [](const model::Step& step) {
        return step.stable_under_control.has_value();
    });
    std::vector<Column> frequencies;
    for (std::size_t k = 1; !steps.empty() && k <= steps.front().frequencies_Hz.size(); ++k)
        frequencies.push_back(with_unit("frequency_" + std::to_string(k), hertz, Role::dependent,
                                        "natural frequency 1, 2 ... about the state, loads held; negative: unstable"));
    std::vector<OnDemand> extras = on_demand(model);
    std::erase_if(extras, [&](const OnDemand& extra) {
        return !std::ranges::all_of(steps, [&](const model::Step& step) { return extra.value_SI(step).has_value(); }) ||
               steps.empty();
    });
    for (const model::Step& step : steps) {
        number.values.push_back(static_cast<double>(number.values.size()));
        if (moves) motion.push(*step.motion);
        stage.values.push_back(step.stage + 1);
        push(load, step.pressure_Pa, step.tangent_pressure);
        if (has_volume) push(volume, *step.volume_m3, step.tangent_volume);
        for (ListColumns& list : lists) push(list, step);
        for (std::size_t i = 0; i < errors.size(); ++i)
            errors[i].values.push_back(
                in_column_unit(errors[i], i == 0 ? *step.pressure_error_Pa : step.output_errors[i - 1]));
        p99.values.push_back(step.stretch_p99);
        largest.values.push_back(step.max_stretch);
        jacobian.values.push_back(step.min_jacobian);
        stable.values.push_back(step.stable ? 1 : 0);
        controlled.values.push_back(step.stable_under_control.value_or(step.stable) ? 1 : 0);
        for (std::size_t k = 0; k < frequencies.size(); ++k) frequencies[k].values.push_back(step.frequencies_Hz[k]);
        for (OnDemand& extra : extras) {
            extra.column.values.push_back(in_column_unit(extra.column, *extra.value_SI(step)));
            if (const auto slope = extra.slope_SI(step))
                extra.column.slopes.push_back(in_column_unit(extra.column, *slope));
        }
    }
    for (OnDemand& extra : extras)
        if (extra.column.slopes.size() != steps.size()) extra.column.slopes.clear();

    Curve curve;
    const auto add = [&](Column& column) { curve.columns.push_back(std::move(column)); };
    add(number);
    if (moves) add(motion.time);
    if (model.path.stages.size() > 1) add(stage);
    add(load);
    for (Column& column : lists[0].columns) add(column);
    if (has_volume) add(volume);
    for (std::size_t i = 1; i < lists.size(); ++i)
        for (Column& column : lists[i].columns) add(column);
    for (Column& column : errors) add(column);
    for (Column& column : frequencies) add(column);
    if (moves)
        for (auto& energy : motion.energies) add(energy.column);
    for (Column* column : {&p99, &largest, &jacobian, &stable}) add(*column);
    if (has_controlled) add(controlled);
    for (OnDemand& extra : extras) add(extra.column);
    return curve;
}

std::optional<double> value_at(const Column& column, const model::LimitPoint& point) {
    switch (column.source) {
        case Source::load: return in_column_unit(column, point.pressure_Pa);
        case Source::output:
            if (column.index >= point.outputs.size()) return std::nullopt;
            return in_column_unit(column, point.outputs[column.index]);
        case Source::volume:
            if (!point.volume_m3) return std::nullopt;
            return in_column_unit(column, *point.volume_m3);
        case Source::time:
        case Source::other: break;
    }
    return std::nullopt;
}

}  // namespace soft::post
