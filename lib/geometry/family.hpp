#pragma once
/// Actuator families: one file each (rod.cpp ... bellows.cpp) says which keys a design may use and builds the body from
/// their values. A new family is one file and one line of catalogue.cpp.
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "design/design.hpp"
#include "geometry/part.hpp"
#include "meshing/outline.hpp"
#include "meshing/section.hpp"
#include "meshing/sweep.hpp"
#include "model/case.hpp"

namespace soft::geometry {

/// What is meshed: the section of a body of revolution, the section (x, y) of a long body, or a solid (of which a half or
/// a quarter may be enough).
enum class Model { axisymmetric, plane_strain, solid, half, quarter };

/// The design's `model`; values.refuse(...) for an unknown word.
[[nodiscard]] Model model_of(const design::Values& values);

struct Revolution {
    int sectors_per_quarter;
};

/// A mesh that is there already: nothing is drawn or swept, and only `supports` hold what the design does not.
struct ReadyMesh {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
};

/// What keeps the solid from moving as a rigid body where no symmetry plane does.
enum class Anchoring {
    supports,       ///< the design's supports
    middle_planes,  ///< a body nobody holds: nodes on its planes y = 0 and z = 0 stay in these
};

/// A family's answer to a set of values. SI, whole actuator unless `section` is said to be cut.
struct Body {
    meshing::Section section;  ///< empty beside an outline or a ReadyMesh
    meshing::Outline outline;  ///< in place of the section: any shape, meshed without a grid
    std::variant<Revolution, meshing::Extrusion, ReadyMesh> sweep;  ///< an Extrusion is not used in plane strain
    std::vector<model::Cavity> cavities;
    std::array<double, 3> axis{1, 0, 0};  ///< `along: axis`, from the held to the moving face: positive is longer
    std::array<bool, 3>
        symmetry_planes{};  ///< cuts the section or the extrusion has already (not those of a revolution)
    double fraction = 1;    ///< of the actuator that remains after these cuts
    Anchoring anchoring = Anchoring::supports;
    /// Names of the materials of regions, those below `materials` of the design; a region that is not here is of the material
    /// of its own name, or of the main one.
    std::map<std::string, std::string> region_materials = {};
    double strip_rad =
        0;  ///< of a solid of revolution: cells within half of this of the side z < 0 are regions of their own (strip.hpp)
    struct Winding {
        model::Fibers fibers;                                      ///< about the axis x
        model::FiberFrame frame = model::FiberFrame::cylindrical;  ///< cartesian: in flat walls across z
    };
    std::map<std::string, Winding> region_fibers = {};  ///< by the region they lie in
    std::optional<PartFigures> part = {};               ///< of the file whose surface was meshed
    std::vector<std::string> notes = {};                ///< what the user should know of how the shape was read
    std::vector<model::Support> supports;               ///< that belong to the shape, besides symmetry planes and axis
    std::vector<std::string> warnings = {};             ///< of a mesh that is coarse for the shape
};

struct Family {
    design::FamilyKeys keys;
    Body (*build)(const design::Values& values);  ///< throws values.refuse(...) for values that do not fit together
};

[[nodiscard]] Family rod();
[[nodiscard]] Family plate();
[[nodiscard]] Family sphere();
[[nodiscard]] Family tube();
[[nodiscard]] Family fiber_tube();
[[nodiscard]] Family bellows();
[[nodiscard]] Family panel();
[[nodiscard]] Family ring();
[[nodiscard]] Family two_spheres();
[[nodiscard]] Family dome();
[[nodiscard]] Family pneunet();
[[nodiscard]] Family segment();
[[nodiscard]] Family revolved();
[[nodiscard]] Family extruded();
[[nodiscard]] Family imported();

/// All families, in the order of --list.
[[nodiscard]] std::span<const Family> catalogue();

/// Their keys alone, as design::read_design wants them.
[[nodiscard]] std::span<const design::FamilyKeys> catalogue_keys();

}  // namespace soft::geometry
