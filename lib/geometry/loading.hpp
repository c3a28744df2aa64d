#pragma once
/// Loads and outputs of the case on the faces of the mesh; directions given as words become vectors.
/// Private to the module. Tested by geometry/build_test, geometry/loading_test.
#include "design/design.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"

namespace soft::geometry {

/// A direction requested at a face.
struct DirectionRequest {
    std::string key;  ///< for errors: "outputs.elongation.along"
    std::string face;
    std::string along;  ///< axis | x | y | z | r | normal
};
/// Its unit vector. `normal` points out of the undeformed face, which must be flat.
[[nodiscard]] std::array<double, 3> direction_of(const DirectionRequest& request, const Body& body, const Solid& solid);

/// Throws Error(bad_input) at `location` if the mesh has no such face; lists the faces of the family that it has.
void require_face(const mesh::Mesh& mesh, const std::string& face, const std::string& location,
                  const design::FamilyKeys& keys);

struct Meshed {
    const design::FamilyKeys& keys;
    const Body& body;
    const Solid& solid;
};
/// Adds pressures, tractions, forces, gravity and prescribed motions. Call it after supports and cavities are set. Throws for weight
/// and forces that a symmetry plane would mirror, and for a component that is prescribed twice at a node.
void add_loads(model::Case& result, const design::Design& design, const Meshed& meshed);

/// Adds the outputs. Call it after supports and loads. Throws for a reaction at an unconstrained face and for one that the mirror
/// image of the face cancels.
void add_outputs(model::Case& result, const design::Design& design, const Meshed& meshed);

}  // namespace soft::geometry
