#include "fem/loads.hpp"

#include <algorithm>

#include "model/cavity_surface.hpp"

namespace soft::fem {

namespace {

PressureSurface make_pressure_surface(const Discretization& discretization, const model::PressureLoad& load) {
    const model::Case& input = discretization.input;
    PressureSurface surface{
        {}, on_unknowns(plug_force(input, load), discretization.dofs), load.shape == model::LoadShape::deformed};
    for (const auto& target : load.targets) {
        const auto cavity = std::ranges::find(input.cavities, target, &model::Cavity::name);
        const bool is_cavity = cavity != input.cavities.end();
        for (auto& facet :
             own_facets(discretization, is_cavity && load.sealed
                                            ? model::cavity_facets(input, *cavity)
                                            : model::facets_of(input.mesh, is_cavity ? cavity->wall : target)))
            surface.facets.push_back(std::move(facet));
    }
    return surface;
}

}  // namespace

Loads::Loads(const Discretization& discretization) {
    for (const auto& load : discretization.input.loads)
        pressures.push_back(make_pressure_surface(discretization, load));
    for (const auto& traction : discretization.input.tractions)
        tractions.push_back(discretization.make_vector(
            on_unknowns(face_force(discretization.input, traction.face, traction.traction_Pa), discretization.dofs)));
    for (const auto& force : discretization.input.body_forces)
        body_forces.push_back(discretization.make_vector(
            on_unknowns(body_force(discretization, force.acceleration_m_s2), discretization.dofs)));
}

void pressure_force(const Discretization& discretization, const PressureSurface& surface, const SurfaceCell& facet,
                    const std::vector<double>& x, std::vector<double>& force, std::vector<double>& stiffness) {
    force.assign(x.size(), 0.0);
    std::ranges::fill(stiffness, 0.0);
    if (surface.follows)
        model::pressure_force(*facet.reference, discretization.input.kinematics, x, force, stiffness);
    else
        model::pressure_force(*facet.reference, discretization.input.kinematics, facet.X, force, {});
}

}  // namespace soft::fem
