#pragma once
/// Number of cells along the dimensions of a family. If the design states mesh.size, this is the target edge length everywhere.
/// Otherwise the length follows from the shape (each family defines its own) and from mesh.quality, so that a part has the same
/// mesh at every scale. Tested by geometry/scale_test.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "meshing/sweep.hpp"

namespace soft::geometry {

/// Number of cells and ratio of the last cell length to the first; lengths vary geometrically in between.
struct Division {
    int cells;
    double grading = 1;
};

class CellSize {
public:
    /// `own_m` is the length of the family for mesh.quality normal. Throws values.refuse(...) if both size and quality are stated.
    CellSize(const design::Values& values, double own_m);

    [[nodiscard]] double length_m() const { return length_m_; }
    [[nodiscard]] bool is_stated() const { return stated_; }  ///< by mesh.size
    [[nodiscard]] bool is_through_stated() const;             ///< mesh.through_wall

    /// Cells along a length. `min_cells` applies to the quality normal and is scaled with the quality.
    [[nodiscard]] int along(double length_m, int min_cells = 1) const;

    /// Cells through a wall: mesh.through_wall if stated, else from mesh.size if stated, else `own`, which applies to the quality
    /// normal. With `own` = 0 the number follows from the cell length in both cases.
    [[nodiscard]] int through(double wall_m, int own, int min_cells = 1) const;

    /// Cells through the wall of a ring or a shell between two radii. The strain of an inflated wall varies with powers of the
    /// radius. Without mesh.size the cells therefore grow with the radius, with a fixed number per doubling of the radius.
    [[nodiscard]] Division through_ring(double inner_m, double outer_m) const;

    /// One warning if cells are so coarse that the error of the curve exceeds about 1 %; both limits are measured for each family.
    /// `max_ratio` is the largest admissible length over that of the quality normal.
    [[nodiscard]] std::vector<std::string> too_long(double max_ratio) const;
    [[nodiscard]] std::vector<std::string> too_few(int through, int min_cells) const;

private:
    const design::Values& values_;
    double own_m_, length_m_, factor_;
    bool stated_;
};

/// Length of the innermost cell of a ring over its inner radius. This ratio governs the error of an inflated ring or shell.
[[nodiscard]] double innermost_cell(double inner_m, double outer_m, const Division& through);

/// CellSize::too_few for a ring or shell whose innermost cell may be at most `max_ratio` times the inner radius.
[[nodiscard]] std::vector<std::string> too_few_through_ring(const CellSize& size, double inner_m, double outer_m,
                                                            const Division& through, double max_ratio);
/// Measured ratios with an error of 1 %: 1.05 for spheres inflated to eight times their volume, 1.7 for long cylinders inflated to
/// four times.
inline constexpr double max_innermost_sphere = 1.05, max_innermost_cylinder = 1.7;

/// Around a quarter turn mesh.sectors cells if stated; else 5 (draft 3, fine 8). The edges of a strip lie between cells: with one, its
/// half and the rest of the two quarter turns have cells of equal angles each, no larger than stated, else at most 29 degrees (fine 10).
[[nodiscard]] meshing::Sectors sectors(const design::Values& values);

/// Decay length of edge bending in a shell, sqrt(radius * thickness), up to a factor near 1.
[[nodiscard]] double bending_length(double radius_m, double thickness_m);

/// Cell length around a ring or a shell between two radii.
[[nodiscard]] double ring_cell_m(double inner_m, double outer_m);

/// Cells per cell of the quality normal along any length: draft 0.5, normal 1, fine 1.5.
[[nodiscard]] double quality_factor(const design::Values& values);
/// Scales a number of cells for the quality normal to the stated quality; at least 1.
[[nodiscard]] int scaled_count(const design::Values& values, int normal);

}  // namespace soft::geometry
