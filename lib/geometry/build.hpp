#pragma once
/// Design -> case: family -> section -> model -> cells -> named faces, supports, cavities, loads and outputs.
/// Throws Error(bad_input) for values that do not fit together and for faces the chosen model does not have.
/// Tested by geometry/build_test.
#include "design/design.hpp"
#include "geometry/family.hpp"
#include "model/case.hpp"

namespace soft::geometry {

[[nodiscard]] model::Case build_case(const design::Design& design);

/// What the family refuses of the values, and too many cells, without a mesh. Families whose shape stands in a file are not
/// checked: that would take as long as the mesh.
void check_geometry(const design::Design& design);

/// The same, with what the file of an imported surface has in it, notes and the warnings of a coarse mesh.
struct Built {
    model::Case model;
    std::optional<PartFigures> part;
    std::vector<std::string> notes;  ///< how the shape was read
    std::vector<std::string> mesh_warnings;
};
[[nodiscard]] Built build_with_figures(const design::Design& design);

/// The design's warnings, and what only the case shows: a coarse mesh, first-order simplices that a file has brought, case_warnings.
[[nodiscard]] std::vector<std::string> warnings_of(const design::Design& design, const Built& built);

/// The mesh alone, with what the sweep made of it; build_case adds the physics.
struct Solid {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
    std::array<bool, 3> symmetry_planes;  ///< x, y, z = 0
    double fraction;                      ///< of the actuator in the mesh
};
[[nodiscard]] Solid mesh_body(const Body& body, const design::Values& values);

}  // namespace soft::geometry
