#include "fem/system.hpp"

#include <algorithm>

#include "fem/pattern.hpp"
#include "model/rubber.hpp"

namespace soft::fem {

System::System(const model::Case& input, MPI_Comm comm, std::span<const int> cell_rank)
    : fe_(input, comm, cell_rank),
      potential_(input, model::young_moduli_Pa(input)),
      state_(fe_, potential_.is_empty() ? std::span<const mesh::Index>{} : potential_.nodes()),
      loads_(fe_),
      contact_(fe_, state_, potential_),
      assembler_(fe_, loads_, contact_, state_),
      volumes_(fe_, state_),
      outputs_(fe_, loads_, contact_, state_),
      fields_(fe_, contact_, state_) {}

linalg::Matrix System::make_matrix() const {
    return make_zero_matrix(fe_.input.mesh, fe_.dofs, fe_.references, contact_.couplings(), fe_.comm);
}

void System::renew(Mat K) const {
    Mat replacement = make_matrix().release();
    MatNullSpace rigid_motions = nullptr;
    SOFT_PETSC(MatGetNearNullSpace(K, &rigid_motions));
    SOFT_PETSC(MatSetNearNullSpace(replacement, rigid_motions));
    SOFT_PETSC(MatHeaderReplace(K, &replacement));
}

Evaluation System::evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns) {
    Evaluation at = assembler_.evaluate(x, levels, R, K, columns, NewEntries::omit);
    if (!at.pattern_grew) return at;
    contact_.couple();
    renew(K);
    at = assembler_.evaluate(x, levels, R, K, columns, NewEntries::insert);
    at.pattern_grew = true;
    return at;
}

bool System::has_initial_stress() const {
    return std::ranges::any_of(fe_.rubbers,
                               [](const auto& rubber) { return material::reference_stress_Pa(rubber) > 0.0; });
}

void System::accept_step(Vec x) {
    contact_.start_friction(x);
    if (state_.internal().is_empty()) return;
    state_.read(x);
    state_.internal().accept(state_.inelastic_step().dissipated_J);
}

bool System::has_kinks() const {
    if (state_.internal().soften()) return true;
    return std::ranges::any_of(fe_.rubbers, [](const auto& rubber) { return material::fibers_of(rubber).has_value(); });
}

bool System::has_energy() const { return std::ranges::all_of(fe_.rubbers, material::has_symmetric_tangent); }
bool System::has_symmetric_tangent() const { return has_energy() && !contact_.has_friction(); }

}  // namespace soft::fem
