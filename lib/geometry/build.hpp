#pragma once
/// Design -> case: family -> section -> model -> cells -> named faces, supports, cavities, loads and outputs.
/// Throws Error(bad_input) for values that do not fit together and for faces the chosen model does not have.
/// Held by geometry/build_test.
#include "design/design.hpp"
#include "geometry/family.hpp"
#include "model/case.hpp"

namespace soft::geometry {

[[nodiscard]] model::Case build_case(const design::Design& design);

/// The design's warnings, and what only the mesh of the case shows: first-order simplices that a file has brought.
[[nodiscard]] std::vector<std::string> warnings_of(const design::Design& design, const model::Case& built);

/// The mesh alone, with what the sweep made of it; build_case adds the physics.
struct Solid {
    mesh::Mesh mesh;
    model::Kinematics kinematics;
    std::array<bool, 3> symmetry_planes;   ///< x, y, z = 0
    double fraction;                       ///< of the actuator in the mesh
};
[[nodiscard]] Solid mesh_body(const Body& body, const design::Values& values);

/// A direction asked for at a face.
struct Heading {
    std::string place;   ///< of the key, for errors: "outputs.elongation.along"
    std::string face;
    std::string along;   ///< axis | x | y | z | r | normal
};
/// Its unit vector; `normal` points out of the undeformed face and needs a flat one.
[[nodiscard]] std::array<double, 3> direction_of(const Heading& heading, const Body& body, const Solid& solid);

}  // namespace soft::geometry
