#include "fem/loads.hpp"

#include <algorithm>

#include "model/cavity_surface.hpp"

namespace soft::fem {

namespace {

PressureSurface make_pressure_surface(const Discretization& fe, const model::PressureLoad& load) {
    const model::Case& input = fe.input;
    PressureSurface surface{
        {}, on_unknowns(plug_force(input, load), fe.dofs), load.shape == model::LoadShape::deformed};
    for (const auto& target : load.targets) {
        const auto cavity = std::ranges::find(input.cavities, target, &model::Cavity::name);
        const bool is_cavity = cavity != input.cavities.end();
        for (auto& facet :
             own_facets(fe, is_cavity && load.sealed ? model::cavity_facets(input, *cavity)
                                                     : model::facets_of(input.mesh, is_cavity ? cavity->wall : target)))
            surface.facets.push_back(std::move(facet));
    }
    return surface;
}

}  // namespace

Loads::Loads(const Discretization& fe) {
    for (const auto& load : fe.input.loads) pressures.push_back(make_pressure_surface(fe, load));
    for (const auto& load : fe.input.dead_loads)
        dead_loads.push_back(fe.make_vector(on_unknowns(dead_force(fe, load), fe.dofs)));
}

void pressure_force(const Discretization& fe, const PressureSurface& surface, const SurfaceCell& facet,
                    const std::vector<double>& x, std::vector<double>& force, std::vector<double>& stiffness) {
    force.assign(x.size(), 0.0);
    std::ranges::fill(stiffness, 0.0);
    if (surface.follows)
        model::pressure_force(*facet.reference, fe.input.kinematics, x, force, stiffness);
    else
        model::pressure_force(*facet.reference, fe.input.kinematics, facet.X, force, {});
}

}  // namespace soft::fem
