#pragma once
/// A plane section of points, lines, circular arcs and four-sided blocks between them. Plain data; section_mesher.hpp meshes it.
/// Coordinates [m]: (x, r) for a body of revolution about x, (x, z) for extrusion along y, (x, y) for plane strain and extrusion
/// along z.
/// Each curve has a number of cells, so blocks that share it are conforming; opposite sides of a block must have equal numbers
/// (checked). Tested by meshing/section_mesher_test.
#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "meshing/plane_point.hpp"

namespace soft::meshing {

/// A straight line, or the circular arc (less than half a turn) about a centre point.
struct Curve {
    int start;
    int end;
    int centre;  ///< point number, or `straight`
    int cells;
    std::vector<std::string> faces;  ///< facet sets of its edges
    double grading = 1;              ///< ratio of the last cell length to the first; geometric in between
    static constexpr int straight = -1;
};

/// Four sides, counter-clockwise; each is a chain of point numbers whose neighbours are connected by a curve. A side starts at the
/// end of the previous one.
struct Block {
    std::array<std::vector<int>, 4> sides;
    /// Region of its cells. Blocks of different regions are bonded where they share a curve.
    std::string region = "rubber";
};

struct Section {
    std::vector<PlanePoint> points;
    std::vector<Curve> curves;
    std::vector<Block> blocks;
};

/// Names of facet sets with the same meaning in every family.
inline constexpr const char* axis_face = "axis";
inline constexpr const char* symmetry_x_face = "symmetry_x";
inline constexpr const char* symmetry_y_face = "symmetry_y";
inline constexpr const char* symmetry_z_face = "symmetry_z";

/// Each function returns the number of the added object.
int add_point(Section& section, PlanePoint point);

struct Ends {
    int start;
    int end;
};
int add_line(Section& section, Ends ends, int cells, std::vector<std::string> faces = {});
int add_graded_line(Section& section, Ends ends, int cells, double grading, std::vector<std::string> faces = {});
int add_arc(Section& section, Ends ends, int centre, int cells, std::vector<std::string> faces = {});

/// The sides may be in either orientation (mirrored ends are clockwise); the block is stored counter-clockwise.
int add_block(Section& section, std::array<std::vector<int>, 4> sides, std::string region = "rubber");

/// The curve between two neighbouring points of a chain; throws std::logic_error if there is none.
[[nodiscard]] int curve_between(const Section& section, Ends ends);

/// Number of cells of all blocks.
[[nodiscard]] double cell_count(const Section& section);

/// Number of cells of about the requested size along a length, at least `min_cells`.
[[nodiscard]] int divisions(double length_m, double size_m, int min_cells = 1);

/// A rectangle with one block: corners from (0, low) to (length, high).
struct Rectangle {
    double length_m;
    double height_m;
    int cells_along;
    int cells_across;
    std::vector<std::string> bottom, right, top, left;  ///< faces of the four sides
};
[[nodiscard]] Section rectangle(const Rectangle& shape);

/// A quarter of a ring about a point of the first axis, with one block.
struct QuarterRing {
    double inner_m, outer_m;
    int through;     ///< cells between the radii
    double grading;  ///< ratio of the outermost cell to the innermost
    int around;      ///< cells around the quarter turn
    /// Faces: on the first axis, at the outer radius, on the second axis, at the inner radius.
    std::string low, outer, high, inner;
    std::string region = "rubber";
    double origin_m = 0;  ///< first coordinate of the centre
    int sign = 1;         ///< -1: the ring lies at lower first coordinates
};
void add_quarter_ring(Section& section, const QuarterRing& ring);

/// Throws std::logic_error with the number of the block if its sides are not connected or opposite sides differ in cells.
void check(const Section& section);

}  // namespace soft::meshing
