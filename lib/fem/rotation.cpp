#include "fem/rotation.hpp"

#include <cmath>
#include <numbers>

#include "fem/plane_axes.hpp"

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

/// Adds a facet's contribution to `phasor`; x current positions. slopes[k] = d phasor[k]/dx.
void add_phasor(const Rotation& rotation, model::Kinematics kinematics, const SurfaceCell& facet,
                std::span<const double> x, std::span<const double> weights, Phasor& phasor,
                std::array<std::vector<double>, 2>& slopes) {
    const auto basis = plane_axes(rotation.axis);
    const std::vector<double>& X = facet.X;
    const std::size_t n = facet.nodes.size(), size = X.size();
    const std::size_t components = size / n;
    for (auto& slope : slopes) slope.assign(size, 0.0);
    if (rotation.measure == model::Measure::twist) {
        for (std::size_t a = 0; a < n; ++a) {
            Phasor here{}, there{};
            for (std::size_t i = 0; i < components; ++i)
                for (std::size_t k = 0; k < 2; ++k) {
                    there[k] += basis[k][i] * X[i * n + a];
                    here[k] += basis[k][i] * x[i * n + a];
                }
            phasor[0] += weights[a] * (there[0] * here[0] + there[1] * here[1]);
            phasor[1] += weights[a] * (there[0] * here[1] - there[1] * here[0]);
            for (std::size_t i = 0; i < components; ++i) {
                slopes[0][i * n + a] = weights[a] * (there[0] * basis[0][i] + there[1] * basis[1][i]);
                slopes[1][i * n + a] = weights[a] * (there[0] * basis[1][i] - there[1] * basis[0][i]);
            }
        }
        return;
    }
    // The force of a unit pressure is -int N_a n da and the N_a add up to 1.
    std::vector<double> force(size, 0.0), stiffness(size * size, 0.0);
    model::pressure_force(*facet.reference, kinematics, x, force, stiffness);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t row = 0; row < size; ++row) {
            const double share = -basis[k][row / n];
            phasor[k] += share * force[row];
            for (std::size_t column = 0; column < size; ++column)
                slopes[k][column] += share * stiffness[row * size + column];
        }
}

RotationFace make_rotation_face(const Discretization& fe, const std::string& name) {
    RotationFace face{own_facets(fe, model::facets_of(fe.input.mesh, name)), {}};
    for (const auto& facet : face.facets) {
        auto& weights = face.weights.emplace_back(facet.nodes.size(), 0.0);
        (void)model::facet_area(*facet.reference, fe.input.kinematics, facet.X, weights);
    }
    return face;
}

}  // namespace

Rotation make_rotation(const Discretization& fe, const model::Output& output, LocalState& state) {
    Rotation rotation{output.measure, output.direction, make_rotation_face(fe, output.face), {}, 0.0};
    if (output.measure == model::Measure::bend) rotation.reference = make_rotation_face(fe, output.reference);
    state.read(fe.make_vector());
    Slopes none(fe, nullptr, {});
    rotation.undeformed = value_of(rotation, fe, state, none);
    return rotation;
}

double value_of(const Rotation& rotation, const Discretization& fe, const LocalState& state, Slopes& slopes) {
    struct Share {
        const SurfaceCell* facet;
        std::array<std::vector<double>, 2> slopes;
    };
    std::vector<double> x;
    double angle = 0;
    for (const auto* face : {&rotation.face, &rotation.reference}) {
        if (face == &rotation.reference && rotation.measure != model::Measure::bend) continue;
        Phasor phasor{};
        std::vector<Share> shares;
        for (std::size_t f = 0; f < face->facets.size(); ++f) {
            state.positions(face->facets[f], x);
            Share& share = shares.emplace_back(Share{&face->facets[f], {}});
            add_phasor(rotation, fe.input.kinematics, *share.facet, x, face->weights[f], phasor, share.slopes);
        }
        MPI_Allreduce(MPI_IN_PLACE, phasor.data(), 2, MPI_DOUBLE, MPI_SUM, fe.comm);
        const double sign = face == &rotation.reference ? -1.0 : 1.0;
        if (face == &rotation.reference)
            for (double& component : phasor) component = -component;  // from the inward normal of the reference face
        const PhasorAngle turned = angle_of(phasor);
        angle += sign * turned.angle;
        for (auto& share : shares) {
            for (std::size_t i = 0; i < share.slopes[0].size(); ++i)  // both signs of a reference face cancel
                share.slopes[0][i] = turned.slope[0] * share.slopes[0][i] + turned.slope[1] * share.slopes[1][i];
            slopes.add(share.facet->dofs, share.slopes[0]);
        }
    }
    return std::remainder(angle - rotation.undeformed, 2.0 * std::numbers::pi);
}

}  // namespace soft::fem
