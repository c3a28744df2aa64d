#pragma once
/// Pressure loads and enclosed volumes on the assembled unknowns. The sign of pressure: positive inflates.
///
/// Force of a load per unit pressure: f = wall part (follower, fem/pressure_kernel.hpp) + plug part. A plug closes
/// an opening of a sealed cavity. Its thrust, pressure x undeformed area of the opening, is distributed uniformly over the
/// undeformed face around it: a constant vector whose work is the pressure times area times the face's mean displacement.
/// Without plug_thrust a fixture carries the plugs: the force is the wall part only, including the closed inner faces.
///
/// Enclosed volume [m^3] of the WHOLE actuator: wall and inner faces, openings closed by flat plugs (in solids a cone to the centre
/// of the rim; in a section nothing is added, because a flat plug contributes nothing to the integral of r^2 dx). The symmetry
/// planes pass through the origin, so they add nothing to 1/3 int x.n da.
/// Tested by fem/system_test.
#include <vector>

#include "fem/dof_map.hpp"
#include "fem/nodal_forces.hpp"
#include "fem/pressure_kernel.hpp"
#include "model/case.hpp"

namespace soft::fem {

/// A facet with its nodes, or a rim edge of an opening, ready for the kernels.
struct SurfaceCell {
    int reference = 0;  ///< index into SurfaceTables
    std::vector<mesh::Index> nodes;
    std::vector<PetscInt> dofs;  ///< component-major, negative for fixed and prescribed components
    std::vector<int> local;      ///< positions of their values in System's local copy; set by System
};

struct Rim {
    std::vector<SurfaceCell> edges;  ///< oriented with the normal out of the cavity
    std::vector<mesh::Index> nodes;  ///< each node once; their mean is the apex
    std::array<bool, 3> on_plane{};  ///< the rim is cut by the symmetry plane x, y, z = 0, so its apex lies on it
};

/// Reference tables of the facet types present.
class SurfaceTables {
public:
    [[nodiscard]] int index_of(mesh::CellType type);
    [[nodiscard]] const fem::ReferenceFacet& operator[](int index) const { return tables_[index]; }

private:
    std::vector<fem::ReferenceFacet> tables_;
};

/// One pressure load with the data of its force. Facets are those that this rank assembles.
struct LoadSurface {
    std::vector<SurfaceCell> facets;
    SparseVector plug_force;  ///< per unit pressure, whole mesh, the same on every rank
};

struct EnclosedVolume {
    std::vector<SurfaceCell> facets;  ///< this rank's
    std::vector<Rim> rims;            ///< evaluated by rank 0 only: rims are short
    double model_fraction = 1;
};

/// Facets of a face that this rank assembles. Throws Error (bad_input) for a face that the mesh does not have.
[[nodiscard]] std::vector<SurfaceCell> face_cells(const model::Case& input, const DofMap& map, const std::string& face,
                                                  int rank, SurfaceTables& tables);

[[nodiscard]] LoadSurface make_load_surface(const model::Case& input, const DofMap& map,
                                            const model::PressureLoad& load, int rank, SurfaceTables& tables);

/// The enclosed volume of one cavity.
[[nodiscard]] EnclosedVolume make_enclosed_volume(const model::Case& input, const DofMap& map,
                                                  const model::Cavity& cavity, int rank, SurfaceTables& tables);

}  // namespace soft::fem
