#pragma once
/// A part of a surface file (STL, OBJ) or of a CAD file (STEP): its closed surface and what was found on reading it.
/// CAD is taken as triangles that turn by 5.6 degrees each (radii come out 0.1 % short at the middle of a triangle).
/// Held by geometry/part_test.
#include <filesystem>

#include "design/design.hpp"
#include "surface/body_walls.hpp"
#include "surface/named_faces.hpp"

namespace soft::geometry {

/// Whether a file of this name is a part: .stl, .obj, .step, .stp in upper or lower case.
[[nodiscard]] bool is_part_file(const std::filesystem::path& path);
[[nodiscard]] bool is_cad_file(const std::filesystem::path& path);

struct Part {
    surface::SoupOrigin origin;
    surface::BodySurface surface;
};
/// Lengths of STEP are what the file says; `unit` ("mm") and its length are of the others. Error(cannot_open); Error(bad_input) that
/// names the file for what surface/body_surface.hpp refuses, CAD without a volume or with several, and more than 2 million facets.
[[nodiscard]] Part read_part(const std::filesystem::path& path, const std::string& unit, double unit_m);

/// What a summary says of the file, to compare with the mesh.
struct PartFigures {
    std::string file;
    std::size_t facets = 0;
    double volume_m3 = 0;
    surface::WallFigures walls;
    std::vector<std::string> repairs;
};

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
[[nodiscard]] MeshedPart mesh_part(const Part& part, const design::Values& values);

}  // namespace soft::geometry
