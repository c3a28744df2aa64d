#pragma once
/// Viscoelasticity and softening on top of a law: they act on the isochoric stress of its energy W(F), the law without fibres and change
/// of volume, which stay elastic. Second Piola-Kirchhoff stress, dS = 2 dW/dC:
///   S = S_inf + sum_i Q_i,   S_inf = s eta 2 dW/dC,   dQ_i/dt + Q_i/tau_i = g_i dS_inf/dt
///   eta = 1 - (1/r) erf((W_max - W)/(m + beta W_max)) below the largest energy W_max so far, 1 at and beyond it
///   s = 1, or 1/(1 + sum g_i) where the law's constants are the instantaneous ones.
/// A step of length dt in which S_inf changes linearly (z = dt/tau, e = exp(-z), h = (1 - e)/z):
///   Q_i' = e_i Q_i + g_i h_i (S_inf' - S_inf),   S' = factor eta 2 dW/dC + H,
///   factor = s (1 + sum g_i h_i),   H = sum_i (e_i Q_i - g_i h_i S_inf)
/// so that S' has the energy factor Phi(W) + H : E with Phi' = eta: its tangent is symmetric.
/// Errors of a step: if S_inf has the second derivative S'', Q_i' is wrong by g_i tau_i^2 (z/2 - 1 + (1 + z/2) e) S''; the errors of
/// steps of equal length add up to 1/(1 - e) times that.
/// Sources: Simo, CMAME 60 (1987) 153; Holzapfel, Nonlinear Solid Mechanics (2000), 6.10, for the model; Taylor, Pister, Goudreau, IJNME 2
/// (1970) 45, for the step; Ogden, Roxburgh, Proc. R. Soc. A 455 (1999) 2861, with the constants of the usual r, m, beta form.
/// Tested by material/inelastic_test, fem/internal_variables_test.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "math/dual.hpp"
#include "math/tensor.hpp"

namespace soft::material {

/// Components 11, 22, 33, 12, 13, 23.
using SymmetricTensor = std::array<double, 6>;

struct Softening {
    double r = 2, m_Pa = 1, beta = 0;

    bool operator==(const Softening&) const = default;

    /// Phi(W) at a largest energy so far, zero at W = 0.
    [[nodiscard]] double energy(double W, double W_max) const;
    /// Its derivatives eta and d eta/dW.
    struct Slopes {
        double eta = 1, slope = 0;
    };
    [[nodiscard]] Slopes slopes(double W, double W_max) const { return W >= W_max ? Slopes{} : slopes_below(W, W_max); }
    /// Lost since the virgin state: W - Phi(W) at W = W_max.
    [[nodiscard]] double dissipated(double W_max) const;

private:
    [[nodiscard]] Slopes slopes_below(double W, double W_max) const;
};

struct Inelastic {
    std::vector<double> moduli, times_s;  ///< g_i and tau_i; empty: no viscoelasticity
    bool instantaneous = false;           ///< meaning of the law's constants
    std::optional<Softening> softening;

    bool operator==(const Inelastic&) const = default;

    /// s
    [[nodiscard]] double scale() const;
};

/// The coefficients of a step for one material.
struct StepCoefficients {
    double factor = 1;
    std::vector<double> decay, share;            ///< e_i and g_i h_i
    std::vector<double> half_decay, half_share;  ///< the same of half the step
    bool is_elastic = false;    ///< every step is infinitely fast: Q_i is elastic stress, and does not dissipate
    std::vector<double> error;  ///< of the sum of Q_i per S'', steps of equal length
};
/// `dt_s` may be infinite: the long-term response.
[[nodiscard]] StepCoefficients step_coefficients(const Inelastic& inelastic, double dt_s);
/// Of a path that is infinitely fast throughout.
[[nodiscard]] StepCoefficients instantaneous_coefficients(const Inelastic& inelastic);

/// The energy of a step from that of the law, W, without H : E. Only its derivatives are meant; its value is not computed.
struct EnergyOfStep {
    double factor = 1;
    const Softening* softening = nullptr;
    double W_max = 0;

    template <int N>
    [[nodiscard]] Dual<N> operator()(const Dual<N>& W) const {
        if (softening == nullptr) return factor == 1.0 ? W : factor * W;
        const Softening::Slopes by_W = softening->slopes(W.v, W_max);
        return Dual<N>::compose(W, W.v, factor * by_W.eta, factor * by_W.slope);
    }
    /// The derivative of the energy by W.
    [[nodiscard]] double slope(double W) const {
        return softening == nullptr ? factor : factor * softening->slopes(W, W_max).eta;
    }
};

/// What a step needs of the internal variables at the points of a cell. Does not own them.
struct StepMemory {
    double factor = 1;
    const Softening* softening = nullptr;
    std::span<const double> W_max;                ///< by point; only with softening
    std::span<const SymmetricTensor> overstress;  ///< H by point; empty: none

    [[nodiscard]] EnergyOfStep energy(int point) const {
        return {factor, softening, softening == nullptr ? 0.0 : W_max[static_cast<std::size_t>(point)]};
    }
};

/// 3 x 3 components of a symmetric tensor.
[[nodiscard]] Tensor full(const SymmetricTensor& symmetric);
/// F^-1 P of a symmetric S.
[[nodiscard]] SymmetricTensor second_piola(const Tensor& F, const Tensor& first_piola);
/// E = (F^T F - I)/2.
[[nodiscard]] SymmetricTensor green_strain(const Tensor& F);
/// a : b
[[nodiscard]] double contract(const SymmetricTensor& a, const SymmetricTensor& b);

}  // namespace soft::material
