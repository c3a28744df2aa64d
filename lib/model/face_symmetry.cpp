#include "model/face_symmetry.hpp"

#include "core/error.hpp"

namespace soft::model {

FaceSymmetry face_symmetry(const mesh::Mesh& mesh, const ModelSymmetry& cuts, const std::string& face) {
    const auto set = mesh.facet_sets.find(face);
    if (set == mesh.facet_sets.end()) throw Error(ExitCode::bad_input, "mesh", "the mesh has no face '" + face + "'");
    FaceSymmetry symmetry;
    symmetry.of_revolution = cuts.kinematics == Kinematics::axisymmetric;
    for (std::size_t i = 0; i < 3; ++i) {
        bool meets = false, lies_in = true;
        for (const auto& facet : set->second)
            for (const auto node : mesh::facet_nodes(mesh, facet)) {
                const bool on_plane = mesh.point(node)[i] == 0.0;  // nodes on a symmetry plane are exactly at 0
                meets = meets || on_plane;
                lies_in = lies_in && on_plane;
            }
        symmetry.mirrored[i] = cuts.planes[i] && meets && !lies_in;
        if (symmetry.mirrored[i]) symmetry.copies *= 2;
    }
    return symmetry;
}

std::array<double, 3> uncancelled_force(const FaceSymmetry& face, std::array<double, 3> direction) {
    for (std::size_t i = 0; i < 3; ++i)
        if (face.mirrored[i] || (i > 0 && face.of_revolution)) direction[i] = 0;
    return direction;
}

std::array<double, 3> uncancelled_moment(const FaceSymmetry& face, std::array<double, 3> axis) {
    if (face.of_revolution) return {};
    // A moment is an axial vector: reflection keeps its component normal to the plane.
    for (std::size_t plane = 0; plane < 3; ++plane)
        for (std::size_t i = 0; i < 3; ++i)
            if (i != plane && face.mirrored[plane]) axis[i] = 0;
    return axis;
}

}  // namespace soft::model
