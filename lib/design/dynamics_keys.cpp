#include "design/dynamics_keys.hpp"

#include "core/text.hpp"
#include "design/materials.hpp"
#include "design/setting.hpp"

namespace soft::design {
namespace {

using model::Dynamics, model::Integrator;

constexpr const char *duration_path = "dynamics.duration", *integrator_path = "dynamics.integrator",
                     *radius_path = "dynamics.spectral_radius";
constexpr double min_hht_radius = 0.5;  // alpha = (1 - rho) / (1 + rho) <= 1/3

const Settings<Dynamics>& dynamics_settings() {
    static const Settings<Dynamics> settings{
        or_word("none", quantity("duration", &Dynamics::duration_s, Kind::time, above(0),
                                 "simulated time, starting from rest; none: a static path")),
        choice("integrator", &Dynamics::integrator,
               {{"generalized-alpha", Integrator::generalized_alpha},
                {"hht", Integrator::hht},
                {"newmark", Integrator::newmark},
                {"implicit-euler", Integrator::implicit_euler},
                {"ark4", Integrator::ark4},
                {"rosenbrock", Integrator::rosenbrock},
                {"heun", Integrator::heun},
                {"explicit-euler", Integrator::explicit_euler},
                {"central-difference", Integrator::central_difference}},
               "time integration scheme; heun, explicit-euler and central-difference are explicit"),
        or_word("auto", quantity("step", &Dynamics::step_s, Kind::time, above(0),
                                 "time step; auto: from accuracy, or the stable step of an explicit integrator")),
        number("accuracy", &Dynamics::accuracy, share,
               "target error of a step relative to the size of the motion, where step is auto"),
        number("spectral_radius", &Dynamics::spectral_radius, {0, 1},
               "spectral radius of generalized-alpha and hht at infinite frequency; 1: no numerical damping"),
        quantity("mass_damping", &Dynamics::mass_damping_1_s, Kind::rate, at_least(0),
                 "Rayleigh damping: coefficient of the mass matrix"),
        quantity(
            "stiffness_damping", &Dynamics::stiffness_damping_s, Kind::time, at_least(0),
            "Rayleigh damping: coefficient of the undeformed stiffness matrix; mixed cells: of the stiffness against "
            "changes of shape only"),
        count("rows", &Dynamics::rows, {1, 1e6}, "maximum number of stored steps")};
    return settings;
}

void check_unused(const Values& values) {
    for (const Key& key : dynamics_keys())
        // The default value is accepted, because every effective design contains it.
        if (key.path != duration_path && values.text(key.path) != key.fallback)
            throw values.refuse(key.path, "unused without a duration",
                                "add dynamics: {duration: 1 s}, or leave it out");
}

void check_path_keys(const DynamicParts& parts, const Values& values) {
    const std::string remedy = "leave it out, or leave out dynamics.duration";
    for (const Item& item : parts.items) {
        const std::string& path = item.key.path;
        if (path.starts_with("path.stages."))
            throw values.refuse(path, "a dynamic path has no stages",
                                "give the load a time_function, or leave out dynamics.duration");
        if (path.starts_with("path.until.") && path != "path.until.steps")
            throw values.refuse(path, "a dynamic path ends after its duration, or after steps", remedy);
    }
    for (const char* path : {"path.control", "path.controlled"})
        if (values.text(path) != (std::string_view{path} == "path.control" ? "auto" : "first"))
            throw values.refuse(path, "a dynamic path has no control", remedy);
    if (values.count("path.frequencies") > 0)
        throw values.refuse("path.frequencies", "a dynamic path has no natural frequencies, only a static path has",
                            remedy);
    if (values.text("path.branch") == "follow")
        throw values.refuse("path.branch", "a dynamic path has no branches: inertia determines the motion", remedy);
}

void check_loads(const DynamicParts& parts, const Values& values) {
    for (const LoadEntry& load : parts.loads) {
        if (load.form->kind == LoadKind::motion && load.form->target != LoadTarget::obstacle)
            throw values.refuse(load.value, "the displacement of a face is not supported in a dynamic analysis",
                                "load the face by a pressure or a traction, or move an obstacle");
        if (load.form->kind == LoadKind::gas && load.form->what != model::Prescription::pressure)
            throw values.refuse(
                load.value, "a dynamic path takes a pressure as its supply",
                "write pressure; with line: {resistance: 1e8 Pa.s/m^3} the cavity fills through a tube");
    }
}

void check_integrator(const Dynamics& dynamics, std::string_view formulation, const Values& values) {
    if (is_explicit(dynamics.integrator) && formulation == "mixed")
        throw values.refuse(
            integrator_path, "an explicit integrator has no equation for the pressure unknowns of mixed cells",
            "mesh: {formulation: displacement} or f-bar with a finite kappa, or an implicit integrator");
    if (dynamics.integrator == Integrator::hht && dynamics.spectral_radius < min_hht_radius)
        throw values.refuse(radius_path, "hht is unstable below " + core::rounded_text(min_hht_radius, 2),
                            "use a larger radius, or integrator: generalized-alpha");
}

}  // namespace

std::vector<Key> dynamics_keys() { return keys_of(dynamics_settings(), "dynamics"); }

bool is_dynamic(const Node& root) {
    const Node* duration = find_path(root, duration_path);
    return duration != nullptr && duration->kind == Node::Kind::scalar && core::trimmed(duration->text) != "none";
}

std::optional<model::Dynamics> dynamics_of(const DynamicParts& parts, const Values& values) {
    if (values.text(duration_path) == "none") {
        check_unused(values);
        return std::nullopt;
    }
    const Dynamics dynamics = read_settings(dynamics_settings(), values, "dynamics");
    require_density(values, duration_path);
    if (dynamics.step_s > dynamics.duration_s)
        throw values.refuse("dynamics.step", "a step longer than the duration", "use a shorter step, or auto");
    check_path_keys(parts, values);
    check_loads(parts, values);
    check_integrator(dynamics, parts.formulation, values);
    return dynamics;
}

}  // namespace soft::design
