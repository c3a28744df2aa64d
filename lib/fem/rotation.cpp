#include "fem/rotation.hpp"

#include <cmath>
#include <numbers>

#include "fem/plane_axes.hpp"
#include "model/face_symmetry.hpp"

namespace soft::fem {

namespace {

/// Two numbers whose atan2 is an angle, summed over facets: (component along e1, along e2) of the vector area, or
/// (sum w X.x, sum w (X x x).e).
using Phasor = std::array<double, 2>;

/// Angle of a phasor and its derivative by both numbers.
struct PhasorAngle {
    double angle = 0;
    Phasor slope{};
};

PhasorAngle angle_of(const Phasor& phasor) {
    const double square = phasor[0] * phasor[0] + phasor[1] * phasor[1];
    return {std::atan2(phasor[1], phasor[0]), {-phasor[1] / square, phasor[0] / square}};
}

/// A facet's contributions to the phasor. slopes[k] = d phasor[k]/dx.
struct Sums {
    Phasor phasor{};
    std::array<std::vector<double>, 2> slopes;
};

/// x: current positions of the facet's nodes.
void add_twist(const RotationFace::Axes& axes, const SurfaceCell& facet, std::span<const double> x,
               std::span<const double> weights, Sums& sums) {
    const std::vector<double>& X = facet.X;
    const std::size_t n = facet.nodes.size(), components = X.size() / n;
    for (std::size_t a = 0; a < n; ++a) {
        Phasor here{}, there{};
        for (std::size_t i = 0; i < components; ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                there[k] += axes[k][i] * X[i * n + a];
                here[k] += axes[k][i] * x[i * n + a];
            }
        sums.phasor[0] += weights[a] * (there[0] * here[0] + there[1] * here[1]);
        sums.phasor[1] += weights[a] * (there[0] * here[1] - there[1] * here[0]);
        for (std::size_t i = 0; i < components; ++i) {
            sums.slopes[0][i * n + a] += weights[a] * (there[0] * axes[0][i] + there[1] * axes[1][i]);
            sums.slopes[1][i * n + a] += weights[a] * (there[0] * axes[1][i] - there[1] * axes[0][i]);
        }
    }
}

/// The force of a unit pressure is -int N_a n da and the N_a add up to 1.
void add_area(const RotationFace& face, model::Kinematics kinematics, const SurfaceCell& facet,
              std::span<const double> x, Sums& sums) {
    const std::size_t n = facet.nodes.size(), size = facet.X.size();
    std::vector<double> force(size, 0.0), stiffness(size * size, 0.0);
    model::pressure_force(*facet.reference, kinematics, x, force, stiffness);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t row = 0; row < size; ++row) {
            double share = 0;
            for (const RotationFace::Axes& axes : face.images) share -= axes[k][row / n];
            sums.phasor[k] += share * force[row];
            for (std::size_t column = 0; column < size; ++column)
                sums.slopes[k][column] += share * stiffness[row * size + column];
        }
}

/// The axes of the face and of its images at the symmetry planes across which it continues.
std::vector<RotationFace::Axes> images_of(const Discretization& fe, const std::string& name, const Vector3& axis) {
    const auto symmetry = model::face_symmetry(fe.input.mesh, {fe.input.kinematics, fe.input.symmetry_planes}, name);
    std::vector<RotationFace::Axes> images{plane_axes(axis)};
    for (std::size_t d = 0; d < 3; ++d) {
        if (!symmetry.mirrored[d]) continue;
        const std::size_t before = images.size();
        for (std::size_t i = 0; i < before; ++i) {
            RotationFace::Axes image = images[i];
            for (Vector3& direction : image) direction[d] = -direction[d];
            images.push_back(image);
        }
    }
    return images;
}

RotationFace make_rotation_face(const Discretization& fe, const std::string& name, const Vector3& axis) {
    RotationFace face{own_facets(fe, model::facets_of(fe.input.mesh, name)), {}, images_of(fe, name, axis)};
    for (const auto& facet : face.facets) {
        auto& weights = face.weights.emplace_back(facet.nodes.size(), 0.0);
        (void)model::facet_area(*facet.reference, fe.input.kinematics, facet.X, weights);
    }
    return face;
}

}  // namespace

Rotation make_rotation(const Discretization& fe, const model::Output& output, LocalState& state) {
    Rotation rotation{output.measure, output.direction, make_rotation_face(fe, output.face, output.direction), {}, 0.0};
    if (output.measure == model::Measure::bend)
        rotation.reference = make_rotation_face(fe, output.reference, output.direction);
    state.read(fe.make_vector());
    Slopes none(fe, nullptr, {});
    rotation.undeformed = value_of(rotation, fe, state, none);
    return rotation;
}

double value_of(const Rotation& rotation, const Discretization& fe, const LocalState& state, Slopes& slopes) {
    std::vector<double> x;
    double angle = 0;
    for (const auto* face : {&rotation.face, &rotation.reference}) {
        if (face == &rotation.reference && rotation.measure != model::Measure::bend) continue;
        Phasor phasor{};
        std::vector<Sums> shares;  // of the facets
        for (std::size_t f = 0; f < face->facets.size(); ++f) {
            const SurfaceCell& facet = face->facets[f];
            state.positions(facet, x);
            Sums& sums = shares.emplace_back();
            for (auto& slope : sums.slopes) slope.assign(facet.X.size(), 0.0);
            if (rotation.measure == model::Measure::bend)
                add_area(*face, fe.input.kinematics, facet, x, sums);
            else
                for (const RotationFace::Axes& axes : face->images) add_twist(axes, facet, x, face->weights[f], sums);
            for (std::size_t k = 0; k < 2; ++k) phasor[k] += sums.phasor[k];
        }
        MPI_Allreduce(MPI_IN_PLACE, phasor.data(), 2, MPI_DOUBLE, MPI_SUM, fe.comm);
        const double sign = face == &rotation.reference ? -1.0 : 1.0;
        if (face == &rotation.reference)
            for (double& component : phasor) component = -component;  // from the inward normal of the reference face
        const PhasorAngle turned = angle_of(phasor);
        angle += sign * turned.angle;
        for (std::size_t f = 0; f < shares.size(); ++f) {
            auto& [by_x, other] = shares[f].slopes;
            for (std::size_t i = 0; i < by_x.size(); ++i)  // both signs of a reference face cancel
                by_x[i] = turned.slope[0] * by_x[i] + turned.slope[1] * other[i];
            slopes.add(face->facets[f].dofs, by_x);
        }
    }
    return std::remainder(angle - rotation.undeformed, 2.0 * std::numbers::pi);
}

}  // namespace soft::fem
