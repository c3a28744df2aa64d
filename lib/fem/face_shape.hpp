#pragma once
/// Shape of a deformed face from the positions x of its nodes, with the exact derivatives: the outputs `radial`, `rotation`
/// and `curvature` (model::Measure). X undeformed positions, w = int N_a dA weights on the undeformed face, d the output's direction.
///   radial:    sum w (|x across d| - |X across d|) / sum w
///   rotation:  r . d of the rotation vector r (axis x angle in [0, pi]) of the rotation that maps X - mean X closest to
///              x - mean x in the weighted least-squares sense; source: B. K. P. Horn, J. Opt. Soc. Am. A 4 (1987) 629
///   curvature: 1 / radius of the least-squares circle through the points projected along d (fem/circle_fit.hpp). Positive where
///              the face, followed along its longest undeformed side toward increasing x (y, z), turns in the positive sense about
///              d: then curvature x length is the bending angle of its end. Valid for arcs of less than a full circle.
/// Derivatives by first-order perturbation of the eigenvectors, derived here. Tested by fem/face_shape_test.
#include <vector>

#include "math/tensor.hpp"
#include "model/measure.hpp"

namespace soft::fem {

struct FaceShape {
    model::Measure measure = model::Measure::radial;
    Vector3 direction{};
    std::vector<Vector3> X;       ///< [node]
    std::vector<double> weights;  ///< [node] [m^2]
};

/// Value [m, rad or 1/m] at positions x [node]; `gradient` [node] is overwritten, nullptr if not needed. NaN where
/// the points determine no value (all coincide).
[[nodiscard]] double value_of(const FaceShape& shape, const std::vector<Vector3>& x, std::vector<Vector3>* gradient);

}  // namespace soft::fem
