#pragma once
/// The contact potential of the sample bodies, with its derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "contact/potential.hpp"
#include "contact_samples.hpp"

namespace soft::contact {

using mesh::Point;
using test::Cells;

inline constexpr double modulus_Pa = 1e5;

/// Energy, and its derivatives by [node x 3] and then [obstacle x 3].
struct Derivatives {
    Summary summary;
    std::vector<double> gradient, hessian;
};

inline Derivatives derivatives(Potential& potential, const std::vector<Point>& positions,
                               const std::vector<Vector3>& shifts, Wanted wanted = Wanted::gradient) {
    const std::size_t size = 3 * (positions.size() + shifts.size());
    Derivatives sum{Summary(shifts.size()), std::vector<double>(size),
                    std::vector<double>(wanted == Wanted::hessian ? size * size : 0)};
    sum.summary = potential.evaluate(
        positions, shifts, wanted, [](mesh::Index) { return true; },
        [&](const Block& block) {
            std::vector<std::size_t> at;
            for (std::size_t i = 0; i < block.dimension; ++i) {
                for (const auto node : block.nodes) at.push_back(3 * static_cast<std::size_t>(node) + i);
                if (block.obstacle >= 0)
                    at.push_back(3 * (positions.size() + static_cast<std::size_t>(block.obstacle)) + i);
            }
            ASSERT_EQ(block.gradient.size(), at.size());
            for (std::size_t p = 0; p < at.size(); ++p) {
                sum.gradient[at[p]] += block.gradient[p];
                for (std::size_t q = 0; q < at.size() && wanted == Wanted::hessian; ++q)
                    sum.hessian[at[p] * size + at[q]] += block.hessian[p * at.size() + q];
            }
        });
    return sum;
}

struct State {
    std::vector<Point> positions;
    std::vector<Vector3> shifts;
};

inline State moved(const State& state, double step, std::span<const double> direction) {
    State next = state;
    std::size_t k = 0;
    for (auto* list : {&next.positions, &next.shifts})
        for (auto& x : *list)
            for (double& component : x) component += step * direction[k++];
    return next;
}

/// Taylor remainders of energy and gradient along a direction of length `size_m`: of third order in the energy and of second in the gradient.
inline void expect_exact_derivatives(Potential& potential, const State& state, std::span<const double> direction) {
    const auto at = derivatives(potential, state.positions, state.shifts, Wanted::hessian);
    ASSERT_TRUE(at.summary.touches());
    const std::size_t size = direction.size();
    const double slope = std::inner_product(direction.begin(), direction.end(), at.gradient.begin(), 0.0);
    std::vector<double> change(size);
    for (std::size_t p = 0; p < size; ++p)
        for (std::size_t q = 0; q < size; ++q) {
            change[p] += at.hessian[p * size + q] * direction[q];
            EXPECT_NEAR(at.hessian[p * size + q], at.hessian[q * size + p],
                        1e-9 * (1 + std::abs(at.hessian[p * size + q])));
        }
    std::vector<double> energy, gradient;
    for (const double step : {4e-2, 2e-2, 1e-2}) {
        const State next = moved(state, step, direction);
        const auto there = derivatives(potential, next.positions, next.shifts);
        const double curvature = std::inner_product(direction.begin(), direction.end(), change.begin(), 0.0);
        energy.push_back(
            std::abs(there.summary.energy_J - at.summary.energy_J - step * slope - step * step / 2 * curvature));
        double sum = 0;
        for (std::size_t p = 0; p < size; ++p)
            sum = std::hypot(sum, there.gradient[p] - at.gradient[p] - step * change[p]);
        gradient.push_back(sum);
    }
    EXPECT_GT(std::log2(energy[1] / energy[2]), 2.7) << energy[0] << ' ' << energy[1] << ' ' << energy[2];
    EXPECT_GT(std::log2(gradient[1] / gradient[2]), 1.8) << gradient[0] << ' ' << gradient[1] << ' ' << gradient[2];
}

/// Smooth random displacements of the nodes of at most `size_m`, and random ones of the obstacles.
inline std::vector<double> direction_of(const model::Case& model, unsigned seed, double size_m) {
    std::vector<double> direction = test::displacement(model, test::wobble(seed, 0.9, 1.5));
    double largest = 0;
    for (const double u : direction) largest = std::max(largest, std::abs(u));
    for (double& u : direction) u *= size_m / largest;
    for (std::size_t n = 0; n < model.mesh.points.size() && model.mesh.dimension == 2; ++n) direction[3 * n + 2] = 0;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-size_m, size_m);
    for (std::size_t k = 0; k < 3 * model.obstacles.size(); ++k)
        direction.push_back(model.mesh.dimension == 2 && k % 3 == 2 ? 0 : uniform(random));
    return direction;
}

inline model::Case with_settings(model::Case model) {
    model.mesh.region_names = {"rubber"};
    model.path.contact = model::Contact::solve;
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    return model;
}

}  // namespace soft::contact
