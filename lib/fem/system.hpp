#pragma once
/// The equilibrium of a case on the free unknowns x = (displacements, scaled pressures) under given load levels:
///   R(x, levels) = internal forces - sum over the loads of level x force(x),    K = dR/dx,
/// with pressure x force per unit pressure for the pressure loads, dead forces for tractions and body forces, and
/// prescribed displacements as values of the nodes of the cells (and facets) that they move. Collective over the communicator.
/// Tested by fem/system_test, fem/loads_test (Taylor remainders, rank independence) and the verification suite.
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "fem/cavity.hpp"
#include "fem/dof_map.hpp"
#include "fem/face_shape.hpp"
#include "fem/load_levels.hpp"
#include "fem/materials.hpp"
#include "fem/reaction.hpp"
#include "fem/rotation.hpp"
#include "fem/solid_kernel.hpp"
#include "linalg/block_entries.hpp"

namespace soft::fem {

/// Outcome of one evaluation; an inverted cell is an expected failure.
struct Evaluation {
    double min_jacobian = 1;      ///< smallest det F over all quadrature points
    mesh::Index worst_cell = -1;  ///< cell where it occurs
    double force_scale = 0;       ///< root of the sum of squares of all cells' nodal forces, before they cancel
    [[nodiscard]] bool admissible() const noexcept { return min_jacobian > 0.0; }
};

/// Stretch and stored energy of the rubber at a state.
struct StretchSummary {
    double p99 = 1;  ///< largest principal stretch exceeded in 1 % of the volume
    double largest = 1;
    double min_jacobian = 1;
    Vector3 max_at_m{};          ///< undeformed position of the largest stretch; x, r, 0 in a section
    double stored_energy_J = 0;  ///< of the modelled part
    double max_energy_J_m3 = 0;  ///< per undeformed volume, at an integration point
};

/// A direction of the load levels, and the vector that receives -dR/d(direction).
struct LoadColumn {
    LoadLevels direction;
    Vec out = nullptr;
};

class System {
public:
    System(const model::Case& input, MPI_Comm comm);

    [[nodiscard]] linalg::Vector make_vector() const;
    [[nodiscard]] linalg::Matrix make_matrix() const;

    /// Fills R and the columns, and with K also the tangent (required by columns that move a face). Prescribes the levels' motions.
    /// If the result is not admissible they are incomplete.
    Evaluation evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns = {});

    /// Sets the prescribed displacements, and for reactions the loads, that the functions below use in addition to x; evaluate()
    /// also does so.
    void prescribe(const LoadLevels& levels);

    /// Volume [m^3] of one of model::measured_cavities, whole actuator. `gradient` by x and `by_motion` by the level of
    /// each motion are overwritten; nullptr and empty if not needed.
    double enclosed_volume(std::size_t cavity, Vec x, Vec gradient, std::span<double> by_motion = {});
    [[nodiscard]] std::size_t cavity_count() const { return volumes_.size(); }
    /// The same of all cavities of a pressure load together; 0 for a load on a face.
    double load_volume(std::size_t load, Vec x, Vec gradient, std::span<double> by_motion = {});
    [[nodiscard]] bool encloses_volume(std::size_t load) const { return !load_cavities_.at(load).empty(); }

    /// Value of an output (SI, model::unit_of) under the levels last prescribed; `gradient` by x and the derivatives by the
    /// levels are overwritten; nullptr if not needed. Angles lie in (-pi, pi].
    double output(std::size_t index, Vec x, Vec gradient, LoadLevels* by_levels = nullptr);
    [[nodiscard]] std::size_t output_count() const { return input_.outputs.size(); }

    /// False if a law is a stress without an energy. Does not account for a pressure on a surface with a free rim.
    [[nodiscard]] bool has_symmetric_tangent() const;
    /// Whether a material has fibres: the tangent jumps where a fibre becomes slack or taut.
    [[nodiscard]] bool has_fibers() const;

    /// True if a law has stress in the undeformed state, which is then not in equilibrium without load.
    [[nodiscard]] bool has_initial_stress() const;

    /// Power of the loads on the modelled part [W], in the time unit of `velocity` of the unknowns and `rates`
    /// of the levels; prescribed motions contribute with the forces that move their nodes. Prescribes the levels.
    [[nodiscard]] double load_power(Vec x, Vec velocity, const LoadLevels& levels, const LoadLevels& rates);

    /// Energy stored in the rubber of the modelled part [J].
    [[nodiscard]] double stored_energy(Vec x);
    [[nodiscard]] StretchSummary stretches(Vec x);

    /// Nodal displacements [point x 3] (axisymmetric: x, r, 0), including prescribed ones, and pressures [point] [Pa] (cell values
    /// averaged at the nodes; empty without a pressure unknown) on rank 0, empty elsewhere.
    struct Fields {
        std::vector<double> displacement_m, pressure_Pa;
    };
    [[nodiscard]] Fields gather_fields(Vec x);
    /// The reverse: sets the displacement unknowns of x to the values of a nodal field [point x 3], which rank 0 provides;
    /// pressures, fixed and prescribed components are unchanged.
    void spread_displacements(std::span<const double> nodal, Vec x) const;

    [[nodiscard]] const DofMap& dofs() const noexcept { return map_; }
    [[nodiscard]] const model::Case& input() const noexcept { return input_; }
    [[nodiscard]] MPI_Comm comm() const noexcept { return comm_; }

private:
    /// Cells of one type and one material.
    struct CellGroup {
        const fem::ReferenceCell* reference;
        const AnyRubber* rubber;
        std::vector<mesh::Index> cells;
        std::vector<PetscInt> dofs;  // [cell][unknown], negative for fixed and prescribed components
        std::vector<int> local;      // the same as positions in local_
    };
    /// Workspace for one cell, component-major, reused from cell to cell.
    struct LocalCell {
        explicit LocalCell(const fem::ReferenceCell& reference)
            : X(reference.displacement_dofs()), unknowns(reference.dofs()) {}
        std::vector<double> X, unknowns;
        [[nodiscard]] fem::CellInput input(double pressure_scale_Pa) const {
            return {X,
                    {unknowns.data(), X.size()},
                    {unknowns.data() + X.size(), unknowns.size() - X.size()},
                    pressure_scale_Pa};
        }
    };

    void make_groups();
    void make_loads();
    void make_outputs();
    void make_local_copy();
    void find_block_indices(Mat K);
    [[nodiscard]] linalg::Vector assembled(const SparseVector& sparse) const;
    template <class Visit>
    void for_each_surface_cell(Visit&& visit);
    [[nodiscard]] std::vector<int> local_positions(std::span<const PetscInt> dofs) const;
    void read_state(Vec x);
    void gather_cell(const CellGroup& group, std::size_t index, LocalCell& local) const;
    void gather_undeformed(const SurfaceCell& cell, std::vector<double>& X) const;
    void gather_surface(const SurfaceCell& cell, std::vector<double>& x) const;
    /// K nullptr: no tangent is computed.
    void add_cells(std::size_t group, Vec R, linalg::BlockAdder* K, std::span<const LoadColumn> columns,
                   Evaluation& result) const;
    static void add_residual(mesh::Index cell, std::span<const PetscInt> dofs, const fem::CellOutput& out, Vec R,
                             Evaluation& result);
    void add_pressures(std::size_t load, const LoadLevels& levels, Vec R, linalg::BlockAdder* K,
                       std::span<const LoadColumn> columns) const;
    void add_dead_loads(const LoadLevels& levels, Vec R, std::span<const LoadColumn> columns) const;
    /// out += factor x matrix x (velocity of the prescribed components), for one cell or facet.
    void add_moved(const LoadColumn& column, double factor, std::span<const PetscInt> dofs,
                   std::span<const double> matrix) const;
    void add_slope(Vec gradient, std::span<double> by_motion, std::span<const PetscInt> dofs,
                   std::span<const double> slope) const;
    void finish_slope(Vec gradient, std::span<double> by_motion) const;
    [[nodiscard]] double moved_by(PetscInt number, std::span<const double> levels) const;
    double rotation(const Rotation& rotation, Vec x, Vec gradient, std::span<double> by_motion);
    struct LinearOutput;
    struct ShapeOutput;
    [[nodiscard]] LinearOutput make_linear(const model::Output& output, const Vector3& direction) const;
    [[nodiscard]] Rotation make_rotation(const model::Output& output);
    [[nodiscard]] ShapeOutput make_shape(const model::Output& output);
    [[nodiscard]] Reaction complete_reaction(const model::Output& output);
    [[nodiscard]] SurfaceCell nodes_on_rank_0(std::span<const mesh::Index> nodes) const;
    double shape(const ShapeOutput& output, Vec x, Vec gradient, std::span<double> by_motion);
    double reaction(const Reaction& reaction, Vec x, Vec gradient, LoadLevels* by_levels);
    double cell_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const;
    double pressure_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const;
    double dead_reactions(const Reaction& reaction, Vec gradient, LoadLevels* by_levels) const;
    void add_nodal_pressures(mesh::Index cell, const double* value, std::vector<double>& pressure_Pa,
                             std::vector<int>& shares) const;
    double add_volumes(std::span<const std::size_t> cavities, Vec x, Vec gradient, std::span<double> by_motion);
    void add_rims(const EnclosedVolume& volume, Vec gradient, std::span<double> by_motion, double& sum) const;

    struct PointLocation {
        const CellGroup* group;
        std::size_t cell, point;  // of the group, of the cell
    };
    [[nodiscard]] Vector3 position_of(const PointLocation& location) const;
    /// Calls visit(point, rubber, location) for every quadrature point of this rank's cells at the state last read.
    template <class Visit>
    void for_each_point(Visit&& visit) const;

    const model::Case& input_;
    MPI_Comm comm_;
    int rank_ = 0;
    std::vector<fem::ReferenceCell> references_;
    std::vector<AnyRubber> rubbers_;  // by region
    DofMap map_;
    SurfaceTables tables_;
    std::vector<CellGroup> groups_;
    std::vector<LoadSurface> loads_;                       // by Case::loads
    std::vector<EnclosedVolume> volumes_;                  // by model::measured_cavities
    std::vector<std::vector<std::size_t>> load_cavities_;  // of each load, into volumes_
    std::vector<linalg::Vector> tractions_, body_forces_;  // at level 1
    struct LinearOutput {
        linalg::Vector weights;
        std::vector<double> by_motion;
    };
    /// The whole face, its mirror images included, as node and the sign of its components. On rank 0 only.
    struct ShapeOutput {
        FaceShape shape;
        SurfaceCell at_nodes;  // of the mesh
        struct Image {
            std::size_t node;
            Vector3 signs;
        };
        std::vector<Image> images;  // by FaceShape::X
    };
    using OutputForm = std::variant<LinearOutput, Rotation, ShapeOutput, Reaction>;
    std::vector<OutputForm> outputs_;  // by Case::outputs
    LoadLevels levels_;                // last prescribed
    /// Indices of the blocks of cells and facets in matrices of the pattern used last.
    struct MatrixIndices {
        PetscObjectId matrix = 0;
        PetscObjectState state = -1;
        std::uint64_t pattern = 0;
        std::vector<linalg::BlockIndices> groups, loads;
    };
    MatrixIndices block_indices_;

    std::vector<PetscInt> ghosts_;  // unknowns this rank reads, sorted
    std::vector<double> local_;     // their values, a zero for fixed components, the prescribed values by slot
    linalg::Vector ghost_values_;
    linalg::Scatter ghost_scatter_;
};

}  // namespace soft::fem
