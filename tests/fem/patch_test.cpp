/// The patch test on a mesh: an affine displacement of the boundary gives the same affine field inside, whatever
/// the shapes of the cells. Irons and Razzaque (1972); Hughes, The Finite Element Method (1987), 4.6.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "block_mesh.hpp"
#include "fem/system.hpp"
#include "linalg/linear_solver.hpp"

namespace soft::fem {
namespace {

using mesh::CellType;
using model::Formulation;
using model::Kinematics;

constexpr Tensor slope{0.08, 0.05, -0.03, 0.04, -0.06, 0.06, 0.02, -0.07, 0.05};  // grad u

struct Patch {
    CellType type;
    Kinematics kinematics;
    Formulation formulation;
};

std::vector<Patch> all_patches() {
    std::vector<Patch> list;
    const auto add = [&](CellType type, Kinematics kinematics) {
        const bool tensor = type == CellType::quad4 || type == CellType::hex8;
        list.push_back({type, kinematics, Formulation::displacement});
        if (mesh::topology(type).order == 2) list.push_back({type, kinematics, Formulation::mixed});
        if (tensor) list.push_back({type, kinematics, Formulation::f_bar});
    };
    for (const auto kinematics : {Kinematics::plane_strain, Kinematics::axisymmetric})
        for (const auto type : {CellType::triangle3, CellType::triangle6, CellType::quad4, CellType::quad9})
            add(type, kinematics);
    for (const auto type :
         {CellType::tet4, CellType::tet10, CellType::hex8, CellType::hex27, CellType::wedge6, CellType::wedge18})
        add(type, Kinematics::solid);
    return list;
}

std::string label(const Patch& p) {
    return std::string(mesh::topology(p.type).name) + " " + std::to_string(static_cast<int>(p.kinematics)) + " " +
           std::to_string(static_cast<int>(p.formulation));
}

/// u = grad u . X; in a body of revolution u_x = a x, u_r = b r.
double affine(const Patch& p, const mesh::Point& X, int i) {
    if (p.kinematics == Kinematics::axisymmetric) return slope[4 * i] * X[i];
    double u = 0;
    for (int J = 0; J < mesh::dimension(p.type); ++J) u += slope[3 * i + J] * X[J];
    return u;
}

double dilatation(const Patch& p) {
    Tensor F = identity_tensor;
    for (int i = 0; i < mesh::dimension(p.type); ++i)
        for (int J = 0; J < mesh::dimension(p.type); ++J)
            if (p.kinematics != Kinematics::axisymmetric || i == J) F[3 * i + J] += slope[3 * i + J];
    if (p.kinematics == Kinematics::axisymmetric) F[8] += slope[4];
    return determinant(F);
}

std::vector<PetscInt> boundary_dofs(const System& system) {
    const auto& mesh = system.input().mesh;
    std::vector<PetscInt> rows;
    for (const auto& facet : mesh.facet_sets.at("boundary"))
        for (const auto node : mesh::facet_nodes(mesh, facet))
            for (int i = 0; i < mesh.dimension; ++i)
                rows.push_back(system.dofs().displacement[node * mesh.dimension + i]);
    std::ranges::sort(rows);
    const auto repeated = std::ranges::unique(rows);
    rows.erase(repeated.begin(), repeated.end());
    return rows;
}

using Field = std::function<double(const mesh::Point& X, int i)>;

/// The field on the boundary; inside perturbed by about 1 % of a cell; pressures 0.
linalg::Vector start(const System& system, const Field& field, const std::vector<PetscInt>& fixed) {
    auto x = system.make_vector();
    const auto& mesh = system.input().mesh;
    for (std::size_t node = 0; node < mesh.points.size(); ++node)
        for (int i = 0; i < mesh.dimension; ++i) {
            const PetscInt dof = system.dofs().displacement[node * mesh.dimension + i];
            const bool inside = !std::ranges::binary_search(fixed, dof);
            const double away = inside ? 0.004 * std::sin(1.0 + 3.1 * static_cast<double>(dof)) : 0.0;
            SOFT_PETSC(VecSetValue(x, dof, field(mesh.points[node], i) + away, INSERT_VALUES));
        }
    linalg::assemble(x);
    return x;
}

/// Newton's method for the unknowns that are not fixed.
void solve_inside(System& system, const std::vector<PetscInt>& fixed, Vec x) {
    auto R = system.make_vector(), step = system.make_vector();
    const auto count = static_cast<PetscInt>(fixed.size());
    for (int iteration = 0; iteration < 8; ++iteration) {
        const auto K = system.make_matrix();
        ASSERT_TRUE(system.evaluate(x, no_loads(system.input()), R, K).admissible());
        SOFT_PETSC(MatZeroRowsColumns(K, count, fixed.data(), 1.0, nullptr, nullptr));
        const std::vector<double> zeros(fixed.size(), 0.0);
        SOFT_PETSC(VecSetValues(R, count, fixed.data(), zeros.data(), INSERT_VALUES));
        linalg::assemble(R);
        linalg::LinearSolver solver(K, linalg::Symmetry::general);
        ASSERT_TRUE(solver.factorize().succeeded);
        ASSERT_TRUE(solver.solve(R, step).converged);
        linalg::add(x, -1.0, step);
    }
}

TEST(Patch, AnAffineBoundaryGivesTheAffineFieldInside) {
    for (const auto& p : all_patches()) {
        const auto input = block_case(p.type, p.kinematics, p.formulation, {2, 0.3});
        System system(input, PETSC_COMM_WORLD);
        const auto fixed = boundary_dofs(system);
        ASSERT_LT(fixed.size(), static_cast<std::size_t>(system.dofs().total)) << label(p);
        auto x = start(
            system, [&](const mesh::Point& X, int i) { return affine(p, X, i); }, fixed);
        solve_inside(system, fixed, x);
        const auto fields = system.fields().gather(x);
        for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
            for (int i = 0; i < input.mesh.dimension; ++i)
                EXPECT_NEAR(fields.displacement_m[3 * node + i], affine(p, input.mesh.points[node], i), 1e-12)
                    << label(p);
        const double p_Pa = 100 * sample_mu_Pa * (dilatation(p) - 1.0);  // kappa (J - 1)
        for (const double found : fields.pressure_Pa) EXPECT_NEAR(found, p_Pa, 1e-8 * std::abs(p_Pa)) << label(p);
    }
}

constexpr double stiffness_ratio = 10;

/// First Piola stress over the shear modulus of the softer material in uniaxial strain, of mu/2 (I1 J^-2/3 - 3) + kappa/2 (J - 1)^2 with
/// kappa = 100 mu: mu 2/3 (l^1/3 - l^-5/3) + kappa (l - 1).
double stress_in_uniaxial_strain(double stretch, double mu) {
    return mu * (2.0 / 3 * (std::cbrt(stretch) - std::pow(stretch, -5.0 / 3)) + 100 * (stretch - 1));
}

/// Two layers across x in uniaxial strain: each is affine, with a pressure of its own. A pressure that is continuous across the interface
/// cannot represent it.
TEST(Patch, TwoMaterialsInUniaxialStrainHaveTheirOwnPressures) {
    const double soft = 1.03;
    double low = 1, stiff = soft;  // the stretch of the stiff layer under the same stress, by bisection
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + stiff);
        (stress_in_uniaxial_strain(middle, stiffness_ratio) < stress_in_uniaxial_strain(soft, 1) ? low : stiff) =
            middle;
    }
    const Field layered = [&](const mesh::Point& X, int i) {
        return i > 0 ? 0.0 : (soft - 1) * std::min(X[0], 0.5) + (stiff - 1) * std::max(X[0] - 0.5, 0.0);
    };
    for (const auto& p : all_patches()) {
        auto input = block_case(p.type, p.kinematics, p.formulation, {2, 0});
        input.materials.push_back(input.materials.front());
        input.materials.back().name = "stiff";
        input.materials.back().constants["mu"] = {stiffness_ratio * sample_mu_Pa};
        input.materials.back().bulk_modulus_Pa = 100 * stiffness_ratio * sample_mu_Pa;
        input.mesh.region_names = {"rubber", "stiff"};
        for (mesh::Index cell = 0; cell < input.mesh.cell_count(); ++cell) {
            double sum = 0;
            for (const auto node : input.mesh.cell_nodes(cell)) sum += input.mesh.point(node)[0];
            input.mesh.cell_regions[cell] = sum > 0.5 * static_cast<double>(input.mesh.cell_nodes(cell).size()) ? 1 : 0;
        }
        System system(input, PETSC_COMM_WORLD);
        const auto fixed = boundary_dofs(system);
        auto x = start(system, layered, fixed);
        solve_inside(system, fixed, x);
        const auto fields = system.fields().gather(x);
        for (std::size_t node = 0; node < input.mesh.points.size(); ++node) {
            const mesh::Point& X = input.mesh.points[node];
            for (int i = 0; i < input.mesh.dimension; ++i)
                EXPECT_NEAR(fields.displacement_m[3 * node + i], layered(X, i), 1e-11) << label(p);
            if (fields.pressure_Pa.empty() || std::abs(X[0] - 0.5) < 1e-9) continue;
            const double p_Pa = 100 * sample_mu_Pa * (X[0] < 0.5 ? soft - 1 : stiffness_ratio * (stiff - 1));
            EXPECT_NEAR(fields.pressure_Pa[node], p_Pa, 1e-7 * p_Pa) << label(p);
        }
    }
}

}  // namespace
}  // namespace soft::fem
