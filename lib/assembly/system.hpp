#pragma once
/// The equilibrium of a case on the free unknowns x = (displacements, scaled pressures) at a load factor:
///   R(x, lambda) = internal forces - lambda x load(x),    K = dR/dx,
/// with load(x) = sum over the case's loads of pressure x force per unit pressure, plus the dead tractions. Collective over the communicator.
/// Held by assembly/system_test (Taylor remainders of K, rank independence) and the verification suite.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "assembly/cavity.hpp"
#include "assembly/dof_map.hpp"
#include "assembly/materials.hpp"
#include "element/solid_kernel.hpp"

namespace soft::assembly {

/// Outcome of one evaluation; an inverted cell is an expected failure.
struct Evaluation {
    double min_jacobian = 1;             ///< least det F over all quadrature points
    mesh::Index worst_cell = -1;         ///< cell that holds it
    double force_scale = 0;              ///< root of the sum of squares of all cells' nodal forces, before they cancel
    [[nodiscard]] bool admissible() const noexcept { return min_jacobian > 0.0; }
};

/// How far the rubber is stretched at a state.
struct StretchSummary {
    double p99 = 1;                      ///< largest principal stretch exceeded in 1 % of the volume
    double largest = 1;
    double min_jacobian = 1;
};

class System {
public:
    System(const model::Case& input, MPI_Comm comm);

    [[nodiscard]] linalg::Vector make_vector() const;
    [[nodiscard]] linalg::Matrix make_matrix() const;

    /// Fills R and load; with K also the tangent. Where the result is not admissible they are unfinished.
    Evaluation evaluate(Vec x, double load_factor, Vec R, Vec load, Mat K);

    /// Volume [m^3] of the first loaded cavity, whole actuator, its gradient by x in `gradient` (may be null).
    /// empty where no cavity is loaded.
    std::optional<double> enclosed_volume(Vec x, Vec gradient);

    /// False where a law is a stress without an energy; a pressure on a surface with a free rim does not count.
    [[nodiscard]] bool has_symmetric_tangent() const;

    /// True where a law puts the undeformed body under stress: it is then no state of equilibrium without load.
    [[nodiscard]] bool starts_under_stress() const;

    /// Value of output `index` is dot(output_weights(index), x).
    [[nodiscard]] Vec output_weights(std::size_t index) const { return output_weights_[index]; }
    [[nodiscard]] std::size_t output_count() const { return output_weights_.size(); }

    /// Energy stored in the rubber of the modelled part [J].
    [[nodiscard]] double stored_energy(Vec x);
    [[nodiscard]] StretchSummary stretches(Vec x);

    /// Nodal displacements [point x 3] (axisymmetric: x, r, 0) and pressures [point] [Pa] (cell values averaged at
    /// the nodes; empty without a pressure unknown) on rank 0, empty elsewhere.
    struct Fields {
        std::vector<double> displacement_m, pressure_Pa;
    };
    [[nodiscard]] Fields gather_fields(Vec x);

    [[nodiscard]] const DofMap& dofs() const noexcept { return map_; }
    [[nodiscard]] const model::Case& input() const noexcept { return input_; }
    [[nodiscard]] MPI_Comm comm() const noexcept { return comm_; }

private:
    /// Cells of one type and one material.
    struct CellGroup {
        const element::ReferenceCell* reference;
        const AnyRubber* rubber;
        std::vector<mesh::Index> cells;
        std::vector<PetscInt> dofs;               // [cell][unknown], -1 where held
        std::vector<int> local;                   // the same as positions in local_
    };
    /// One cell's numbers, component-major, reused from cell to cell.
    struct LocalCell {
        explicit LocalCell(const element::ReferenceCell& reference)
            : X(reference.displacement_dofs()), unknowns(reference.dofs()) {}
        std::vector<double> X, unknowns;
        [[nodiscard]] element::CellInput input(double pressure_scale_Pa) const {
            return {X, {unknowns.data(), X.size()}, {unknowns.data() + X.size(), unknowns.size() - X.size()},
                    pressure_scale_Pa};
        }
    };

    void make_groups();
    void make_local_copy();
    void make_dead_load();
    [[nodiscard]] std::vector<int> local_positions(std::span<const PetscInt> dofs) const;
    void read_state(Vec x);
    void gather_cell(const CellGroup& group, std::size_t index, LocalCell& local) const;
    void gather_surface(const SurfaceCell& cell, std::vector<double>& x) const;
    void add_cells(const CellGroup& group, Vec R, Mat K, Evaluation& result) const;
    void add_loads(double load_factor, Vec load, Mat K);
    void add_nodal_pressures(mesh::Index cell, const double* value, std::vector<double>& pressure_Pa,
                             std::vector<int>& shares) const;
    void add_rims(const EnclosedVolume& volume, Vec gradient, double& sum) const;

    /// Calls visit(point, rubber) for every quadrature point of this rank's cells at the state last read.
    template <class Visit>
    void for_each_point(Visit&& visit) const;

    const model::Case& input_;
    MPI_Comm comm_;
    int rank_ = 0;
    std::vector<element::ReferenceCell> references_;
    std::vector<AnyRubber> rubbers_;              // by region
    DofMap map_;
    SurfaceTables tables_;
    std::vector<CellGroup> groups_;
    std::vector<LoadSurface> loads_;
    std::optional<EnclosedVolume> volume_;
    std::vector<linalg::Vector> output_weights_;
    linalg::Vector dead_load_;                    // of the tractions, at load factor 1

    std::vector<PetscInt> ghosts_;                // unknowns this rank reads, sorted
    std::vector<double> local_;                   // their values, then a zero for held components
    linalg::Vector ghost_values_;
    linalg::Scatter ghost_scatter_;
};

}  // namespace soft::assembly
