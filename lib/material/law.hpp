#pragma once
/// Hyperelastic laws: one struct each with its energy written once. This header is the list of laws and the one
/// way the elements use them.
///
///   W(F, p) = W_iso(I1bar, I2bar) + p Theta(J) - p^2 / (2 kappa)          mixed formulation
///   W(F)    = W_iso(I1bar, I2bar) + kappa/2 Theta(J)^2                    displacement formulation
///
/// per undeformed volume [J/m^3]; I1bar = J^-2/3 tr C, I2bar = J^-4/3 (tr^2 C - tr C^2)/2, C = F^T F, J = det F.
/// Eliminating p from the first gives the second; kappa = infinity (1/kappa = 0) is full incompressibility,
/// Theta(J) = 0. p is the derivative of the energy by Theta; the hydrostatic Cauchy stress is p Theta'(J).
/// Source: two-field form of Sussman and Bathe, Comput. Struct. 26 (1987) 357, with Theta for J - 1 (derived here).
/// Held by material/law_test (every law: stress-free reference, frame indifference, P = dW/dF, A = dP/dF).
#include <concepts>
#include <string_view>
#include <variant>

#include "core/dual.hpp"
#include "core/tensor.hpp"
#include "material/neo_hookean.hpp"

namespace soft::material {

/// Every law the elements can run. A law missing from a `std::visit` fails to compile.
using Law = std::variant<NeoHookean>;

/// Theta(J) of the volumetric energy kappa/2 Theta^2.
enum class VolumetricLaw { quadratic, log, mixed };

/// A law with its volumetric part. inverse_bulk_modulus = 1/kappa [1/Pa]; 0 = incompressible.
template <class L>
struct Rubber {
    L law;
    VolumetricLaw volumetric = VolumetricLaw::quadratic;
    double inverse_bulk_modulus = 0;
};

template <class L>
concept HyperelasticLaw = requires(const L& law, const Invariants<Dual<3>>& bar) {
    { law.isochoric_energy(bar) } -> std::same_as<Dual<3>>;
    { law.initial_shear_modulus_Pa() } -> std::same_as<double>;
    { L::name } -> std::convertible_to<std::string_view>;
};
static_assert(HyperelasticLaw<NeoHookean>);

}  // namespace soft::material
