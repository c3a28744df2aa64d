#pragma once
/// Relation between a face of the mesh and the face of the whole actuator. If a face touches a symmetry plane without lying in it,
/// the face and its mirror image form one face that is twice as large. If it does not touch the plane, its mirror image is a
/// separate face. Tested by fem/reaction_test.
#include <array>
#include <string>

#include "model/case.hpp"

namespace soft::model {

/// Kinematics and symmetry planes of the case.
struct ModelSymmetry {
    Kinematics kinematics;
    std::array<bool, 3> planes;
};

struct FaceSymmetry {
    bool of_revolution = false;
    std::array<bool, 3> mirrored{};  ///< the face continues across x, y, z = 0
    /// Area of the whole face divided by that in the mesh (axisymmetric integrals already include 2 pi r).
    double copies = 1;
};
/// Throws Error (bad_input) for a face that is not in the mesh.
[[nodiscard]] FaceSymmetry face_symmetry(const mesh::Mesh& mesh, const ModelSymmetry& cuts, const std::string& face);

/// The component of a direction along which forces on the face and on its mirror image do not cancel, and the component of an axis
/// about which their moments do not cancel. In axisymmetric cases only forces along x remain, and no moments.
[[nodiscard]] std::array<double, 3> uncancelled_force(const FaceSymmetry& face, std::array<double, 3> direction);
[[nodiscard]] std::array<double, 3> uncancelled_moment(const FaceSymmetry& face, std::array<double, 3> axis);

}  // namespace soft::model
