#include "fem/element_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "core/error.hpp"
#include "linalg/multifrontal.hpp"
#include "mesh/split.hpp"
#include "sample_cases.hpp"

namespace soft::fem {
namespace {

using Field = std::function<double(const mesh::Point&, int)>;

/// Values of a field of (point, component) at the unknowns that `numbers` lists, in their order.
linalg::Vector values_of(const System& system, Vec layout, const std::vector<PetscInt>& wanted, const Field& field) {
    linalg::Vector all = system.make_vector(), some = linalg::duplicate(layout);
    const auto& map = system.dofs();
    std::vector<double> value(map.total, 0.0);
    for (std::size_t node = 0; node < system.input().mesh.points.size(); ++node)
        for (int i = 0; i < map.dimension; ++i)
            if (const PetscInt dof = map.displacement[node * map.dimension + i]; dof >= 0)
                value[dof] = field(system.input().mesh.points[node], i);
    for (std::size_t k = 0; k < wanted.size(); ++k)
        SOFT_PETSC(VecSetValue(some, static_cast<PetscInt>(k), value[wanted[k]], INSERT_VALUES));
    linalg::assemble(some);
    return some;
}

/// Unknowns at vertices, ascending.
std::vector<PetscInt> vertex_unknowns(const System& system) {
    std::vector<PetscInt> unknowns;
    const auto& mesh = system.input().mesh;
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (int v = 0; v < mesh::topology(mesh.cell_type(cell)).vertex_count; ++v)
            for (int i = 0; i < mesh.dimension; ++i)
                if (const PetscInt dof = system.dofs().displacement[mesh.cell_nodes(cell)[v] * mesh.dimension + i];
                    dof >= 0)
                    unknowns.push_back(dof);
    std::ranges::sort(unknowns);
    const auto repeated = std::ranges::unique(unknowns);
    unknowns.erase(repeated.begin(), repeated.end());
    return unknowns;
}

std::vector<PetscInt> numbers_of(IS set) {
    PetscInt size = 0;
    const PetscInt* values = nullptr;
    SOFT_PETSC(ISGetLocalSize(set, &size));
    SOFT_PETSC(ISGetIndices(set, &values));
    std::vector<PetscInt> numbers(values, values + size);
    SOFT_PETSC(ISRestoreIndices(set, &values));
    return numbers;
}

void expect_exact_interpolation(const model::Case& input, const Field& field) {
    System system(input, PETSC_COMM_WORLD);
    const auto levels = make_element_levels(system);
    linalg::Vector coarse, fine;
    SOFT_PETSC(MatCreateVecs(levels.interpolation, coarse.out(), fine.out()));
    const auto from = values_of(system, coarse, vertex_unknowns(system), field);
    auto to = values_of(system, fine, numbers_of(levels.displacements), field);
    SOFT_PETSC(MatMult(levels.interpolation, from, fine));
    const double size = linalg::norm(to);
    linalg::add(to, -1.0, fine);
    EXPECT_GT(size, 0.0);
    EXPECT_LT(linalg::norm(to), 1e-13 * size);
}

TEST(ElementLevels, InterpolationIsExactForLinearFieldsThatVanishOnSupports) {
    auto box = box_case(2, false);
    box.supports[0].fixed = {true, true, true};
    const Field stretched = [](const mesh::Point& X, int i) { return (i + 2.0) * X[0] * (i == 0 ? 1.0 : 0.3); };
    auto clamped = box;
    clamped.supports.resize(1);
    expect_exact_interpolation(clamped, stretched);
    clamped.mesh = mesh::split_into_simplices(clamped.mesh);
    expect_exact_interpolation(clamped, stretched);
}

TEST(ElementLevels, DisplacementsAndPressuresTogetherAreAllUnknowns) {
    const auto input = box_case(2, false);
    System system(input, PETSC_COMM_WORLD);
    const auto levels = make_element_levels(system);
    auto all = numbers_of(levels.displacements);
    const auto pressures = numbers_of(levels.pressures);
    EXPECT_EQ(static_cast<PetscInt>(pressures.size()), system.dofs().pressures);
    all.insert(all.end(), pressures.begin(), pressures.end());
    std::ranges::sort(all);
    std::vector<PetscInt> wanted(system.dofs().total);
    std::iota(wanted.begin(), wanted.end(), 0);
    EXPECT_EQ(all, wanted);
}

// A constant pressure: its mass is the volume of the body over the shear modulus.
TEST(ElementLevels, MassOfAConstantPressureIsTheVolume) {
    const auto input = box_case(2, false);
    System system(input, PETSC_COMM_WORLD);
    const double scale = system.dofs().pressure_scale_Pa;
    double sum = 0;
    for (const auto& block : make_element_levels(system).blocks) {
        EXPECT_EQ(block.kind, linalg::PressureBlock::Kind::of_cell);
        EXPECT_EQ(block.size, 4);
        sum += block.mass[0];
    }
    const double wanted = scale * scale * 1e-6 / sample_mu_Pa;  // 10 mm cubed
    EXPECT_NEAR(sum, wanted, 1e-12 * wanted);
}

/// The connectivity of a row of hexahedra with four vertices between two of them.
mesh::Mesh row_of_cells(mesh::Index count) {
    mesh::Mesh mesh;
    mesh.points.resize(static_cast<std::size_t>(4 * (count + 1)));
    for (mesh::Index k = 0; k < count; ++k) {
        std::array<mesh::Index, 27> cell{};
        for (mesh::Index a = 0; a < 27; ++a) cell[static_cast<std::size_t>(a)] = 4 * k + a % 8;
        mesh::add_cell(mesh, mesh::CellType::hex27, cell, 0);
    }
    return mesh;
}

TEST(ElementLevels, AutomaticSelectsMultigridOnlyForLargeCompactSecondOrderSolids) {
    const auto box = box_case(3, false), section = sphere_case(1, 2);
    auto first_order = box, slender = box;
    first_order.mesh.cell_types = {mesh::CellType::hex8};
    slender.mesh = row_of_cells(2000);
    const auto is_multigrid = [](const model::LinearSettings& settings) {
        return settings.method == model::LinearMethod::krylov &&
               settings.preconditioner == model::Preconditioner::multigrid;
    };
    constexpr auto symmetric = linalg::Symmetry::symmetric;
    EXPECT_TRUE(is_multigrid(choose_linear({}, box, always_factorised + 1, symmetric)));
    EXPECT_FALSE(is_multigrid(choose_linear({}, box, always_factorised, symmetric)));
    EXPECT_FALSE(is_multigrid(choose_linear({}, slender, always_factorised + 1, symmetric)));
    EXPECT_TRUE(is_multigrid(choose_linear({}, slender, always_factorised + 1, linalg::Symmetry::general)));
    EXPECT_FALSE(is_multigrid(choose_linear({}, section, always_factorised + 1, symmetric)));
    EXPECT_FALSE(is_multigrid(choose_linear({}, first_order, always_factorised + 1, symmetric)));
    EXPECT_FALSE(is_multigrid(
        choose_linear({.method = model::LinearMethod::mumps_ldlt}, box, always_factorised + 1, symmetric)));
}

TEST(ElementLevels, PredictsTheFlopsOfTheFactorisation) {
    for (const int n : {6, 10})
        for (const bool incompressible : {false, true}) {
            const auto input = box_case(n, incompressible);
            System system(input, PETSC_COMM_WORLD);
            const linalg::Matrix K = system.make_matrix();
            const double ratio = predicted_flops(input.mesh, system.dofs().total) / linalg::Multifrontal(K).flops();
            EXPECT_GT(ratio, 0.6) << n << incompressible;
            EXPECT_LT(ratio, 2.0) << n << incompressible;  // fronts of few nodes are merged, with zeros
        }
}

TEST(ElementLevels, RejectsFirstOrderCells) {
    auto input = box_case(1, false);
    input.formulation = model::Formulation::f_bar;
    auto& mesh = input.mesh;
    const auto second = mesh;
    mesh.cell_types.clear();
    mesh.cell_regions.clear();
    mesh.connectivity.clear();
    mesh.offsets = {0};
    mesh::add_cell(mesh, mesh::CellType::hex8, second.cell_nodes(0).first(8), 0);
    System system(input, PETSC_COMM_WORLD);
    try {
        (void)make_element_levels(system);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("solver.preconditioner: multigrid supports only second-order cells"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace soft::fem
