/// The stiffness in the reference state has no zero-energy modes other than the rigid motions.
#include <gtest/gtest.h>

#include "matrix.hpp"

namespace soft::fem {
namespace {

/// Size minus rank by Gaussian elimination with full pivoting, relative to the largest entry.
int nullity(std::vector<double> A, int size) {
    constexpr double zero = 1e-9;  // rounding errors are 1e-14, the softest deformation mode is about 1e-4
    const auto at = [&](int i, int j) -> double& { return A[static_cast<std::size_t>(i) * size + j]; };
    double largest = 0;
    for (int step = 0; step < size; ++step) {
        int row = step, column = step;
        for (int i = step; i < size; ++i)
            for (int j = step; j < size; ++j)
                if (std::abs(at(i, j)) > std::abs(at(row, column))) row = i, column = j;
        const double pivot = at(row, column);
        if (step == 0) largest = std::abs(pivot);
        if (std::abs(pivot) < zero * largest) return size - step;
        for (int j = 0; j < size; ++j) std::swap(at(step, j), at(row, j));
        for (int i = 0; i < size; ++i) std::swap(at(i, step), at(i, column));
        for (int i = step + 1; i < size; ++i) {
            const double factor = at(i, step) / pivot;
            for (int j = step; j < size; ++j) at(i, j) -= factor * at(step, j);
        }
    }
    return 0;
}

int rigid_motions(model::Kinematics kinematics) {
    switch (kinematics) {
        case model::Kinematics::axisymmetric: return 1;
        case model::Kinematics::plane_strain: return 3;
        case model::Kinematics::solid: return 6;
    }
    return 0;
}

int nullity_at_rest(Sample s) {
    std::vector<double> rest(s.unknowns.size(), 0.0);
    auto K = s.integrate(rest).stiffness;
    // Scales displacement and pressure to one unit, so that the rows of both have entries of similar magnitude.
    const auto n = rest.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            if (i >= s.X.size()) K[i * n + j] /= Sample::length;
            if (j >= s.X.size()) K[i * n + j] /= Sample::length;
        }
    return nullity(std::move(K), static_cast<int>(n));
}

TEST(Rank, OnlyRigidMotionsHaveZeroStiffness) {
    for (const auto& c : all_combinations())
        EXPECT_EQ(nullity_at_rest(Sample(c)), rigid_motions(c.kinematics)) << label(c);
}

// Without 1/K on the diagonal, a pressure that does no work on any displacement would be an additional mode.
TEST(Rank, AnIncompressibleCellHasNoSpuriousPressureMode) {
    const auto incompressible = material::make_rubber(material::sample::description_of("neo-hookean", std::nullopt));
    for (const auto& c : all_combinations()) {
        if (c.form != Form::mixed) continue;
        EXPECT_EQ(nullity_at_rest(Sample(c, incompressible)), rigid_motions(c.kinematics)) << label(c);
    }
}

// N/R is bounded on the axis only for nodes off the axis; the cell must not lose rank there.
TEST(Rank, ACellOnTheAxisOfRevolutionKeepsItsRank) {
    for (const auto& c : all_combinations()) {
        if (c.kinematics != model::Kinematics::axisymmetric) continue;
        Sample s(c);
        const int n = s.cell.nodes;
        const auto& topology = mesh::topology(c.type);
        const double low = topology.shape == mesh::Shape::triangle ? 0.0 : -1.0;
        for (int a = 0; a < n; ++a) {
            s.X[a] = Sample::length * topology.nodes[a][0];
            s.X[n + a] = Sample::length * (topology.nodes[a][1] - low);
        }
        std::vector<double> u(s.unknowns.size(), 0.0);
        auto K = s.integrate(u).stiffness;
        for (int a = 0; a < n; ++a)  // u_r = 0 on the axis is prescribed, so it is not a free mode
            if (s.X[n + a] == 0.0) K[static_cast<std::size_t>(n + a) * (u.size() + 1)] += 1e3;
        for (std::size_t i = 0; i < u.size(); ++i)
            for (std::size_t j = 0; j < u.size(); ++j)
                K[i * u.size() + j] /=
                    (i < s.X.size() ? 1.0 : Sample::length) * (j < s.X.size() ? 1.0 : Sample::length);
        EXPECT_EQ(nullity(K, static_cast<int>(u.size())), 1) << label(c);
    }
}

}  // namespace
}  // namespace soft::fem
