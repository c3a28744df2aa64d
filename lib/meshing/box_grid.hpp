#pragma once
/// Bodies made of boxes, meshed with hexahedra on one grid. The sides of the boxes are the planes of the grid. Between neighbouring
/// planes the cells get shorter toward planes with a re-entrant edge of the body: the stress is singular there, and uniform cells
/// converge only linearly with their size. Tested by meshing/box_grid_test.
#include <array>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::meshing {

/// solid: `name` is the region of its cells; hollow: `name` is the face around it.
enum class Fill { solid, hollow };

struct Box {
    mesh::Point low, high;  ///< opposite corners [m]
    Fill fill;
    std::string name;
};

/// The lowest or highest plane of the grid across an axis.
struct Border {
    std::string face;    ///< face of the cells that end there; empty: BoxBody::outside
    bool fixed = false;  ///< the stress at the rim of a fixed face is singular too: cells get shorter toward it
};

/// mirrored_in_y: the boxes lie in y >= 0 and are half of a symmetric body; the mesh contains both halves.
enum class Extent { as_drawn, mirrored_in_y };

struct BoxBody {
    std::vector<Box> boxes;                          ///< each overrides those before it; space without a box is outside
    std::array<std::array<Border, 2>, 3> borders{};  ///< [x, y, z][lowest, highest]
    std::string outside = "outer";                   ///< face toward the outside where no border defines one
    Extent extent = Extent::as_drawn;                ///< mirrored: the highest border in y is also the lowest one
};

struct Spacing {
    double size_m;                 ///< requested length of a cell
    std::array<int, 3> min_cells;  ///< between neighbouring planes along x, y, z: through every wall, across every slot
    double grading;                ///< ratio of longest to shortest cell if one or both planes have re-entrant edges
    /// 0: the number of cells between two planes follows from size_m, and their lengths from the grading. Otherwise the cells begin
    /// with size_m / grading at a re-entrant edge and become longer by this factor from one to the next, up to size_m; `min_cells` of them
    /// between planes that are closer than `stretch` times the shortest, `one_sided_stretch` if only one has re-entrant edges.
    double growth = 0;
    double stretch = 1, one_sided_stretch = 1;
};

/// Whether the planes at both ends of a distance have re-entrant edges.
struct SharpEnds {
    bool low, high;
};
/// Cell lengths between two planes relative to their distance: a geometric series, shortest at the sharp ends.
[[nodiscard]] std::vector<double> graded_shares(int cells, double grading, SharpEnds sharp);
/// The same with Spacing::growth.
[[nodiscard]] std::vector<double> growing_shares(double length_m, int min_cells, const Spacing& spacing,
                                                 SharpEnds sharp);

/// Number of cells that mesh_of_boxes would generate, for a check before memory is allocated.
[[nodiscard]] double cells_of_boxes(const BoxBody& body, const Spacing& spacing);

/// Mesh of second-order hexahedra.
[[nodiscard]] mesh::Mesh mesh_of_boxes(const BoxBody& body, const Spacing& spacing);

}  // namespace soft::meshing
