#pragma once
/// The section of a closed tube about x: two caps and the wall between them, in layers that run from end to end. Shared by
/// the families tube (one layer) and fiber-tube. Tested by geometry/family_test and geometry/fiber_tube_test.
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

/// All but name and summary: geometry.length, outer_radius, inner_radius, cap, and how a tube is held, loaded and meshed.
[[nodiscard]] design::FamilyKeys tube_keys();

/// Throws values.refuse(...) for values that do not fit together.
[[nodiscard]] TubeShape tube_shape(const design::Values& values);

struct WallLayer {
    double outer_m;  ///< outer radius; the inner one is that of the layer before, or of the cavity
    Division through;
    std::string region = "rubber";      ///< between the caps
    std::string cap_region = "rubber";  ///< where the layer runs through the caps
};

/// Of a section or a solid: the latter is meshed with longer cells.
[[nodiscard]] CellSize tube_cells(const TubeShape& shape, const design::Values& values);

/// Of a coarse mesh.
[[nodiscard]] std::vector<std::string> tube_warnings(const TubeShape& shape, const CellSize& size,
                                                     const Division& through);

/// From inside to outside; the last layer ends at shape.outer_m. Faces "fixed", "inlet", "cavity", "outer" and the axis.
[[nodiscard]] meshing::Section tube_section(const TubeShape& shape, const CellSize& size,
                                            std::span<const WallLayer> layers);

}  // namespace soft::geometry
