#include "solve_changes.hpp"

#include "design/design.hpp"

namespace soft::cli {
namespace {

double scaled(double value, double factor) { return value * factor; }
std::optional<double> scaled(const std::optional<double>& value, double factor) {
    return value ? std::optional{*value * factor} : std::nullopt;
}

/// Keeps the loads listed in `changes` and scales each by its factor; `vector_of` is the member with the load vector.
template <class Load, class Vector>
void scale(std::vector<Load>& loads, const std::vector<design::ScaledLoad>& changes, Vector Load::*vector_of) {
    std::vector<Load> changed;
    for (const design::ScaledLoad& change : changes) {
        changed.push_back(loads.at(change.index));
        for (auto& component : changed.back().*vector_of) component = scaled(component, change.factor);
        if constexpr (requires(Load load) { load.time_function; }) changed.back().time_function = change.time_function;
    }
    loads = std::move(changed);
}

io::DesignText apply(const std::vector<design::Override>& overrides, const io::DesignText& design, model::Case& model) {
    design::SolveChanges changes = design::apply_overrides(design.effective_yaml, overrides);
    for (model::Material& material : model.materials) {  // names and fibres depend on the mesh and stay
        model::Material changed = changes.material;
        for (const auto& [name, other] : changes.materials)
            if (other.source == material.source) changed = other;
        changed.name = material.name;
        changed.fiber_frame = material.fiber_frame;
        changed.fibers = material.fibers;
        material = std::move(changed);
    }
    model.loads = std::move(changes.loads);
    scale(model.tractions, changes.tractions, &model::TractionLoad::traction_Pa);
    scale(model.body_forces, changes.body_forces, &model::BodyForce::acceleration_m_s2);
    scale(model.motions, changes.motions, &model::Motion::displacement_m);
    model.path = std::move(changes.path);
    model.solver = changes.solver;
    model.dynamics = changes.dynamics;
    return {design.family, std::move(changes.effective_yaml), design.overrides};
}

}  // namespace

std::optional<io::DesignText> apply_sets(const std::vector<std::string>& sets, io::CaseFile& file) {
    if (sets.empty()) return std::nullopt;
    std::vector<design::Override> overrides;
    for (const std::string& set : sets) overrides.push_back(design::parse_override(set));
    io::DesignText changed = apply(overrides, file.design, file.model);
    changed.overrides = sets;
    return changed;
}

}  // namespace soft::cli
