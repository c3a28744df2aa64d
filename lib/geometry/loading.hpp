#pragma once
/// What acts on the body and what is measured, on its faces: directions asked for in words become vectors.
/// Private to the module. Tested by geometry/build_test, geometry/loading_test.
#include "design/design.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"

namespace soft::geometry {

/// A direction asked for at a face.
struct Heading {
    std::string place;  ///< of the key, for errors: "outputs.elongation.along"
    std::string face;
    std::string along;  ///< axis | x | y | z | r | normal
};
/// Its unit vector; `normal` points out of the undeformed face and needs a flat one.
[[nodiscard]] std::array<double, 3> direction_of(const Heading& heading, const Body& body, const Solid& solid);

/// Error(bad_input) at `place`, with the faces of the family that the mesh has.
void require_face(const mesh::Mesh& mesh, const std::string& face, const std::string& place,
                  const design::FamilyKeys& keys);

struct Meshed {
    const design::FamilyKeys& keys;
    const Body& body;
    const Solid& solid;
};
/// Pressures, tractions, forces, gravity and prescribed motions, after supports and cavities. Refuses weight and forces that a
/// plane of symmetry would mirror, and a component that is prescribed twice at a node.
void add_loads(model::Case& result, const design::Design& design, const Meshed& meshed);

/// After supports and loads. Refuses a reaction of a face that nothing holds, or that its mirror image cancels.
void add_outputs(model::Case& result, const design::Design& design, const Meshed& meshed);

}  // namespace soft::geometry
