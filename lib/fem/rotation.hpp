#pragma once
/// Rotation of faces: the outputs `bend` and `twist` (model::Measure), with their derivatives by node positions.
///   bend: the vector area A = int n da of a deformed face gives its mean normal; the angle is that from -A(reference)
///         to A(face) about the axis, in the plane perpendicular to it;
///   twist: atan2(sum w (X x x).e, sum w X.x), X and x projected perpendicular to the axis e, w = int N_a dA: exact for a rigid
///         rotation by any angle, a least-squares fit for a deformed face.
/// A face that continues across a symmetry plane (model::face_symmetry) is measured with its mirror image.
/// Angles in (-pi, pi]; for a section in plane strain, per metre of depth, about z. Derived here. Tested by fem/loads_test.
#include <array>
#include <vector>

#include "fem/local_state.hpp"

namespace soft::fem {

/// A face of a rotation output: this rank's facets with int N_a dA over each undeformed facet's nodes.
struct RotationFace {
    using Axes = std::array<Vector3, 2>;  ///< two directions perpendicular to the axis
    std::vector<SurfaceCell> facets;
    std::vector<std::vector<double>> weights;  ///< [facet][node] [m^2]
    std::vector<Axes> images;  ///< of the face and its mirror images: the axes, mirrored in place of the face
};

struct Rotation {
    model::Measure measure = model::Measure::bend;
    Vector3 axis{};
    RotationFace face, reference;  ///< `reference` for bend only
    double undeformed = 0;         ///< [rad], subtracted
};

/// `state` is overwritten: the angle of the undeformed state is subtracted.
[[nodiscard]] Rotation make_rotation(const Discretization& fe, const model::Output& output, LocalState& state);

/// The angle at the state last read; adds its derivatives to `slopes`. Collective.
[[nodiscard]] double value_of(const Rotation& rotation, const Discretization& fe, const LocalState& state,
                              Slopes& slopes);

}  // namespace soft::fem
