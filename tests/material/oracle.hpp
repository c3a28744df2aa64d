#pragma once
/// W(F), or P(F) if there is no energy, with F as nine independent variables: gradient and Hessian are P and A. Independent of the
/// kernels: no chain rule, and principal stretches from the characteristic cubic.
#include <algorithm>

#include "samples.hpp"

namespace soft::material::sample {

using Number = Dual<9>;

inline TensorOf<Number> variables(const Tensor& at) {
    TensorOf<Number> V;
    for (int m = 0; m < 9; ++m) V[m] = Number::variable(at[m], m);
    return V;
}

/// Squared principal stretches: the roots of x^3 - I1 x^2 + I2 x - I3, which must be distinct. The values are found by bisection
/// between the stationary points of the cubic, the derivatives by Newton's method in dual arithmetic.
inline std::array<Number, 3> squared_stretches(const TensorOf<Number>& V) {
    const auto C = right_cauchy_green(V);
    const auto [I1, I2] = principal_invariants(V);
    const Number I3 = determinant(C);
    const double spread = std::sqrt(I1.v * I1.v - 3.0 * I2.v);
    const std::array<double, 4> fence{0.0, (I1.v - spread) / 3.0, (I1.v + spread) / 3.0, I1.v};
    std::array<Number, 3> roots;
    for (std::size_t a = 0; a < 3; ++a) {
        double low = fence[a], high = fence[a + 1];
        const double sign = a == 1 ? -1.0 : 1.0;
        for (int i = 0; i < 100; ++i) {
            const double x = 0.5 * (low + high);
            (sign * (((x - I1.v) * x + I2.v) * x - I3.v) < 0.0 ? low : high) = x;
        }
        roots[a] = 0.5 * (low + high);
        for (int i = 0; i < 4; ++i) {
            const Number x = roots[a];
            roots[a] = x - (((x - I1) * x + I2) * x - I3) / ((3.0 * x - 2.0 * I1) * x + I2);
        }
    }
    return roots;
}

/// Energy of all fibre families.
template <class L>
Number fiber_energy_of(const Rubber<L>& rubber, const TensorOf<Number>& V, const FiberAxes& axes) {
    Number W;
    if (rubber.fibers)
        for (int family = 0; family < rubber.fibers->families; ++family) {
            const double angle = rubber.fibers->angle_rad;
            const double c = std::cos(angle), s = (1 - 2 * family) * std::sin(angle);
            Number I4;
            for (std::size_t i = 0; i < 3; ++i) {
                Number component;
                for (std::size_t k = 0; k < 3; ++k) component += V[3 * i + k] * (c * axes.e1[k] + s * axes.e2[k]);
                I4 += component * component;
            }
            W += fiber_energy(*rubber.fibers, I4);
        }
    return W;
}

template <class L>
Number energy_of(const Rubber<L>& rubber, const Tensor& at, const FiberAxes& axes = {}) {
    const auto V = variables(at);
    const double K = 1.0 / rubber.inverse_bulk_modulus;
    const Number J = determinant(V);
    if constexpr (std::same_as<L, LinearElastic> || std::same_as<L, SaintVenantKirchhoff>) {
        TensorOf<Number> strain = right_cauchy_green(V);  // e or E
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                if (std::same_as<L, LinearElastic>) strain[3 * i + j] = V[3 * i + j] + V[3 * j + i];
                strain[3 * i + j] =
                    0.5 * (strain[3 * i + j] - (i == j ? (std::same_as<L, LinearElastic> ? 2.0 : 1.0) : 0.0));
            }
        Number square;
        for (const Number& e : strain) square += e * e;
        const Number volume = trace(strain);
        return mu_Pa * square + 0.5 * (K - 2.0 * mu_Pa / 3.0) * volume * volume + fiber_energy_of(rubber, V, axes);
    } else {
        const Number dilation = theta(rubber.volumetric, J);
        const auto I = principal_invariants(V);
        Number W = 0.5 * K * dilation * dilation + fiber_energy_of(rubber, V, axes);
        if constexpr (std::same_as<L, NeoHookeanCompressible>) {
            W += 0.5 * mu_Pa * (I.I1 - 3.0 - 2.0 * log(J));
        } else if constexpr (StretchLaw<L>) {
            std::array<Number, 3> bar;
            const auto squared = squared_stretches(V);
            for (std::size_t a = 0; a < 3; ++a) bar[a] = log(sqrt(squared[a]) * pow(J, -1.0 / 3.0));
            W += energy_of_log_stretches(rubber.law, bar);
        } else {
            W += rubber.law.isochoric_energy(Invariants<Number>{I.I1 * pow(J, -2.0 / 3.0), I.I2 * pow(J, -4.0 / 3.0)});
        }
        return W;
    }
}

/// P_m of kraken from its Cauchy stress: P = sigma cof F.
inline std::array<Number, 9> kraken_stress(double bulk_Pa, const Tensor& at) {
    const auto V = variables(at);
    const Number J = determinant(V);
    auto sigma = left_cauchy_green(V);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sigma[3 * i + j] = mu_Pa * sigma[3 * i + j] + (i == j ? bulk_Pa * (J - 1.0) : Number{0.0});
    return multiply(sigma, cofactor(V));
}

}  // namespace soft::material::sample
