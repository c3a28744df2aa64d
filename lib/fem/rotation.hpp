#pragma once
/// Rotation of faces: the outputs `bend` and `twist` (model::Measure), with their derivatives by node positions.
///   bend: the vector area A = int n da of a deformed face gives its mean normal; the angle is that from -A(reference)
///         to A(face) about the axis, in the plane perpendicular to it;
///   twist: atan2(sum w (X x x).e, sum w X.x), X and x projected perpendicular to the axis e, w = int N_a dA: exact for a rigid
///         rotation by any angle, a least-squares fit for a deformed face.
/// Angles in (-pi, pi]; for a section in plane strain, per metre of depth, about z. Derived here. Tested by fem/loads_test.
#include <array>
#include <span>
#include <vector>

#include "fem/cavity.hpp"

namespace soft::fem {

/// A face of a rotation output: this rank's facets with int N_a dA over each undeformed facet's nodes.
struct RotationFace {
    std::vector<SurfaceCell> facets;
    std::vector<std::vector<double>> weights;  ///< [facet][node] [m^2]
};

struct Rotation {
    model::Measure measure = model::Measure::bend;
    std::array<double, 3> axis{};
    RotationFace face, reference;  ///< `reference` for bend only
    double undeformed = 0;         ///< [rad], subtracted
};

/// Two numbers whose atan2 is an angle, summed over facets: (component along e1, along e2) of the vector area, or
/// (sum w X.x, sum w (X x x).e).
using Phasor = std::array<double, 2>;

/// Angle of a phasor and its derivative by both numbers.
struct PhasorAngle {
    double angle = 0;
    Phasor slope{};
};
[[nodiscard]] PhasorAngle angle_of(const Phasor& phasor);

/// Adds a facet's contribution to `phasor`; x current, X reference positions, component-major. slopes[k] = d phasor[k]/dx.
void add_phasor(const Rotation& rotation, model::Kinematics kinematics, const fem::ReferenceFacet& facet,
                std::span<const double> x, std::span<const double> X, std::span<const double> weights, Phasor& phasor,
                std::array<std::vector<double>, 2>& slopes);

}  // namespace soft::fem
