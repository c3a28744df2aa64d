/// Numerical inf-sup constants of the mixed pairs, Chapelle and Bathe, Comput. Struct. 47 (1993) 537:
///   beta^2 = smallest nonzero eigenvalue of B A^-1 B^T q = beta^2 M q,
/// with A/mu = int grad v : grad v + (div v)^2/3 (twice the deviatoric strain's square, for v = 0 on the boundary), B the
/// divergence and M the pressures' mass, all read from the assembled stiffness of the undeformed block. A pair is stable
/// if beta does not fall under refinement. The constant pressure, which has no effect with a fixed boundary, is excluded.
#include <gtest/gtest.h>

#include <algorithm>

#include "block_mesh.hpp"
#include "fem/system.hpp"

namespace soft::fem {
namespace {

using mesh::CellType;

/// Dense symmetric matrix, row by row.
struct Dense {
    int size = 0;
    std::vector<double> value;
    explicit Dense(int n) : size(n), value(static_cast<std::size_t>(n) * n, 0.0) {}
    [[nodiscard]] double* row(int i) { return &value[static_cast<std::size_t>(i) * size]; }
    [[nodiscard]] const double* row(int i) const { return &value[static_cast<std::size_t>(i) * size]; }
};

double dot(const double* a, const double* b, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

/// A = L L^T in place; false where a pivot is not positive.
bool factorize(Dense& A) {
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j <= i; ++j) {
            const double sum = A.row(i)[j] - dot(A.row(i), A.row(j), j);
            if (i == j && !(sum > 0.0)) return false;
            A.row(i)[j] = i == j ? std::sqrt(sum) : sum / A.row(j)[j];
        }
    return true;
}

void solve_lower(const Dense& L, double* x) {
    for (int i = 0; i < L.size; ++i) x[i] = (x[i] - dot(L.row(i), x, i)) / L.row(i)[i];
}

void solve_upper(const Dense& L, double* x) {
    for (int i = L.size - 1; i >= 0; --i) {
        x[i] /= L.row(i)[i];
        for (int j = 0; j < i; ++j) x[j] -= L.row(i)[j] * x[i];
    }
}

/// K of the undeformed block, dense.
Dense stiffness_at_rest(const model::Case& input, std::vector<PetscInt>& pressures, std::vector<double>& constant) {
    System system(input, PETSC_COMM_WORLD);
    auto x = system.make_vector(), R = system.make_vector();
    const auto K = system.make_matrix();
    system.evaluate(x, no_loads(system.input()), R, K);
    const auto& map = system.dofs();
    Dense dense(static_cast<int>(map.total));
    for (PetscInt i = 0; i < map.total; ++i) {
        PetscInt count = 0;
        const PetscInt* columns = nullptr;
        const PetscScalar* values = nullptr;
        SOFT_PETSC(MatGetRow(K, i, &count, &columns, &values));
        for (PetscInt c = 0; c < count; ++c) dense.row(i)[columns[c]] = values[c];
        SOFT_PETSC(MatRestoreRow(K, i, &count, &columns, &values));
    }
    std::vector<char> is_pressure(map.total, 1);
    for (const PetscInt dof : map.displacement)
        if (dof >= 0) is_pressure[dof] = 0;
    std::vector<double> ones(map.total, 0.0);
    for (const auto* list : {&map.vertex_pressure, &map.cell_pressure})  // the constant is the first function of P-1
        for (const PetscInt dof : *list)
            if (dof >= 0) ones[dof] = 1.0;
    pressures.clear();
    constant.clear();
    for (PetscInt dof = 0; dof < map.total; ++dof)
        if (is_pressure[dof]) {
            pressures.push_back(dof);
            constant.push_back(ones[dof]);
        }
    return dense;
}

/// S = B A^-1 B^T from the whole K.
Dense schur_complement(const Dense& K, const std::vector<PetscInt>& pressures) {
    std::vector<int> displacements;
    for (int i = 0; i < K.size; ++i)
        if (!std::ranges::binary_search(pressures, i)) displacements.push_back(i);
    Dense A(static_cast<int>(displacements.size()));
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < A.size; ++j) A.row(i)[j] = K.row(displacements[i])[displacements[j]];
    EXPECT_TRUE(factorize(A));
    std::vector<std::vector<double>> columns;
    for (const PetscInt p : pressures) {
        auto& column = columns.emplace_back();
        for (const int d : displacements) column.push_back(K.row(d)[p]);
        solve_lower(A, column.data());
    }
    Dense S(static_cast<int>(pressures.size()));
    for (int i = 0; i < S.size; ++i)
        for (int j = 0; j <= i; ++j) S.row(i)[j] = S.row(j)[i] = dot(columns[i].data(), columns[j].data(), A.size);
    return S;
}

std::vector<double> times(const Dense& A, const std::vector<double>& x) {
    std::vector<double> y(x.size());
    for (int i = 0; i < A.size; ++i) y[i] = dot(A.row(i), x.data(), A.size);
    return y;
}

/// Smallest eigenvalue of S q = lambda M q except that of the constant, which is shifted to `above`. 0 if S has another null vector.
double min_eigenvalue(Dense S, const Dense& M, const std::vector<double>& constant, double above) {
    const auto weight = times(M, constant);
    const double volume = dot(weight.data(), constant.data(), S.size);
    for (int i = 0; i < S.size; ++i)
        for (int j = 0; j < S.size; ++j) S.row(i)[j] += above * weight[i] * weight[j] / volume;
    if (!factorize(S)) return 0.0;
    std::vector<double> q(constant.size());
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = std::sin(1.0 + 2.7 * static_cast<double>(i));
    double lambda = 0;
    for (int iteration = 0; iteration < 400; ++iteration) {
        auto Mq = times(M, q);
        const auto before = q;
        q = Mq;
        solve_lower(S, q.data());
        solve_upper(S, q.data());
        lambda = dot(before.data(), Mq.data(), S.size) / dot(q.data(), Mq.data(), S.size);
        const double size = std::sqrt(dot(q.data(), q.data(), S.size));
        for (double& entry : q) entry /= size;
    }
    return lambda;
}

/// beta of a block with a fixed boundary.
double inf_sup_constant(mesh::Mesh mesh, model::Kinematics kinematics) {
    model::Case input;
    input.kinematics = kinematics;
    input.formulation = model::Formulation::mixed;
    input.mesh = std::move(mesh);
    input.supports = {{"boundary", {true, true, true}}};
    input.materials = {sample_material(true)};
    std::vector<PetscInt> pressures;
    std::vector<double> constant;
    const Dense K = stiffness_at_rest(input, pressures, constant);
    input.materials[0].bulk_modulus_Pa = sample_mu_Pa;  // adds -M/mu to the block of the pressures
    const Dense with_mass = stiffness_at_rest(input, pressures, constant);
    Dense M(static_cast<int>(pressures.size()));
    for (int i = 0; i < M.size; ++i)
        for (int j = 0; j < M.size; ++j)
            M.row(i)[j] =
                sample_mu_Pa * (K.row(pressures[i])[pressures[j]] - with_mass.row(pressures[i])[pressures[j]]);
    const Dense S = schur_complement(K, pressures);
    const auto unseen = times(S, constant), seen = times(M, constant);
    EXPECT_LT(std::abs(*std::ranges::max_element(unseen)), 1e-9 * *std::ranges::max_element(seen) / sample_mu_Pa);
    return std::sqrt(sample_mu_Pa * min_eigenvalue(S, M, constant, 1.0 / sample_mu_Pa));
}

struct Pair {
    const char* name;
    model::Kinematics kinematics;
    CellType type, at_axis;  ///< cells of the block, and of its row at y = 0
    std::array<int, 3> sizes;
};

class InfSup : public ::testing::TestWithParam<Pair> {};

TEST_P(InfSup, TheConstantDoesNotFallUnderRefinement) {
    const Pair pair = GetParam();
    std::array<double, 3> beta{};
    for (std::size_t level = 0; level < 3; ++level) {
        auto mesh = block_mesh(
            mesh::dimension(pair.type), {pair.sizes[level], 0.1},
            [&](int, int j, int) { return j == 0 ? pair.at_axis : pair.type; },
            [](const std::array<double, 3>& s) {
                return mesh::Point{s[0], s[1], s[2]};
            });
        beta[level] = inf_sup_constant(std::move(mesh), pair.kinematics);
        RecordProperty("beta_" + std::to_string(pair.sizes[level]), std::to_string(beta[level]));
    }
    EXPECT_GT(beta[2], 0.1);
    EXPECT_GT(beta[2], 0.95 * beta[1]);
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, InfSup,
    ::testing::Values(
        Pair{"quad9", model::Kinematics::plane_strain, CellType::quad9, CellType::quad9, {3, 6, 12}},
        Pair{"triangle6", model::Kinematics::plane_strain, CellType::triangle6, CellType::triangle6, {3, 6, 12}},
        Pair{"hex27", model::Kinematics::solid, CellType::hex27, CellType::hex27, {2, 3, 4}},
        Pair{"tet10", model::Kinematics::solid, CellType::tet10, CellType::tet10, {2, 3, 4}},
        Pair{"wedge18", model::Kinematics::solid, CellType::wedge18, CellType::wedge18, {2, 3, 4}},
        Pair{"hex27_and_wedge18", model::Kinematics::solid, CellType::hex27, CellType::wedge18, {2, 3, 4}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace soft::fem
