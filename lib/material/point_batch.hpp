#pragma once
/// The law at many points at once: what response.hpp says of one point, with the kinematics and the chain rules on vectors of
/// points and only the law's own slopes one after the other. Component c of point q lies at [c * stride + q].
/// Tested by material/point_batch_test (every law against response.hpp) and, through the elements, by element/matrix_test.
#include <span>
#include <vector>

#include "core/lanes.hpp"
#include "material/response.hpp"

namespace soft::material {

/// Points of one law. The lanes beyond the last point hold a copy of it.
struct PointBatch {
    explicit PointBatch(int count, Components wanted = Components::all);

    int points;
    Components components;            ///< those of P and A that are wanted; planar F must be
    int stride;                       ///< padded(points)
    std::vector<double> F;            ///< [9]
    std::vector<double> p;            ///< pressure unknown's value [Pa] (mixed form only)
    std::vector<FiberAxes> axes;      ///< one a point; only rubbers with fibres look at them
    std::vector<double> first_piola;  ///< [9] P = dW/dF [Pa]
    std::vector<double> tangent;      ///< [81] A = dP/dF [Pa] (only if asked for)
    std::vector<double> theta;        ///< Theta (mixed form only)
    std::vector<double> dtheta_dF;    ///< [9] (mixed form only)
    std::vector<double> invariants;   ///< [3] I1, I2, J
    std::vector<double> slopes;       ///< [15] W_a, dW_a/dI_b, dTheta/dI_a: work space

    [[nodiscard]] Tensor gradient(int q) const;
    void set_gradient(int q, const Tensor& value);
    /// P, A, Theta and dTheta/dF of a point, and the other way.
    [[nodiscard]] PointResponse response(int q) const;
    void set_response(int q, const PointResponse& value, Wanted wanted);
};

namespace detail {

/// I1, I2, J of all points.
void find_invariants(PointBatch& batch);
/// P, A and dTheta/dF of all points from the slopes.
void apply_chain_rules(PointBatch& batch, Form form, Symmetry symmetry, Wanted wanted);
void set_slopes(PointBatch& batch, int q, const LawSlopes& slopes);

template <class L>
void respond_one_by_one(const Rubber<L>& rubber, Form form, Wanted wanted, PointBatch& batch) {
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

/// Fills what the law answers at batch.F: mixed_response or displacement_response at every point.
/// A law without a mixed form in it is a std::logic_error.
template <Law L>
void respond(const Rubber<L>& rubber, Form form, Wanted wanted, PointBatch& batch) {
    if constexpr (std::same_as<L, LinearElastic>) {
        detail::respond_one_by_one(rubber, form, wanted, batch);
    } else {
        detail::find_invariants(batch);
        for (int q = 0; q < batch.points; ++q) {
            const double* at = &batch.invariants[q];
            const Invariants<double> I{at[0], at[batch.stride]};
            const double J = at[2 * batch.stride];
            if (form != Form::mixed)
                detail::set_slopes(batch, q, displacement_slopes(rubber, I, J));
            else if constexpr (StressLaw<L>)
                throw std::logic_error("respond: a stress without an energy has no mixed form");
            else
                detail::set_slopes(batch, q, mixed_slopes(rubber, I, J, batch.p[q]));
        }
        detail::apply_chain_rules(batch, form, StressLaw<L> ? Symmetry::none : Symmetry::energy, wanted);
        if (goes_beyond_invariants(rubber))
            for (int q = 0; q < batch.points; ++q) {
                PointResponse point = batch.response(q);
                add_beyond_invariants(rubber, batch.axes[q], batch.gradient(q), wanted, point);
                batch.set_response(q, point, wanted);
            }
    }
}

}  // namespace soft::material
