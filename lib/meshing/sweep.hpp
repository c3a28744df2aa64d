#pragma once
/// Section -> solid. Every node of a body of revolution lies on its exact circle.
/// Facet sets are swept too (sets on the axis vanish); cut planes become the sets symmetry_y and symmetry_z.
/// Tested by meshing/sweep_test.
#include <numbers>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// Share of the body of revolution: quarter: y >= 0 and z >= 0; half: y >= 0; full: closed.
enum class Turn { quarter, half, full };

inline constexpr double quarter_rad = 0.5 * std::numbers::pi;

/// Cells around the axis, from -z by y to z; the other half of a full turn is the mirror image.
struct Sectors {
    struct Part {
        double angle_rad;
        int cells;
    };
    std::vector<Part> lower, upper;  ///< of the quarter turns from -z to y and from y to z

    [[nodiscard]] static Sectors even(int per_quarter);
    [[nodiscard]] int cells(Turn turn) const;
};

/// Revolves the section (x, r) about x: y = r cos(angle), z = r sin(angle). Quadrilaterals become 27-node hexahedra, those
/// with an edge on the axis 18-node wedges; triangles off the axis become wedges, those on it tetrahedra, which
/// conform to the wedges only after these are split into simplices. Throws std::logic_error for a quadrilateral that meets the
/// axis in a corner only.
[[nodiscard]] mesh::Mesh revolve(const mesh::Mesh& section, Turn turn, const Sectors& sectors);

/// Extrudes the section from 0 to width_m: (x, z) along y, or (x, y) along z; the end planes get the given names.
struct Extrusion {
    enum class Along { y, z };
    double width_m = 0;
    int layers = 1;
    std::vector<std::string> low_faces;   ///< at 0
    std::vector<std::string> high_faces;  ///< at width_m
    Along along = Along::y;
};
[[nodiscard]] mesh::Mesh extrude(const mesh::Mesh& section, const Extrusion& extrusion);

/// Cell facets, including inner ones, on the plane where the given coordinate (0 x, 1 y, 2 z) is zero.
[[nodiscard]] std::vector<mesh::Facet> facets_on_plane(const mesh::Mesh& mesh, int component);

}  // namespace soft::meshing
