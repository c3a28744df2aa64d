#pragma once
/// Actuator families. Each family is one file (rod.cpp ... bellows.cpp) that declares the keys a design may use and builds the
/// body from their values. A new family needs one file and one line of catalogue.cpp.
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
#include "model/shape.hpp"

namespace soft::geometry {

/// What is meshed: the section of a body of revolution, the section (x, y) of a long body, or a solid (whole, half or quarter).
/// automatic: the family selects the half or the whole solid by the loads.
enum class Model { axisymmetric, plane_strain, solid, half, quarter, automatic };

/// The `model` of the design; throws values.refuse(...) for an unknown word.
[[nodiscard]] Model model_of(const design::Values& values);

struct Revolution {
    meshing::Sectors sectors;
};

/// A finished mesh, which is not swept. Only Body::supports are added to the supports of the design.
struct ReadyMesh {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
};

/// What prevents rigid-body motion of the solid where no symmetry plane does.
enum class Anchoring {
    supports,       ///< the design's supports
    middle_planes,  ///< for an unsupported body: nodes on its planes y = 0 and z = 0 stay in these planes
};

/// The body that a family builds from a set of values. SI units, whole actuator unless symmetry_planes cut the section.
struct Body {
    meshing::Section section;  ///< empty if there is an outline or a ReadyMesh
    meshing::Outline outline;  ///< instead of the section: any shape, meshed without a grid
    std::variant<Revolution, meshing::Extrusion, ReadyMesh> sweep;  ///< plane strain ignores an Extrusion
    std::vector<model::Cavity> cavities;
    std::array<double, 3> axis{1, 0, 0};    ///< `along: axis`, from the fixed to the moving face: positive is longer
    std::array<bool, 3> symmetry_planes{};  ///< cuts of the section or the extrusion (a revolution adds its own)
    double fraction = 1;                    ///< share of the actuator that remains after these cuts
    Anchoring anchoring = Anchoring::supports;
    /// Region name to material name (below `materials` of the design). A region that is not listed has the material of its own
    /// name, or else the main material.
    std::map<std::string, std::string> region_materials = {};
    double strip_rad =
        0;  ///< of a solid of revolution: angle of the sector about z < 0 whose cells form separate regions (strip.hpp)
    std::map<std::string, model::Shape::Winding> region_fibers = {};  ///< by region name
    std::optional<PartFigures> part = {};                             ///< of the surface file that was meshed
    std::vector<std::string> notes = {};                              ///< for the user: how the shape was interpreted
    std::vector<model::Support> supports;    ///< of the shape, in addition to symmetry planes and axis
    std::vector<std::string> warnings = {};  ///< for a mesh that is too coarse for the shape
};

struct Family {
    design::FamilyKeys keys;
    Body (*build)(const design::Values& values);  ///< throws values.refuse(...) for inconsistent values
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

/// Throws Error (bad_input) for an unknown name.
[[nodiscard]] const Family& family_of(const std::string& name);

/// The keys of all families, as design::read_design expects them.
[[nodiscard]] std::span<const design::FamilyKeys> catalogue_keys();

}  // namespace soft::geometry
