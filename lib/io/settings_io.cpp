#include "io/settings_io.hpp"

#include <array>
#include <string>

#include "io/columns.hpp"
#include "io/names.hpp"

namespace soft::io {
namespace {

using model::Dynamics, model::LinearSettings, model::SolverSettings;

/// Each table is used for writing and reading, so that the two cannot diverge.
template <class Settings>
struct NumberEntry {
    const char *name, *units, *description;
    double Settings::*member;
};
template <class Settings>
struct CountEntry {
    const char *name, *description;
    int Settings::*member;
};

constexpr std::array solver_numbers{
    NumberEntry<SolverSettings>{"residual_tolerance", "1", "residual norm relative to the size of the nodal forces",
                                &SolverSettings::residual_tolerance},
    NumberEntry<SolverSettings>{"first_step", "1", "fraction of the full load, in the linear response",
                                &SolverSettings::first_step},
    NumberEntry<SolverSettings>{"max_step", "1", "fraction of the path so far; 0: chosen by the solver",
                                &SolverSettings::max_step},
    NumberEntry<SolverSettings>{"min_step", "1", "fraction of the first step", &SolverSettings::min_step},
    NumberEntry<SolverSettings>{"step_accuracy", "1", "target relative error of the predictor",
                                &SolverSettings::step_accuracy},
};
constexpr std::array solver_counts{
    CountEntry<SolverSettings>{"newton_limit", "maximum Newton iterations per step", &SolverSettings::newton_limit},
    CountEntry<SolverSettings>{"threads", "threads per rank in the element loops", &SolverSettings::threads},
    CountEntry<SolverSettings>{"wanted_iterations", "target number of Newton iterations per step",
                               &SolverSettings::wanted_iterations},
    CountEntry<SolverSettings>{"step_limit", "maximum number of steps of the path", &SolverSettings::step_limit},
};
constexpr std::array linear_numbers{
    NumberEntry<LinearSettings>{"linear_tolerance", "1", "residual of a Krylov method relative to the right-hand side",
                                &LinearSettings::tolerance},
};
constexpr std::array linear_counts{
    CountEntry<LinearSettings>{"linear_limit", "maximum iterations of a Krylov method",
                               &LinearSettings::iteration_limit},
};
constexpr std::array dynamics_numbers{
    NumberEntry<Dynamics>{"duration", "s", "simulated time", &Dynamics::duration_s},
    NumberEntry<Dynamics>{"step", "s", "time step; 0: chosen by the solver", &Dynamics::step_s},
    NumberEntry<Dynamics>{"accuracy", "1", "target error per step relative to the size of the motion",
                          &Dynamics::accuracy},
    NumberEntry<Dynamics>{"spectral_radius", "1", "at infinite frequency; 1: no damping", &Dynamics::spectral_radius},
    NumberEntry<Dynamics>{"mass_damping", "1/s", "Rayleigh damping proportional to the mass",
                          &Dynamics::mass_damping_1_s},
    NumberEntry<Dynamics>{"stiffness_damping", "s", "Rayleigh damping proportional to the undeformed stiffness",
                          &Dynamics::stiffness_damping_s},
};
constexpr std::array dynamics_counts{
    CountEntry<Dynamics>{"rows", "maximum number of rows of the path", &Dynamics::rows},
};

template <class Settings, class Numbers, class Counts>
void write_values(hid_t group, const Settings& settings, const Numbers& numbers, const Counts& counts) {
    for (const auto& entry : numbers)
        write_number(group, {entry.name, entry.units, entry.description}, settings.*entry.member);
    for (const auto& entry : counts) write_count(group, {entry.name, "1", entry.description}, settings.*entry.member);
}

template <class Settings, class Numbers, class Counts>
void read_values(const GroupReader& group, Settings& settings, const Numbers& numbers, const Counts& counts) {
    for (const auto& entry : numbers) settings.*entry.member = group.number(entry.name);
    for (const auto& entry : counts) settings.*entry.member = group.int_count(entry.name, 1);
}

/// The names of a table for descriptions: "a | b | c".
template <class Enum, std::size_t count>
std::string words_of(const std::array<Named<Enum>, count>& table) {
    std::string text;
    for (const auto& entry : table) text.append(text.empty() ? "" : " | ").append(entry.name);
    return text;
}

template <class Enum, std::size_t count>
void write_word(hid_t group, const std::string& name, const std::array<Named<Enum>, count>& table, Enum value) {
    write_text(group, {name, "1", words_of(table)}, name_of(table, value));
}

void write_solver(hid_t control, const SolverSettings& solver) {
    const GroupHandle group = create_group(control, "solver", "methods, tolerances and limits");
    const hid_t id = group.get();
    write_values(id, solver, solver_numbers, solver_counts);
    write_values(id, solver.linear, linear_numbers, linear_counts);
    write_word(id, "newton", newton_names, solver.newton);
    write_word(id, "line_search", line_search_names, solver.line_search);
    write_word(id, "tangent", tangent_names, solver.tangent);
    write_word(id, "linear", linear_names, solver.linear.method);
    write_word(id, "preconditioner", preconditioner_names, solver.linear.preconditioner);
    write_word(id, "steps", step_rule_names, solver.steps);
    write_word(id, "predictor", predictor_names, solver.predictor);
    write_list(id, {"scaling", "1", "1: pressure unknowns are scaled to displacements"},
               std::vector{static_cast<std::uint8_t>(solver.scaling)});
}

SolverSettings read_solver(const GroupReader& group) {
    SolverSettings solver;
    read_values(group, solver, solver_numbers, solver_counts);
    read_values(group, solver.linear, linear_numbers, linear_counts);
    solver.newton = group.word("newton", newton_names);
    solver.line_search = group.word("line_search", line_search_names);
    solver.tangent = group.word("tangent", tangent_names);
    solver.linear.method = group.word("linear", linear_names);
    solver.linear.preconditioner = group.word("preconditioner", preconditioner_names);
    solver.steps = group.word("steps", step_rule_names);
    solver.predictor = group.word("predictor", predictor_names);
    solver.scaling = group.flags("scaling", {1})[0] == 1;
    return solver;
}

}  // namespace

void write_settings(hid_t control, const model::Case& model) {
    write_solver(control, model.solver);
    if (!model.dynamics) return;
    const GroupHandle group = create_group(control, "dynamics", "time integration; absent: a static path");
    write_values(group.get(), *model.dynamics, dynamics_numbers, dynamics_counts);
    write_word(group.get(), "integrator", integrator_names, model.dynamics->integrator);
}

void read_settings(const GroupReader& control, model::Case& model) {
    model.solver = read_solver(control.group("solver"));
    model.dynamics.reset();
    if (!control.has("dynamics")) return;
    const GroupReader group = control.group("dynamics");
    Dynamics& dynamics = model.dynamics.emplace();
    read_values(group, dynamics, dynamics_numbers, dynamics_counts);
    dynamics.integrator = group.word("integrator", integrator_names);
}

void write_time_functions(hid_t loads, const std::vector<model::TimeFunction>& time_functions) {
    const GroupHandle group =
        create_group(loads, "time_function", "time functions of the loads in a dynamic case, one row per load");
    const hid_t id = group.get();
    write_texts(id, {"kind", "1", words_of(time_function_names)}, column(time_functions, [](const auto& c) {
                    return std::string{name_of(time_function_names, c.kind)};
                }));
    write_list(id, {"rise", "s", "rise time of a ramp; 0: the whole duration"},
               column(time_functions, [](const auto& c) { return c.time_s; }));
    write_list(id, {"frequency", "1/s", "frequency of a sine"},
               column(time_functions, [](const auto& c) { return c.frequency_Hz; }));
    std::vector<std::int64_t> owners;
    std::vector<double> times, shares;
    for (std::size_t i = 0; i < time_functions.size(); ++i) {
        owners.insert(owners.end(), time_functions[i].times_s.size(), extent(i));
        times.insert(times.end(), time_functions[i].times_s.begin(), time_functions[i].times_s.end());
        shares.insert(shares.end(), time_functions[i].shares.begin(), time_functions[i].shares.end());
    }
    const GroupHandle table =
        create_group(id, "table", "points of the tables, one row each; the points of a load are consecutive");
    write_list(table.get(), {"load", "1", "row of kind"}, owners);
    write_list(table.get(), {"time", "s", "ascending within a load"}, times);
    write_list(table.get(), {"share", "1", "fraction of the full load"}, shares);
}

std::vector<model::TimeFunction> read_time_functions(const GroupReader& loads, std::int64_t count) {
    const GroupReader group = loads.group("time_function");
    const auto kinds = read_words(group, "kind", time_function_names, count);
    const auto rises = group.array<double>("rise", {count});
    const auto frequencies = group.array<double>("frequency", {count});
    std::vector<model::TimeFunction> time_functions;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        time_functions.push_back({kinds[i], rises[i], frequencies[i], {}, {}});
    const GroupReader table = group.group("table");
    const auto owners = table.array<std::int64_t>("load", {any});
    const auto times = table.array<double>("time", {extent(owners.size())});
    const auto shares = table.array<double>("share", {extent(owners.size())});
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (owners[i] < 0 || owners[i] >= count)
            throw table.refuse("load[" + std::to_string(i) + "]",
                               "load " + std::to_string(owners[i]) + " does not exist");
        model::TimeFunction& time_function = time_functions[static_cast<std::size_t>(owners[i])];
        time_function.times_s.push_back(times[i]);
        time_function.shares.push_back(shares[i]);
    }
    return time_functions;
}

}  // namespace soft::io
