#pragma once
/// A plane section as people draw it: points, lines and circular arcs, and four-sided blocks between them. Plain data,
/// no mesher in it. Coordinates [m]: (x, r) for a body of revolution about x, (x, z) for a box that is drawn out along y, (x, y) for
/// plane strain and what is drawn out along z.
/// A curve carries its number of cells; blocks that share it agree by construction, and opposite sides of a block must
/// have equal numbers (checked). Tested by meshing/section_mesher_test.
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
    std::vector<std::string> faces;  ///< facet sets its edges belong to
    double grading = 1;              ///< length of the last cell over the first; geometric in between
    static constexpr int straight = -1;
};

/// Four sides, counter-clockwise; each a chain of point numbers whose neighbours are joined by a curve. A side starts
/// where the one before ends.
struct Block {
    std::array<std::vector<int>, 4> sides;
    std::string region = "rubber";  ///< of its cells; blocks of different regions are bonded where they share a curve
};

struct Section {
    std::vector<PlanePoint> points;
    std::vector<Curve> curves;
    std::vector<Block> blocks;
};

/// Names of the facet sets every family uses in the same way.
inline constexpr const char* axis_face = "axis";
inline constexpr const char* symmetry_x_face = "symmetry_x";
inline constexpr const char* symmetry_y_face = "symmetry_y";
inline constexpr const char* symmetry_z_face = "symmetry_z";

/// Each returns the number of what it added.
int add_point(Section& section, PlanePoint point);

struct Ends {
    int start;
    int end;
};
int add_line(Section& section, Ends ends, int cells, std::vector<std::string> faces = {});
int add_graded_line(Section& section, Ends ends, int cells, double grading, std::vector<std::string> faces = {});
int add_arc(Section& section, Ends ends, int centre, int cells, std::vector<std::string> faces = {});

/// The outline may run either way round (mirrored ends do); it is stored counter-clockwise.
int add_block(Section& section, std::array<std::vector<int>, 4> sides, std::string region = "rubber");

/// The curve between two neighbouring points of a chain; std::logic_error if no curve joins them.
[[nodiscard]] int curve_between(const Section& section, Ends ends);

/// Of all blocks.
[[nodiscard]] double cell_count(const Section& section);

/// Cells of nearly the wished size along a length, but no fewer than `least`.
[[nodiscard]] int divisions(double length_m, double size_m, int least = 1);

/// A rectangle with one block: corners from (0, low) to (length, high).
struct Rectangle {
    double length_m;
    double height_m;
    int cells_along;
    int cells_across;
    std::vector<std::string> bottom, right, top, left;  ///< faces of the four sides
};
[[nodiscard]] Section rectangle(const Rectangle& shape);

/// std::logic_error with the block's number if its sides do not join or opposite sides differ in cells.
void check(const Section& section);

}  // namespace soft::meshing
