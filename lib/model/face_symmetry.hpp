#pragma once
/// How a face of the mesh and its mirror images make one face of the whole actuator. A plane of symmetry that the face meets,
/// without lying in it, mirrors the face onto itself: the whole face is twice as large. A face apart from the plane has an
/// image of its own, which is another face. Tested by assembly/reaction_test.
#include <array>
#include <string>

#include "model/case.hpp"

namespace soft::model {

/// What the mesh is of, as in Case.
struct Cuts {
    Kinematics kinematics;
    std::array<bool, 3> planes;
};

struct FaceSymmetry {
    bool of_revolution = false;
    std::array<bool, 3> mirrored{};  ///< at x, y, z = 0 onto itself
    double copies = 1;  ///< whole face over that of the mesh (a turn about the axis is in the mesh's own sums)
};
/// Throws Error (bad_input) for a face the mesh lacks.
[[nodiscard]] FaceSymmetry face_symmetry(const mesh::Mesh& mesh, const Cuts& cuts, const std::string& face);

/// The part of a direction along which forces on such a face do not cancel those on its image, and that of the axis about
/// which their moments do not. Of a body of revolution only x is left, of moments nothing.
[[nodiscard]] std::array<double, 3> uncancelled_force(const FaceSymmetry& face, std::array<double, 3> direction);
[[nodiscard]] std::array<double, 3> uncancelled_moment(const FaceSymmetry& face, std::array<double, 3> axis);

}  // namespace soft::model
