#include "solver/differences.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {

namespace {

/// Relative to an unknown's scale (see the header).
constexpr double relative_step = 1e-7;

double node_distance_m(const mesh::Mesh& mesh) {
    double diagonal2 = 0;
    for (int i = 0; i < mesh.dimension; ++i) {
        const auto [low, high] =
            std::ranges::minmax(mesh.points, {}, [i](const mesh::Point& point) { return point[i]; });
        diagonal2 += (high[i] - low[i]) * (high[i] - low[i]);
    }
    return std::sqrt(diagonal2) / std::pow(static_cast<double>(mesh.points.size()), 1.0 / mesh.dimension);
}

double shear_modulus_Pa(const model::Case& input) {
    double modulus = 0;
    for (const auto& material : input.materials)
        modulus = std::max(modulus, material::initial_shear_modulus_Pa(fem::make_rubber(material, input.formulation)));
    return modulus;
}

}  // namespace

ResidualDifferences::ResidualDifferences(fem::System& system, Mat K, model::TangentSource source)
    : system_(system),
      scale_(system.make_vector()),
      inverse_scale_(system.make_vector()),
      x_(system.make_vector()),
      y_(system.make_vector()),
      base_x_(system.make_vector()),
      base_R_(system.make_vector()),
      levels_(fem::no_loads(system.input())),
      base_levels_(levels_) {
    make_scale();
    const PetscInt own = system.dofs().end - system.dofs().begin, all = system.dofs().total;
    SOFT_PETSC(MatCreateShell(system.comm(), own, own, all, all, this, jacobian_.out()));
    SOFT_PETSC(MatShellSetOperation(jacobian_, MATOP_MULT, reinterpret_cast<void (*)(void)>(&multiply)));
    if (source == model::TangentSource::finite_difference) make_colors(K);
}

void ResidualDifferences::make_scale() {
    const auto& dofs = system_.dofs();
    SOFT_PETSC(VecSet(scale_, shear_modulus_Pa(system_.input()) / dofs.pressure_scale_Pa));
    const double length = node_distance_m(system_.input().mesh);
    for (const PetscInt dof : dofs.displacement)
        if (dof >= dofs.begin && dof < dofs.end) SOFT_PETSC(VecSetValue(scale_, dof, length, INSERT_VALUES));
    linalg::assemble(scale_);
    linalg::copy(scale_, inverse_scale_);
    SOFT_PETSC(VecReciprocal(inverse_scale_));
}

void ResidualDifferences::make_colors(Mat K) {
    linalg::Owned<MatColoring, MatColoringDestroy> method;
    linalg::Owned<ISColoring, ISColoringDestroy> classes;
    linalg::assemble(K);
    SOFT_PETSC(MatColoringCreate(K, method.out()));
    SOFT_PETSC(MatColoringSetType(method, MATCOLORINGGREEDY));
    SOFT_PETSC(MatColoringSetDistance(method, 2));
    SOFT_PETSC(MatColoringApply(method, classes.out()));
    SOFT_PETSC(MatFDColoringCreate(K, classes, colors_.out()));
    const auto untyped = reinterpret_cast<void (*)(void)>(&scaled_residual);  // PETSc casts it back to its true type
    SOFT_PETSC(MatFDColoringSetFunction(colors_, reinterpret_cast<PetscErrorCode (*)(void)>(untyped), this));
    SOFT_PETSC(MatFDColoringSetParameters(colors_, relative_step, 1.0));  // scaled unknowns are of order 1
    SOFT_PETSC(MatFDColoringSetUp(K, classes, colors_));
}

PetscErrorCode ResidualDifferences::scaled_residual(void*, Vec y, Vec R, void* self) {
    auto& differences = *static_cast<ResidualDifferences*>(self);
    try {
        SOFT_PETSC(VecPointwiseMult(differences.x_, y, differences.scale_));
        (void)differences.system_.evaluate(differences.x_, differences.levels_, R, nullptr);
    } catch (...) {
        differences.thrown_ = std::current_exception();
        return PETSC_ERR_USER;
    }
    return 0;
}

void ResidualDifferences::tangent(Vec x, const fem::LoadLevels& levels, Mat K) {
    levels_ = levels;
    SOFT_PETSC(VecPointwiseMult(y_, x, inverse_scale_));
    const PetscErrorCode code = MatFDColoringApply(K, colors_, y_, nullptr);
    if (thrown_) std::rethrow_exception(thrown_);
    linalg::check(code, "MatFDColoringApply");
    SOFT_PETSC(MatDiagonalScale(K, nullptr, inverse_scale_));
}

void ResidualDifferences::set_base(Vec x, const fem::LoadLevels& levels, Vec R) {
    linalg::copy(x, base_x_);
    linalg::copy(R, base_R_);
    base_levels_ = levels;
}

PetscErrorCode ResidualDifferences::multiply(Mat jacobian, Vec v, Vec product) {
    void* self = nullptr;
    if (const PetscErrorCode code = MatShellGetContext(jacobian, &self); code != 0) return code;
    auto& differences = *static_cast<ResidualDifferences*>(self);
    try {
        differences.difference(v, product);
    } catch (...) {
        differences.thrown_ = std::current_exception();
        return PETSC_ERR_USER;
    }
    return 0;
}

void ResidualDifferences::difference(Vec v, Vec product) {
    SOFT_PETSC(VecPointwiseMult(y_, v, inverse_scale_));
    double largest = 0;
    SOFT_PETSC(VecNorm(y_, NORM_INFINITY, &largest));
    if (largest == 0.0) {
        SOFT_PETSC(VecZeroEntries(product));
        return;
    }
    const double h = relative_step / largest;
    linalg::copy(base_x_, x_);
    linalg::add(x_, h, v);
    (void)system_.evaluate(x_, base_levels_, product, nullptr);
    linalg::add(product, -1.0, base_R_);
    SOFT_PETSC(VecScale(product, 1.0 / h));
}

}  // namespace soft::solver
