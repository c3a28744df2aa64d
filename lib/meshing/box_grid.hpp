#pragma once
/// Bodies made of boxes, meshed by hexahedra on one grid. The sides of the boxes are the grid's planes; between neighbouring
/// planes the cells get shorter toward those planes on which a re-entrant edge of the body lies: the stress is singular there,
/// and even cells converge no faster than their size. Tested by meshing/box_grid_test.
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
    std::string face;   ///< of the cells that end there; empty: BoxBody::outside
    bool held = false;  ///< a held face is singular along its rim too: cells get shorter toward it
};

/// mirrored_in_y: the boxes lie in y >= 0 and are half of a body that is its own mirror image; the mesh is that of both halves.
enum class Extent { as_drawn, mirrored_in_y };

struct BoxBody {
    std::vector<Box> boxes;                          ///< each lies over those before it; what no box covers is outside
    std::array<std::array<Border, 2>, 3> borders{};  ///< [x, y, z][lowest, highest]
    std::string outside = "outer";                   ///< face toward the outside where no border says otherwise
    Extent extent = Extent::as_drawn;                ///< mirrored: the highest border in y is the lowest one too
};

struct Spacing {
    double size_m;  ///< wished length of a cell
    std::array<int, 3>
        least;  ///< cells between neighbouring planes along x, y, z, at least: through every wall, across every slot
    double grading;  ///< longest over shortest cell between two planes of which one or both have re-entrant edges
};

/// Lengths of the cells between two planes as shares of their distance; geometric, shortest at the sharp ends.
struct SharpEnds {
    bool low, high;
};
[[nodiscard]] std::vector<double> graded_shares(int cells, double grading, SharpEnds sharp);

/// What mesh_of_boxes would make, to be refused before memory is asked for.
[[nodiscard]] double cells_of_boxes(const BoxBody& body, const Spacing& spacing);

/// Second-order hexahedra.
[[nodiscard]] mesh::Mesh mesh_of_boxes(const BoxBody& body, const Spacing& spacing);

}  // namespace soft::meshing
