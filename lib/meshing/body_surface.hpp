#pragma once
/// Surface of a body from a file of another program (STL, OBJ): reads it, repairs it where that is safe and splits it into shells.
/// The result encloses a volume; otherwise an error reports the location of the defect in the unit of the file.
///     repaired   duplicate points (within 1e-7 of the extent), degenerate or duplicate facets, wrong orientation of facets and
///                shells: the nesting of the shells determines which one is the outside and which ones are cavities
///     refused    holes (number, location and length of the rim), edges shared by more than two facets, facets that intersect,
///                several bodies
/// Tested by meshing/body_surface_test.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "math/vector.hpp"
#include "mesh/mesh.hpp"

namespace soft::meshing {

/// A closed component of the surface: the outside of the body, "outer", or the wall of a closed cavity, "cavity" (several cavities:
/// "cavity_1", ... ordered by x, y, z of the lowest corners of their bounding boxes).
struct Shell {
    std::string name;
    double volume_m3 = 0;  ///< enclosed by the shell, positive
    mesh::Point inside{};  ///< centre of its bounding box, for messages [m]
};

struct TriangleGeometry {
    Vector3 normal{};  ///< unit; zero for a degenerate triangle
    double area = 0;
    mesh::Point centre{};
};
[[nodiscard]] TriangleGeometry triangle_geometry(const std::vector<mesh::Point>& points, const std::array<int, 3>& t);

struct BodySurface {
    std::vector<mesh::Point> points;            ///< [m]
    std::vector<std::array<int, 3>> triangles;  ///< normals out of the body
    std::vector<int> shell_of;                  ///< of each triangle
    std::vector<Shell> shells;                  ///< the outside first
    std::vector<std::string> repairs;           ///< "3 facets reoriented"

    [[nodiscard]] double volume_m3() const;  ///< of the body
    [[nodiscard]] double area_m2() const;
    [[nodiscard]] double extent_m() const;  ///< longest side of the bounding box
};

/// Points and facets as stored in a file, without connectivity ("polygon soup").
struct FacetSoup {
    std::vector<mesh::Point> points;
    std::vector<std::vector<std::size_t>> facets;
};

/// Maximum size of a file [bytes]: more than two million facets in ASCII STL. Larger files are refused without being read.
inline constexpr std::size_t max_file = std::size_t{1} << 29;

/// Reads STL (ASCII or binary) or OBJ; the extension, in upper or lower case, selects the format. Error(cannot_open);
/// Error(bad_input) for an invalid file or one without facets.
[[nodiscard]] FacetSoup read_soup(const std::filesystem::path& path);
/// The same for the content of a file named `path`.
[[nodiscard]] FacetSoup read_soup(std::string content, const std::filesystem::path& path);

/// Whether the extension is one that read_soup accepts.
[[nodiscard]] bool is_surface_file(const std::filesystem::path& path);

/// `name` and `unit` ("mm", or empty if unknown) appear in errors: "name: problem near x = 1 mm, ...; remedy". `unit_m` is the length
/// of the unit in metres.
struct SoupOrigin {
    std::string name;
    std::string unit = "mm";
    double unit_m = 1e-3;
};
[[nodiscard]] BodySurface body_surface(FacetSoup soup, const SoupOrigin& origin);

}  // namespace soft::meshing
