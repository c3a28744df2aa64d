#include "solver/row_state.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace soft::solver {

namespace {

/// Lobatto's rule with five points on [0, 1], exact up to degree 7 (Abramowitz and Stegun, Handbook of Mathematical Functions, table 25.6).
constexpr double inner_point = 0.17267316464601142;  // (1 - sqrt(3/7)) / 2
constexpr std::array<std::pair<double, double>, 5> lobatto_points{
    {{0.0, 0.05}, {inner_point, 49.0 / 180}, {0.5, 64.0 / 180}, {1.0 - inner_point, 49.0 / 180}, {1.0, 0.05}}};

/// The first traction from levels, or its slope from their slopes.
double first_traction_Pa(const model::Case& input, const LoadLevels& levels) {
    const std::size_t first = model::first_traction(input).value();
    const model::DeadLoad& load = input.dead_loads[first];
    const auto& t = load.vector_SI;
    return load.sign * levels.dead_loads[first] * std::hypot(t[0], t[1], t[2]);
}

/// Of the tangents in a row: on a path in time, slopes are by time.
double scale_of(const PathPoint& point) {
    return point.level_slopes.time_s > 0.0 ? 1.0 / point.level_slopes.time_s : 1.0;
}

}  // namespace

double leading_of(const model::Case& input, const LoadLevels& levels, double load_factor) {
    switch (model::leading_load(input)) {
        case model::LeadingLoad::pressure: return levels.pressures_Pa[0];
        case model::LeadingLoad::traction: return first_traction_Pa(input, levels);
        case model::LeadingLoad::force:
            return first_traction_Pa(input, levels) * input.dead_loads[*model::first_traction(input)].area_m2;
        case model::LeadingLoad::load_factor:
            if (!input.dynamics) return load_factor;
            return levels.dead_loads.empty() ? levels.motions.at(0) : levels.dead_loads[0];  // of time functions
    }
    throw std::logic_error("leading_of: unknown load");
}

double leading_of(const model::Case& input, const StageLoads& loads, const State& state) {
    return leading_of(input, loads.levels(state.load_factor, state.pressures_Pa), state.load_factor);
}

StageStart stage_start_at(const model::Case& input, const StageLoads& loads, const PathPoint& point) {
    const LoadLevels levels = loads.levels(point.state.load_factor, point.state.pressures_Pa);
    StageStart start{levels.pressures_Pa, point.load_volumes_m3, {}, levels.dead_loads, levels.motions, levels.time_s};
    for (std::size_t i = 0; i < input.loads.size(); ++i)
        start.masses_kg.push_back(gas_mass_kg(input.loads[i].gas, start.volumes_m3[i], start.pressures_Pa[i]));
    return start;
}

std::vector<double> undeformed_volumes_m3(fem::System& system) {
    const linalg::Vector undeformed = system.make_vector();
    std::vector<double> volumes;
    for (std::size_t load = 0; load < system.input().loads.size(); ++load)
        volumes.push_back(system.volumes().of_load(load, undeformed, nullptr));
    return volumes;
}

void read_values(fem::System& system, const StageLoads& loads, const PathPoint* before, PathPoint& point) {
    LoadLevels slopes = fem::moved(fem::no_loads(system.input()), point.tangent.load_factor, loads.rate());
    const auto& free = loads.free_supplies();
    for (std::size_t k = 0; k < free.size(); ++k) slopes.pressures_Pa[free[k]] = point.tangent.pressures[k];
    read_values(system, loads.levels(point.state.load_factor, point.state.pressures_Pa), slopes, before, point);
}

void read_values(fem::System& system, const LoadLevels& levels, const LoadLevels& slopes, const PathPoint* before,
                 PathPoint& point) {
    const model::Case& input = system.input();
    system.prescribe(levels);
    const linalg::Vector gradient = system.make_vector();
    std::vector<double> by_motion(slopes.motions.size());
    const auto slope_along = [&] {
        double slope = linalg::dot(gradient, point.tangent.x);
        for (std::size_t m = 0; m < by_motion.size(); ++m) slope += by_motion[m] * slopes.motions[m];
        return slope;
    };
    for (auto* list : {&point.pressure_slopes, &point.volumes_m3, &point.volume_slopes, &point.load_volumes_m3,
                       &point.load_volume_slopes, &point.outputs, &point.output_slopes})
        list->clear();
    point.levels = levels;
    point.level_slopes = slopes;
    point.pressures_Pa = levels.pressures_Pa;
    point.pressure_slopes = slopes.pressures_Pa;
    for (std::size_t cavity = 0; cavity < system.volumes().count(); ++cavity) {
        point.volumes_m3.push_back(system.volumes().of_cavity(cavity, point.state.x, gradient, by_motion));
        point.volume_slopes.push_back(slope_along());
    }
    for (std::size_t load = 0, cavity = 0; load < input.loads.size(); ++load) {
        point.load_volumes_m3.push_back(0.0);
        point.load_volume_slopes.push_back(0.0);
        for (std::size_t n = 0; n < input.loads[load].targets.size() && system.volumes().has_volume(load);
             ++n, ++cavity) {
            point.load_volumes_m3.back() += point.volumes_m3[cavity];
            point.load_volume_slopes.back() += point.volume_slopes[cavity];
        }
    }
    for (std::size_t i = 0; i < system.outputs().count(); ++i) {
        fem::LoadLevels by_levels;
        double value = system.outputs().value(i, point.state.x, gradient, &by_levels);
        if (model::is_angle(input.outputs[i].measure) && before != nullptr)  // angles continue beyond 180 degrees
            value = before->outputs[i] + std::remainder(value - before->outputs[i], 2.0 * std::numbers::pi);
        point.outputs.push_back(value);
        point.output_slopes.push_back(linalg::dot(gradient, point.tangent.x) + fem::product(by_levels, slopes));
    }
    point.touches = system.contact().touches(point.state.x);
    point.leading = leading_of(input, levels, point.state.load_factor);
    point.leading_slope = leading_of(input, slopes, point.tangent.load_factor);
}

model::Step step_of(const fem::System& system, const PathPoint& point, double direction) {
    const model::Case& input = system.input();
    direction *= scale_of(point);
    const auto travelling = [direction](std::vector<double> slopes) {
        for (double& slope : slopes) slope *= direction;
        return slopes;
    };
    model::Step step;
    step.load_factor = point.state.load_factor;
    if (model::is_timed(input)) step.time_s = point.levels.time_s;
    step.pressure_Pa = point.leading;
    if (!input.loads.empty() && system.volumes().has_volume(0)) {
        step.volume_m3 = point.load_volumes_m3[0];
        step.tangent_volume = direction * point.load_volume_slopes[0];
    }
    if (input.loads.size() > 1) {
        step.pressures_Pa = point.pressures_Pa;
        step.tangent_pressures = travelling(point.pressure_slopes);
    }
    if (system.volumes().count() > 1) {
        step.volumes_m3 = point.volumes_m3;
        step.tangent_volumes = travelling(point.volume_slopes);
    }
    step.outputs = point.outputs;
    step.tangent_outputs = travelling(point.output_slopes);
    step.tangent_load_factor = direction * point.tangent.load_factor;
    step.tangent_pressure = direction * point.leading_slope;
    return step;
}

fem::StretchSummary read_stretches(fem::System& system, Vec x, model::Step& step) {
    const auto stretch = system.fields().stretches(x);
    step.stretch_p99 = stretch.p99;
    step.max_stretch = stretch.largest;
    step.min_jacobian = stretch.min_jacobian;
    step.extremes = {stretch.max_at_m, stretch.max_energy_J_m3};
    if (system.contact().has_friction()) step.friction_J = stretch.friction_J / system.input().model_fraction;
    return stretch;
}

void read_rubber(fem::System& system, const PathPoint& point, double direction, model::Step& step) {
    system.prescribe(point.levels);
    const fem::StretchSummary stretch = read_stretches(system, point.state.x, step);
    if (!system.has_energy()) return;
    const double whole = 1.0 / system.input().model_fraction;
    const double power =
        system.assembler().load_power(point.state.x, point.tangent.x, point.levels, point.level_slopes);
    step.energies = {whole * stretch.stored_energy_J, whole * point.load_work_J,
                     whole * direction * scale_of(point) * power};
    if (!system.internal().is_empty()) step.energies->dissipated_J = whole * stretch.dissipated_J;
}

void let_contact_rest(fem::System& system, const PathPoint& a, const PathPoint& b) {
    system.contact().set_resting(!a.touches && !b.touches && !system.contact().has_friction());
}

namespace {

bool moves_obstacle(const model::Case& input, const LoadLevels& change) {
    for (std::size_t i = 0; i < input.motions.size(); ++i)
        if (change.motions[i] != 0.0 && model::moves_obstacle(input, input.motions[i])) return true;
    return false;
}

/// Whether the body hardly moves with an obstacle at a point, compared with its motion between two points, as where it only just touches:
/// a tangent of the length of that motion would move the obstacle by orders of magnitude too far. The same where the body stands still
/// between the points, as where the obstacle slides along it.
bool is_at_rest(const model::Case& input, const PathPoint& point, double load_factors, double length) {
    constexpr double much_slower = 1e-2, rounding = 1e-8;
    return moves_obstacle(input, point.level_slopes) &&
           (length <= rounding * linalg::norm(point.state.x) ||
            linalg::norm(point.tangent.x) * std::abs(load_factors) <
                much_slower * length * std::abs(point.tangent.load_factor));
}

}  // namespace

double work_between(fem::System& system, const PathPoint& from, const PathPoint& to, FromTangent of_from) {
    const linalg::Vector change = linalg::duplicate(to.state.x), place = linalg::duplicate(to.state.x);
    const linalg::Vector velocity = linalg::duplicate(to.state.x);
    const linalg::Vector start = linalg::duplicate(to.state.x), end = linalg::duplicate(to.state.x);
    SOFT_PETSC(VecWAXPY(change, -1.0, from.state.x, to.state.x));
    const auto difference = [&](const LoadLevels& a, const LoadLevels& b) { return fem::moved(a, -1.0, b); };
    const LoadLevels turn = difference(to.levels, from.levels);
    const double length = linalg::norm(change);
    if (!(length > 0.0) && !moves_obstacle(system.input(), turn)) return 0;
    // Both tangents by one parameter from 0 to 1, of about constant speed, toward `to`; the levels use the same parameter.
    const auto scaled = [&](const PathPoint& point, Vec tangent) {
        const double size = linalg::norm(point.tangent.x);
        const double factor = size > 0.0 ? std::copysign(length / size, linalg::dot(point.tangent.x, change)) : 0.0;
        linalg::copy(point.tangent.x, tangent);
        SOFT_PETSC(VecScale(tangent, factor));
        return fem::moved(fem::no_loads(system.input()), factor, point.level_slopes);
    };
    const double load_factors = to.state.load_factor - from.state.load_factor;
    const bool knows_end = !is_at_rest(system.input(), to, load_factors, length),
               knows_start =
                   of_from == FromTangent::along_the_path && !is_at_rest(system.input(), from, load_factors, length);
    LoadLevels start_rate = turn, end_rate = turn;
    if (knows_start)
        start_rate = scaled(from, start);
    else
        linalg::copy(change, start);
    if (knows_end)
        end_rate = scaled(to, end);
    else
        linalg::copy(change, end);
    // Where one tangent is known, the parabola through both points that has it; where none is, the chord.
    const auto complete = [&](Vec known, const LoadLevels& known_rate, Vec other, LoadLevels& other_rate) {
        SOFT_PETSC(VecWAXPY(other, -1.0, known, change));
        linalg::add(other, 1.0, change);
        other_rate = difference(fem::moved(turn, 1.0, turn), known_rate);
    };
    if (knows_start && !knows_end) complete(start, start_rate, end, end_rate);
    if (knows_end && !knows_start) complete(end, end_rate, start, start_rate);
    const auto power_at = [&](double s) {  // on the cubic
        const double to_start = s * (1.0 - s) * (1.0 - s), to_end = s * s * (s - 1.0), way = s * s * (3.0 - 2.0 * s);
        const double by_start = (1.0 - s) * (1.0 - 3.0 * s), by_end = s * (3.0 * s - 2.0), speed = 6.0 * s * (1.0 - s);
        linalg::copy(from.state.x, place);
        SOFT_PETSC(VecZeroEntries(velocity));
        LoadLevels levels = from.levels, rate = fem::no_loads(system.input());
        for (const auto& [x, loads, share, slope] : {std::tuple{Vec(change), &turn, way, speed},
                                                     {Vec(start), &start_rate, to_start, by_start},
                                                     {Vec(end), &end_rate, to_end, by_end}}) {
            linalg::add(place, share, x);
            linalg::add(velocity, slope, x);
            levels = fem::moved(levels, share, *loads);
            rate = fem::moved(rate, slope, *loads);
        }
        return system.assembler().load_power(place, velocity, levels, rate);
    };
    double work = 0;
    for (const auto& [s, weight] : lobatto_points) work += weight * power_at(s);
    if (!std::isfinite(work))
        work = 0.5 * (power_at(0.0) + power_at(1.0));  // forces overflow inside of a far too long step
    system.prescribe(to.levels);
    return work;
}

RowState row_state(fem::System& system, const PathPoint& point, double direction, model::Step step) {
    auto fields = system.fields().gather(point.state.x);
    RowState row{std::move(step), std::move(fields.displacement_m),
                 system.fields().gather_displacements(point.tangent.x), std::move(fields.pressure_Pa),
                 point.state.pressures_Pa};
    for (double& component : row.tangent) component *= direction;
    return row;
}

}  // namespace soft::solver
