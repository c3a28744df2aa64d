#pragma once
/// The loads of a case at unit level. The sign of pressure: positive inflates.
///
/// Force of a pressure load per unit pressure: f = wall part (follower, model/facet_integrals.hpp) + plug part. A plug closes
/// an opening of a sealed cavity. Its thrust, pressure x undeformed area of the opening, is distributed uniformly over the
/// undeformed face around it: a constant vector whose work is the pressure times area times the face's mean displacement.
/// Without plug_thrust a fixture carries the plugs: the force is the wall part only, including the closed inner faces.
/// Tested by fem/system_test, fem/loads_test.
#include <vector>

#include "fem/nodal_forces.hpp"
#include "fem/surface_cell.hpp"

namespace soft::fem {

struct PressureSurface {
    std::vector<SurfaceCell> facets;  ///< those that this rank assembles
    SparseVector plug_force;          ///< per unit pressure, whole mesh, the same on every rank
    bool follows = true;              ///< acts on the deformed shape
};

struct Loads {
    explicit Loads(const Discretization& fe);

    std::vector<PressureSurface> pressures;  ///< by Case::loads
    std::vector<linalg::Vector> dead_loads;  ///< at level 1, by Case::dead_loads
};

/// Force per unit pressure on a facet at positions x, and its derivative by x where `stiffness` is not empty; both are overwritten.
/// A load on the undeformed shape has no derivative.
void pressure_force(const Discretization& fe, const PressureSurface& surface, const SurfaceCell& facet,
                    const std::vector<double>& x, std::vector<double>& force, std::vector<double>& stiffness);

}  // namespace soft::fem
