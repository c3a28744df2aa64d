#pragma once
/// Design -> case: family -> section -> model -> cells -> named faces, supports, cavities, loads and outputs.
/// Throws Error(bad_input) for inconsistent values and for faces that the chosen model does not have.
/// Tested by geometry/build_test.
#include "design/design.hpp"
#include "geometry/family.hpp"
#include "model/case.hpp"

namespace soft::geometry {

[[nodiscard]] model::Case build_case(const design::Design& design);

/// Checks the values and the number of cells without generating a mesh; throws like build_case. Families that read their shape from
/// a file are not checked, because that would take as long as generating the mesh.
void check_geometry(const design::Design& design);

/// The case with the properties of the imported surface file, notes, and warnings of a coarse mesh.
struct Built {
    model::Case model;
    std::optional<PartFigures> part;
    std::vector<std::string> notes;  ///< how the shape was interpreted
    std::vector<std::string> mesh_warnings;
};
[[nodiscard]] Built build_with_figures(const design::Design& design);

/// The warnings of the design and those that need the case: coarse mesh, first-order simplices from a file, case_warnings.
[[nodiscard]] std::vector<std::string> warnings_of(const design::Design& design, const Built& built);

/// The mesh after sweeping, without physics; build_case adds these.
struct Solid {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
    std::array<bool, 3> symmetry_planes;  ///< x, y, z = 0
    double fraction;                      ///< share of the whole actuator that the mesh covers
};
[[nodiscard]] Solid mesh_body(const Body& body, const design::Values& values);

}  // namespace soft::geometry
