#pragma once
/// The contact potential of the sample bodies, with its derivatives.
#include <gtest/gtest.h>

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

inline model::Case with_settings(model::Case model) {
    model.mesh.region_names = {"rubber"};
    model.path.contact = model::Contact::solve;
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    return model;
}

}  // namespace soft::contact
