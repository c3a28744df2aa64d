#pragma once
/// A part from a surface or CAD file as the design describes it: faces named by rules, cut at symmetry planes, filled with cells.
/// Tested by geometry/part_test.
#include "design/design.hpp"
#include "meshing/body_walls.hpp"
#include "meshing/named_faces.hpp"
#include "meshing/part_file.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {

/// Properties of the file, for comparison with the mesh in a summary.
struct PartFigures {
    std::string file;
    std::size_t facets = 0;
    double volume_m3 = 0;
    meshing::WallStatistics walls;
    std::vector<std::string> repairs;
};

/// Faces at the planes x, y, z = 0 at which a part is cut.
inline constexpr std::array<const char*, 3> symmetry_faces{meshing::symmetry_x_face, meshing::symmetry_y_face,
                                                           meshing::symmetry_z_face};

/// Length of a choice of geometry.unit [m]. Throws Error(usage) for another word.
[[nodiscard]] double file_unit_m(const std::string& unit);

/// The rules below geometry.faces of the design. Throws values.refuse(...) for invalid rules.
[[nodiscard]] std::vector<meshing::FaceRule> face_rules(const design::Values& values);

/// geometry.symmetry: the planes x, y, z = 0 at which the part or mesh of the file is cut.
[[nodiscard]] std::array<bool, 3> cuts(const design::Values& values);

/// Names the facets of a mesh file in these planes symmetry_x_face, ... and moves their nodes onto the plane. Throws values.refuse(...) for a
/// plane that has none, or that the mesh crosses.
void name_cuts(mesh::Mesh& mesh, const design::Values& values);

/// The mesh of a part with its faces as facet sets. Cuts are separate faces (symmetry_x_face, ...), whose nodes lie exactly on the
/// plane. Throws values.refuse(...) for faces without a facet.
struct MeshedPart {
    mesh::Mesh mesh;
    PartFigures figures;
    std::vector<std::string> cavities;  ///< closed cavities; their walls are faces of the same names
};
[[nodiscard]] MeshedPart mesh_part(const meshing::Part& part, const design::Values& values);

}  // namespace soft::geometry
