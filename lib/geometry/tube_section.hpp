#pragma once
/// Section of a closed tube about x: two caps and the wall between them, in layers along the whole length. Shared by the
/// families tube (one layer) and fiber-tube. Tested by geometry/family_test and geometry/fiber_tube_test.
#include <span>
#include <string>

#include "design/design.hpp"
#include "geometry/cell_size.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {

struct TubeShape {
    double length_m, outer_m, inner_m, cap_m;
    [[nodiscard]] double wall_m() const { return outer_m - inner_m; }
};

/// All keys except name and summary: geometry.length, outer_radius, inner_radius, cap, and the defaults for supports, loads and mesh.
[[nodiscard]] design::FamilyKeys tube_keys();

/// Throws values.refuse(...) for inconsistent values.
[[nodiscard]] TubeShape tube_shape(const design::Values& values);

struct WallLayer {
    double outer_m;  ///< outer radius; the inner radius is that of the previous layer, or of the cavity
    Division through;
    std::string region = "rubber";      ///< between the caps
    std::string cap_region = "rubber";  ///< where the layer passes through the caps
};

/// Cell size of a section or a solid; a solid has longer cells.
[[nodiscard]] CellSize tube_cells(const TubeShape& shape, const design::Values& values);

/// Warnings of a coarse mesh.
[[nodiscard]] std::vector<std::string> tube_warnings(const TubeShape& shape, const CellSize& size,
                                                     const Division& through);

/// `layers` are ordered from inside to outside; the last one ends at shape.outer_m. Faces: "fixed", "inlet", "cavity", "outer" and
/// the axis.
[[nodiscard]] meshing::Section tube_section(const TubeShape& shape, const CellSize& size,
                                            std::span<const WallLayer> layers);

}  // namespace soft::geometry
