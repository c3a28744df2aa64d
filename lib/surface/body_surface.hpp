#pragma once
/// The surface of a body as drawn elsewhere (STL, OBJ): read, repaired where that is safe, taken apart into shells. What is
/// left encloses a volume, or it is refused with its places in the file's unit.
///     repaired   points twice there (within 1e-7 of the extent), facets without area or twice there, facets and shells turned
///                inside out: what is outside and what is a cavity follows from how the shells lie in each other
///     refused    holes (number, place and length of the rim), edges with more than two facets, facets that cut each other,
///                several bodies
/// Tested by surface/body_surface_test.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::surface {

/// A closed sheet: the body's outside, "outer", or the wall of a closed cavity, "cavity" (several: "cavity_1", ... by x, y, z of
/// their lowest corners).
struct Shell {
    std::string name;
    double volume_m3 = 0;  ///< enclosed by the sheet, positive
    mesh::Point inside{};  ///< centre of its box, to say where it is [m]
};

struct BodySurface {
    std::vector<mesh::Point> points;            ///< [m]
    std::vector<std::array<int, 3>> triangles;  ///< normals out of the body
    std::vector<int> shell_of;                  ///< of each triangle
    std::vector<Shell> shells;                  ///< the outside first
    std::vector<std::string> repairs;           ///< "3 facets turned over"

    [[nodiscard]] double volume_m3() const;  ///< of the body
    [[nodiscard]] double area_m2() const;
    [[nodiscard]] double extent_m() const;  ///< longest side of its box
};

/// Points and facets as they stand in a file.
struct FacetSoup {
    std::vector<mesh::Point> points;
    std::vector<std::vector<std::size_t>> facets;
};

/// Longer files are refused unread; more than two million facets as ASCII STL.
inline constexpr std::size_t max_file = std::size_t{1} << 29;

/// STL (ASCII or binary) or OBJ by the ending, in upper or lower case. Error(cannot_open); Error(bad_input) for what is no such
/// file or holds no facets.
[[nodiscard]] FacetSoup read_soup(const std::filesystem::path& path);
/// The same of the content of a file called so.
[[nodiscard]] FacetSoup read_soup(std::string content, const std::filesystem::path& path);

/// Whether a file of this name is read as a surface.
[[nodiscard]] bool is_surface_file(const std::filesystem::path& path);

/// `name` and `unit` ("mm", or empty where it is not known; its length in m) are for the errors: "name: problem near x = 1 mm, ...; remedy".
struct SoupOrigin {
    std::string name;
    std::string unit = "mm";
    double unit_m = 1e-3;
};
[[nodiscard]] BodySurface body_surface(FacetSoup soup, const SoupOrigin& origin);

}  // namespace soft::surface
