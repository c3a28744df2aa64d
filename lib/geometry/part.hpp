#pragma once
/// A part of a surface or CAD file as a design asks for it: its faces named by rules, cut at planes of symmetry, filled with cells.
/// Tested by geometry/part_test.
#include "design/design.hpp"
#include "meshing/part_file.hpp"
#include "surface/body_walls.hpp"
#include "surface/named_faces.hpp"

namespace soft::geometry {

/// What a summary says of the file, to compare with the mesh.
struct PartFigures {
    std::string file;
    std::size_t facets = 0;
    double volume_m3 = 0;
    surface::WallFigures walls;
    std::vector<std::string> repairs;
};

/// Length of a choice of geometry.unit [m]. Error(usage) for another word.
[[nodiscard]] double file_unit_m(const std::string& unit);

/// Below geometry.faces of the design. values.refuse(...) for rules that make no sense.
[[nodiscard]] std::vector<surface::FaceRule> face_rules(const design::Values& values);

/// geometry.symmetry: the planes x, y, z = 0 at which the part of the file is cut.
[[nodiscard]] std::array<bool, 3> cuts(const design::Values& values);

/// The mesh of a part, its faces as facet sets; the cuts are faces of their own (symmetry_x_face, ...), with nodes on the plane. values.refuse(...) for faces that no facet belongs to.
struct MeshedPart {
    mesh::Mesh mesh;
    PartFigures figures;
    std::vector<std::string> cavities;  ///< closed ones, faces of the same names
};
[[nodiscard]] MeshedPart mesh_part(const meshing::Part& part, const design::Values& values);

}  // namespace soft::geometry
