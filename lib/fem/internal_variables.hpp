#pragma once
/// Internal variables of inelastic materials (material/inelastic.hpp) at the quadrature points: their values at the start of the step,
/// and what a step to a trial state does to them. A step leads from the state accepted last, at its time, to the trial state at the time
/// set last; where the case has no time it is infinitely slow or infinitely fast (model::PathSettings::modulus).
/// They are not interpolated: another mesh computes its own along the path.
/// Tested by fem/internal_variables_test.
#include <span>
#include <vector>

#include "fem/discretization.hpp"
#include "fem/solid_kernel.hpp"
#include "material/point_history.hpp"

namespace soft::fem {

struct PointLocation {
    const CellGroup& group;
    std::size_t cell, point;  ///< of the group, of the cell
};

class InternalVariables {
public:
    explicit InternalVariables(const Discretization& fe);

    /// No material is inelastic; the same on every rank.
    [[nodiscard]] bool is_empty() const noexcept { return is_empty_; }
    /// Whether a material softens: its tangent jumps where loading turns into unloading.
    [[nodiscard]] bool soften() const noexcept { return soften_; }
    /// The shortest relaxation time; 0 without viscoelasticity or where the case has no time.
    [[nodiscard]] double shortest_time_s() const noexcept { return shortest_time_s_; }

    /// Sets the time of trial states.
    void set_time(double time_s);
    /// Of the state accepted last.
    [[nodiscard]] double start_time_s() const noexcept { return start_s_; }

    /// Points whose energy W is below the largest one by less than this share of it count as being loaded, so that their tangent does not
    /// depend on rounding: for derivatives of states that return to where they were. Does not affect step_at.
    void set_margin(double share);

    /// Fills what the step needs at the points of a cell; false for an elastic cell.
    bool read(const CellGroup& group, std::size_t cell, material::StepMemory& memory) const;
    /// The step at a point of a trial state.
    [[nodiscard]] material::PointStep step_at(const PointLocation& at, const PointState& point);
    /// Accepts the trial state for which step_at was called last, at every point; `dissipated_J`: by this rank's points. Collective.
    void accept(double dissipated_J);

    /// Number of accepted steps and of restarts.
    [[nodiscard]] std::int64_t accepted_steps() const noexcept { return accepted_; }

    /// Since the start of the path, of the modelled part [J].
    [[nodiscard]] double dissipated_J() const noexcept { return dissipated_J_; }
    /// Estimated relative error of the stress from the squared errors and stresses of a step, summed over the volume of all ranks; the
    /// stress is the largest so far. nullopt where no estimate exists: in the first step of a stage, and without viscoelasticity.
    [[nodiscard]] std::optional<double> relative_error(double error2, double stress2);
    /// A stage begins: the rates of the stress jump.
    void forget_rates() noexcept { last_step_s_ = 0; }

    /// Everything above, of all ranks; empty on all ranks but the first. Collective.
    [[nodiscard]] std::vector<double> gather() const;
    /// False if it does not fit the case. Collective; every rank has all values.
    [[nodiscard]] bool restore(std::span<const double> values);

private:
    struct Group {
        const CellGroup* cells;
        const material::Inelastic* inelastic;
        std::size_t size;  ///< numbers per point
        material::StepCoefficients step;
        std::vector<double> values, next;  ///< [cell][point][size]: at the start and at the end of the step
        std::vector<double> W_max;         ///< [cell][point] with softening, less the margin
        std::vector<material::SymmetricTensor> overstress;  ///< [cell][point] with viscoelasticity: H of the step
    };
    [[nodiscard]] const Group* find(const CellGroup& group) const;
    [[nodiscard]] static std::size_t index_of(const Group& group, const PointLocation& at);
    /// The list of a point.
    template <class List>
    [[nodiscard]] static auto at_point(List& list, const Group& group, std::size_t point) {
        return std::span(list).subspan(point * group.size, group.size);
    }

    const Discretization& fe_;
    std::vector<Group> groups_;  // of inelastic materials
    std::vector<int> index_;     // by group of cells: in groups_, or -1
    enum class Clock { runs, is_infinitely_slow, is_infinitely_fast } clock_;
    bool is_empty_ = true, soften_ = false;
    double shortest_time_s_ = 0, margin_ = 0;
    double start_s_ = 0, time_s_ = 0, step_s_ = 0, last_step_s_ = 0;
    std::int64_t accepted_ = 0;
    double dissipated_J_ = 0, largest_stress2_ = 0;
    std::optional<double> prepared_for_s_;  // length of the step of the groups' coefficients; nullopt: values are new
};

}  // namespace soft::fem
