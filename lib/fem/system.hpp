#pragma once
/// A case ready to solve: its discretization, and the parts that compute from a vector of unknowns. The parts share one local copy of
/// the state: prescribe() sets the levels that volumes, outputs and fields use in addition to x; evaluate() and load_power() do so too.
/// Tested by fem/system_test.
#include "fem/assembler.hpp"
#include "fem/cavity_volumes.hpp"
#include "fem/contact.hpp"
#include "fem/fields.hpp"
#include "fem/outputs.hpp"

namespace soft::fem {

class System {
public:
    /// Throws Error (bad_input) as Discretization and Outputs do. The case must outlive the system.
    System(const model::Case& input, MPI_Comm comm, std::span<const int> cell_rank = {});

    [[nodiscard]] const Discretization& discretization() const noexcept { return fe_; }
    [[nodiscard]] const model::Case& input() const noexcept { return fe_.input; }
    [[nodiscard]] MPI_Comm comm() const noexcept { return fe_.comm; }
    [[nodiscard]] const DofMap& dofs() const noexcept { return fe_.dofs; }
    [[nodiscard]] linalg::Vector make_vector() const { return fe_.make_vector(); }
    /// Zero, with the pattern of unknowns that share a cell or that contact couples (contact().couplings()).
    [[nodiscard]] linalg::Matrix make_matrix() const;

    void prescribe(const LoadLevels& levels) { state_.prescribe(levels); }
    /// See Assembler. Where contact couples unknowns beyond the pattern of K, K gets another pattern behind its handle (pattern_grew).
    Evaluation evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns = {});
    /// Replaces the matrix behind the handle by one of make_matrix().
    void renew(Mat K) const;
    [[nodiscard]] Contact& contact() noexcept { return contact_; }
    [[nodiscard]] const Contact& contact() const noexcept { return contact_; }
    [[nodiscard]] InternalVariables& internal() noexcept { return state_.internal(); }
    [[nodiscard]] const InternalVariables& internal() const noexcept { return state_.internal(); }
    /// A step of the path is complete: the next one starts from x at the levels prescribed. Collective.
    void accept_step(Vec x);
    [[nodiscard]] Assembler& assembler() noexcept { return assembler_; }
    [[nodiscard]] CavityVolumes& volumes() noexcept { return volumes_; }
    [[nodiscard]] const CavityVolumes& volumes() const noexcept { return volumes_; }
    [[nodiscard]] Outputs& outputs() noexcept { return outputs_; }
    [[nodiscard]] Fields& fields() noexcept { return fields_; }

    /// False if a law is a stress without an energy.
    [[nodiscard]] bool has_energy() const;
    /// False without an energy, and with friction. Does not account for a pressure on a surface with a free rim.
    [[nodiscard]] bool has_symmetric_tangent() const;
    /// Whether the tangent jumps: where a fibre becomes slack or taut, and where softened rubber is unloaded or loaded again.
    [[nodiscard]] bool has_kinks() const;
    /// True if a law has stress in the undeformed state, which is then not in equilibrium without load.
    [[nodiscard]] bool has_initial_stress() const;

private:
    Discretization fe_;
    contact::Potential potential_;
    LocalState state_;
    Loads loads_;
    Contact contact_;
    Assembler assembler_;
    CavityVolumes volumes_;
    Outputs outputs_;
    Fields fields_;
};

}  // namespace soft::fem
