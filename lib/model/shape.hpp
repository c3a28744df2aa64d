#pragma once
/// What the shape of an actuator adds to its mesh. Mesh, shape and effective design determine the case (geometry::build_case), so the
/// case file contains these three. Plain data in SI units.
#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::model {

/// Dimension of the cells.
[[nodiscard]] constexpr int dimension_of(Kinematics kinematics) noexcept {
    return kinematics == Kinematics::solid ? 3 : 2;
}

struct Shape {
    /// Fibres that the family adds to a region; not those of the law.
    struct Winding {
        Fibers fibers;                               ///< angle from the axis x
        FiberFrame frame = FiberFrame::cylindrical;  ///< cartesian: in flat walls across z
    };

    Kinematics kinematics = Kinematics::solid;
    double model_fraction = 1;              ///< share of the whole actuator that the mesh covers
    std::array<bool, 3> symmetry_planes{};  ///< symmetry planes x = 0, y = 0, z = 0 at which the mesh is cut
    std::array<double, 3> axis{1, 0, 0};    ///< `along: axis`, from the fixed to the moving face: positive is longer
    std::vector<Support> supports;          ///< symmetry planes, axis, middle planes of an unsupported body
    std::vector<Cavity> cavities;
    /// Region name to material name (below `materials` of the design). A region that is not listed has the material of its own
    /// name, or else the main material.
    std::map<std::string, std::string> region_materials;
    std::map<std::string, Winding> region_fibers;  ///< by region name
    std::map<std::string, FacetedSurface>
        obstacles;  ///< the obstacles that are not a plane, cylinder, sphere or box, by name
};

/// The shape and the design with a smaller and a larger value of one number of the design, on a mesh of the same cells.
struct Variation {
    struct Side {
        std::vector<mesh::Point> points;
        Shape shape;
        std::string effective_yaml;
    };
    DesignParameter parameter;
    Side lower, higher;
};

/// Builds the case from the contents of a case file; `source` names the effective design in errors. Throws Error (bad_input).
/// The programs use geometry::rebuild_case.
using CaseBuilder =
    std::function<Case(mesh::Mesh mesh, const Shape& shape, std::string_view effective_yaml, std::string_view source)>;

}  // namespace soft::model
