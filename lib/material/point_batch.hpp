#pragma once
/// Evaluation of a law at many points: the same results as response.hpp for one point. The kinematics and the chain rules are
/// vectorised over the points; only the derivatives of the energy are computed point by point. Component c of point q is stored at
/// [c * stride + q].
/// Tested by material/point_batch_test (every law against response.hpp) and, through the elements, by fem/matrix_test.
#include <span>
#include <vector>

#include "material/response.hpp"
#include "math/lanes.hpp"

namespace soft::material {

/// Points of one law. The lanes after the last point contain copies of it.
struct PointBatch {
    explicit PointBatch(int count, Components wanted = Components::all);

    int points;
    Components components;               ///< requested components of P and A; planar requires a planar F
    int stride;                          ///< padded(points)
    std::vector<double> F;               ///< [9]
    std::vector<double> p;               ///< value of the pressure unknown [Pa] (mixed form only)
    std::vector<FiberAxes> axes;         ///< one per point; used only by rubbers with fibres
    std::vector<double> first_piola;     ///< [9] P = dW/dF [Pa]
    std::vector<double> tangent;         ///< [81] A = dP/dF [Pa] (only if requested)
    std::vector<double> theta;           ///< Theta (mixed form only)
    std::vector<double> dtheta_dF;       ///< [9] (mixed form only)
    std::vector<double> invariants;      ///< [3] I1, I2, J
    std::vector<double> slopes;          ///< [15] W_a, dW_a/dI_b, dTheta/dI_a: work space
    const StepMemory* memory = nullptr;  ///< internal variables of the points; nullptr: elastic

    [[nodiscard]] Tensor gradient(int q) const;
    void set_gradient(int q, const Tensor& value);
    /// Reads and writes P, A, Theta and dTheta/dF of a point.
    [[nodiscard]] PointResponse response(int q) const;
    void set_response(int q, const PointResponse& value, Wanted wanted);
    [[nodiscard]] EnergyOfStep energy(int q) const { return memory == nullptr ? EnergyOfStep{} : memory->energy(q); }
};

namespace detail {

/// Computes I1, I2, J at all points.
void compute_invariants(PointBatch& batch);
/// Computes P, A and dTheta/dF at all points from the slopes.
void apply_chain_rules(PointBatch& batch, Form form, Symmetry symmetry, Wanted wanted);
void set_slopes(PointBatch& batch, int q, const LawSlopes& slopes);
/// Adds F H and its derivative at all points.
void add_overstress(PointBatch& batch, Wanted wanted);

template <class L>
void evaluate_one_by_one(const Rubber<L>& rubber, Form form, Wanted wanted, PointBatch& batch) {
    PointResponse point;
    for (int q = 0; q < batch.points; ++q) {
        if (form == Form::mixed)
            mixed_response(rubber, batch.axes[q], batch.gradient(q), batch.p[q], wanted, point);
        else
            displacement_response(rubber, batch.axes[q], batch.gradient(q), wanted, point);
        batch.set_response(q, point, wanted);
    }
}

}  // namespace detail

/// Evaluates mixed_response or displacement_response at batch.F at every point.
/// Throws std::logic_error if the mixed form is requested for a law without it.
template <Law L>
void evaluate_batch(const Rubber<L>& rubber, Form form, Wanted wanted, PointBatch& batch) {
    if constexpr (std::same_as<L, LinearElastic>) {
        detail::evaluate_one_by_one(rubber, form, wanted, batch);
    } else {
        detail::compute_invariants(batch);
        for (int q = 0; q < batch.points; ++q) {
            const double* at = &batch.invariants[q];
            const Invariants<double> I{at[0], at[batch.stride]};
            const double J = at[2 * batch.stride];
            const EnergyOfStep step = batch.energy(q);
            if (form != Form::mixed)
                detail::set_slopes(batch, q, displacement_slopes(rubber, I, J, step));
            else if constexpr (StressLaw<L>)
                throw std::logic_error("evaluate_batch: a stress without an energy has no mixed form");
            else
                detail::set_slopes(batch, q, mixed_slopes(rubber, I, J, batch.p[q], step));
        }
        detail::apply_chain_rules(batch, form, StressLaw<L> ? Symmetry::none : Symmetry::energy, wanted);
        if (has_terms_beyond_invariants(rubber))
            for (int q = 0; q < batch.points; ++q) {
                PointResponse point = batch.response(q);
                add_terms_beyond_invariants(rubber, batch.axes[q], batch.gradient(q), wanted, point, batch.energy(q));
                batch.set_response(q, point, wanted);
            }
        if (batch.memory != nullptr && !batch.memory->overstress.empty()) detail::add_overstress(batch, wanted);
    }
}

}  // namespace soft::material
