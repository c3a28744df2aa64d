#pragma once
/// Design -> case, in two steps: family -> section -> model -> cells, named faces and cavities (make_shape); then materials, supports,
/// loads and outputs (build_case).
/// Throws Error(bad_input) for inconsistent values and for faces that the chosen model does not have.
/// Tested by geometry/build_test, geometry/rebuild_test.
#include "design/design.hpp"
#include "geometry/family.hpp"
#include "geometry/obstacle.hpp"
#include "mesh/cell_map.hpp"
#include "model/case.hpp"
#include "model/shape.hpp"

namespace soft::geometry {

/// The shape of a design, meshed. `part`: properties of the imported surface file.
struct MeshedShape {
    mesh::Mesh mesh;
    model::Shape shape;
    std::optional<PartFigures> part;
    std::vector<std::string> notes;     ///< how the shape was interpreted
    std::vector<std::string> warnings;  ///< of a coarse mesh
};
[[nodiscard]] MeshedShape make_shape(const design::Design& design);

/// Materials, supports, loads, outputs and settings of the design on a mesh. Cheap compared with the mesh: mesh-gen calls it after
/// make_shape, and every program that reads a case calls it again.
[[nodiscard]] model::Case build_case(const design::Design& design, mesh::Mesh mesh, const model::Shape& shape);
/// make_shape and build_case.
[[nodiscard]] model::Case build_case(const design::Design& design);

/// Reads the effective design of a case file with overrides that do not change the mesh (design::read_built_design).
[[nodiscard]] design::Design read_built_design(const mesh::Mesh& mesh, const model::Shape& shape,
                                               std::string_view effective_yaml, std::string_view source,
                                               std::span<const design::Override> overrides);

/// The case of a case file: a model::CaseBuilder.
[[nodiscard]] model::Case rebuild_case(mesh::Mesh mesh, const model::Shape& shape, std::string_view effective_yaml,
                                       std::string_view source);

/// Checks the values and the number of cells without generating a mesh; throws like make_shape. Families that read their shape from
/// a file are not checked, because that would take as long as generating the mesh.
void check_geometry(const design::Design& design);

/// The results of make_shape and build_case; the mesh is in the case. Throws Error (bad_input) for an obstacle that overlaps the
/// undeformed actuator (refuse_overlaps), which build_case alone does not check.
struct Built {
    model::Case model;
    model::Shape shape;
    std::optional<PartFigures> part;
    std::vector<std::string> notes;
    std::vector<std::string> mesh_warnings;
    std::vector<ObstacleGap> gaps;  ///< of the obstacles
};
[[nodiscard]] Built build_with_figures(const design::Design& design);

/// The warnings of the design and those that need the case: coarse mesh, first-order simplices from a file, case_warnings, small obstacles.
[[nodiscard]] std::vector<std::string> warnings_of(const design::Design& design, const Built& built);

/// How the mesh of a case is measured: by area, or revolved.
[[nodiscard]] mesh::Measure measure_of(const model::Case& model);

/// The mesh after sweeping.
struct Solid {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
    std::array<bool, 3> symmetry_planes;  ///< x, y, z = 0
    double fraction;                      ///< share of the whole actuator that the mesh covers
};
[[nodiscard]] Solid mesh_body(const Body& body, const design::Values& values);

}  // namespace soft::geometry
