#pragma once
/// Loads and outputs of the case on the faces of the mesh; directions given as words become vectors.
/// Private to the module. Tested by geometry/build_test, geometry/loading_test.
#include <array>
#include <string>

#include "design/design.hpp"
#include "math/vector.hpp"
#include "model/case.hpp"
#include "model/shape.hpp"

namespace soft::geometry {

/// The inner faces of an unsupported body whose nodes stay on the planes y = 0 and z = 0; [0] is unused.
inline constexpr std::array<const char*, 3> middle_faces{"", "middle_y", "middle_z"};

/// What loads and outputs refer to.
struct Meshed {
    const design::FamilyKeys& keys;
    const mesh::Mesh& mesh;
    const model::Shape& shape;
};

/// Throws Error(bad_input) at `location` if the mesh has no such face, or no facet of it; lists the faces of the family that it has.
void require_face(const Meshed& meshed, const std::string& face, const std::string& location);

/// A direction requested at a face.
struct DirectionRequest {
    std::string key;  ///< for errors: "outputs.elongation.along"
    std::string face;
    std::string along;  ///< axis | x | y | z | r | normal
};
/// Its unit vector. `normal` points out of the undeformed face, which must be flat.
[[nodiscard]] Vector3 direction_of(const DirectionRequest& request, const Meshed& meshed);

/// "x", "y" or "z"; "r" for the second component of an axisymmetric model.
[[nodiscard]] const char* component_name(const Meshed& meshed, std::size_t component);

[[nodiscard]] bool is_obstacle(const model::Case& result, const std::string& name);
/// Every component is prescribed.
[[nodiscard]] model::Motion obstacle_motion(const design::Design::MotionRequest& request, const Meshed& meshed);
/// An output of an obstacle or of self-contact. A force across a symmetry plane is that on one of the obstacle and its mirror image; throws
/// where both are one.
[[nodiscard]] model::Output contact_output(const design::Design::OutputRequest& request, const Meshed& meshed,
                                           const model::Case& result, const design::Values& values);

/// Adds pressures, tractions, forces, gravity and prescribed motions. Call it after supports and cavities are set. Throws for weight
/// and forces that a symmetry plane would mirror, and for a component that is prescribed twice at a node.
void add_loads(model::Case& result, const design::Design& design, const Meshed& meshed);

/// Adds the outputs. Call it after supports and loads. Throws for a reaction at an unconstrained face and for one that the mirror
/// image of the face cancels.
void add_outputs(model::Case& result, const design::Design& design, const Meshed& meshed);

}  // namespace soft::geometry
