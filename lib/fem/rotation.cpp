#include "fem/rotation.hpp"

#include <cmath>

#include "fem/plane_axes.hpp"

namespace soft::fem {

PhasorAngle angle_of(const Phasor& phasor) {
    const double square = phasor[0] * phasor[0] + phasor[1] * phasor[1];
    return {std::atan2(phasor[1], phasor[0]), {-phasor[1] / square, phasor[0] / square}};
}

void add_phasor(const Rotation& rotation, model::Kinematics kinematics, const fem::ReferenceFacet& facet,
                std::span<const double> x, std::span<const double> X, std::span<const double> weights, Phasor& phasor,
                std::array<std::vector<double>, 2>& slopes) {
    const auto basis = plane_axes(rotation.axis);
    const auto n = static_cast<std::size_t>(facet.nodes), size = static_cast<std::size_t>(facet.dofs());
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
    fem::pressure_force(facet, kinematics, x, force, stiffness);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t row = 0; row < size; ++row) {
            const double share = -basis[k][row / n];
            phasor[k] += share * force[row];
            for (std::size_t column = 0; column < size; ++column)
                slopes[k][column] += share * stiffness[row * size + column];
        }
}

}  // namespace soft::fem
