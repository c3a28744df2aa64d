#pragma once
/// How many cells a family makes along its lengths. mesh.size, where the design states it, is the target edge length everywhere.
/// Without it the length follows from the shape (each family states its own) and from mesh.quality, so that a part has the same
/// mesh in every scale. Tested by geometry/scale_test.
#include <string>
#include <vector>

#include "design/design.hpp"

namespace soft::geometry {

/// Number of cells and ratio of the last cell's length to the first one's, geometric in between.
struct Division {
    int cells;
    double grading = 1;
};

class CellSize {
public:
    /// `own_m` is the family's length for mesh.quality normal. values.refuse(...) where both size and quality are stated.
    CellSize(const design::Values& values, double own_m);

    [[nodiscard]] double length_m() const { return length_m_; }
    [[nodiscard]] bool is_stated() const { return stated_; }  ///< by mesh.size

    /// `least` holds for the quality normal.
    [[nodiscard]] int along(double length_m, int least = 1) const;

    /// Cells through a wall: mesh.through_wall where it is stated; else by mesh.size; else `own`, which holds for the quality
    /// normal. With `own` = 0 by the length in both cases.
    [[nodiscard]] int through(double wall_m, int own, int least = 1) const;

    /// Through the wall of a ring or a shell between two radii. Where it is inflated, the strain changes by powers of the radius:
    /// without mesh.size the cells grow with the radius, with a number for each doubling of it.
    [[nodiscard]] Division through_ring(double inner_m, double outer_m) const;

    /// One line where cells are so coarse that the curve misses more than about 1 %; both limits are measured for each family.
    /// `most` is the largest length over that of the quality normal.
    [[nodiscard]] std::vector<std::string> too_long(double most) const;
    [[nodiscard]] std::vector<std::string> too_few(int through, int least) const;

private:
    const design::Values& values_;
    double own_m_, length_m_, factor_;
    bool stated_;
};

/// Length of the innermost cell of a ring over its inner radius: what the error of an inflated ring or shell goes by.
[[nodiscard]] double innermost_cell(double inner_m, double outer_m, const Division& through);

/// CellSize::too_few for a ring or shell whose innermost cell is to be at most `most` of the inner radius.
[[nodiscard]] std::vector<std::string> too_few_through_ring(const CellSize& size, double inner_m, double outer_m,
                                                            const Division& through, double most);
/// Measured: 1 % at 1.05 for spheres, which are inflated to eight volumes, at 1.7 for long cylinders, to four.
inline constexpr double most_of_sphere = 1.05, most_of_cylinder = 1.7;

/// mesh.sectors: 5, or 3 and 8 by mesh.quality; where the body has a strip, whose edges must lie between cells, 5 or a multiple of it.
[[nodiscard]] int sectors(const design::Values& values);

/// Length within which the bending of a shell of a radius and a thickness dies away, but for a factor near 1.
[[nodiscard]] double bending_length(double radius_m, double thickness_m);

/// Length of the cells along a quarter turn of a ring or a shell between two radii.
[[nodiscard]] double ring_cell_m(double inner_m, double outer_m);

/// Cells per cell of the quality normal along any length: draft 0.5, normal 1, fine 1.5.
[[nodiscard]] double quality_factor(const design::Values& values);
/// A number of cells that holds for the quality normal, at the stated one; 1 at least.
[[nodiscard]] int scaled_count(const design::Values& values, int normal);

}  // namespace soft::geometry
