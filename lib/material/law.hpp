#pragma once
/// The list of laws and their interface to the elements.
///
///   W(F, p) = W_s(F) + p Theta - p^2 / (2 K)          mixed formulation
///   W(F)    = W_s(F) + K/2 Theta^2                    displacement formulation
///
/// per undeformed volume [J/m^3], J = det F. Eliminating p from the first gives the second; 1/K = 0 is full
/// incompressibility, Theta = 0. p is the derivative of the energy by Theta. A law is a plain struct that defines W_s by one
/// of these functions:
///   isochoric_energy(Invariants of J^-2/3 C)            with Theta(J) chosen by the design and K = kappa
///   energy_of_log_stretch(x)                            W_s is its sum over the logarithms of the isochoric principal stretches
///   shear_energy(Invariants of C, J)                    with Theta(J), or with the function `dilatation` of the law
/// All of them can be combined with fibres (material/fibers.hpp), and a law may define its own fibres (`fibers_from`). Two laws
/// have another form, do not support fibres, and have their own branch in response.hpp: small strain (LinearElastic) and a stress
/// without an energy (Kraken).
/// To add a law, write a header with such a struct, its LawInfo and `from`, and add its name to `LawList` below.
/// Source: two-field form of Sussman and Bathe, Comput. Struct. 26 (1987) 357, with Theta for J - 1 (derived here).
/// Tested by material/law_test (every law: stress-free reference, frame indifference, P = dW/dF, A = dP/dF).
#include <concepts>
#include <optional>
#include <tuple>
#include <variant>

#include "material/arruda_boyce.hpp"
#include "material/fibers.hpp"
#include "material/form.hpp"
#include "material/gent.hpp"
#include "material/holzapfel_gasser_ogden.hpp"
#include "material/inelastic.hpp"
#include "material/kraken.hpp"
#include "material/linear_elastic.hpp"
#include "material/mooney_rivlin.hpp"
#include "material/neo_hookean.hpp"
#include "material/neo_hookean_compressible.hpp"
#include "material/ogden.hpp"
#include "material/saint_venant_kirchhoff.hpp"
#include "material/yeoh.hpp"
#include "math/dual.hpp"
#include "math/tensor.hpp"

namespace soft::material {

/// All laws, in the order of --list-materials.
using LawList = std::tuple<LinearElastic, SaintVenantKirchhoff, NeoHookean, NeoHookeanCompressible, MooneyRivlin, Yeoh,
                           Ogden, Gent, ArrudaBoyce, HolzapfelGasserOgden, Kraken>;

/// A law with the material options of a design. inverse_bulk_modulus = 1/K [1/Pa]; 0 = incompressible.
template <class L>
struct Rubber {
    L law;
    VolumetricLaw volumetric = VolumetricLaw::quadratic;
    double inverse_bulk_modulus = 0;
    FiberFrame fiber_frame = FiberFrame::cartesian;
    std::optional<Fibers> fibers = {};        ///< only for laws that satisfy MayHaveFibers
    std::optional<Inelastic> inelastic = {};  ///< only for laws that satisfy MayBeInelastic
};

template <class L>
concept InvariantLaw = requires(const L& law, const Invariants<Dual<3>>& bar) {
    { law.isochoric_energy(bar) } -> std::same_as<Dual<3>>;
};
template <class L>
concept StretchLaw = requires(const L& law, const Dual<1>& log_stretch) {
    { law.energy_of_log_stretch(log_stretch) } -> std::same_as<Dual<1>>;
};
template <class L>
concept CoupledLaw = requires(const L& law, const Invariants<Dual<3>>& I, const Dual<3>& J) {
    { law.shear_energy(I, J) } -> std::same_as<Dual<3>>;
};
/// A law that replaces Theta(J) by its own function.
template <class L>
concept OwnDilatation = requires(const Invariants<Dual<3>>& I, const Dual<3>& J) {
    { L::dilatation(I, J) } -> std::same_as<Dual<3>>;
};
/// A law that defines its own fibres.
template <class L>
concept FiberLaw = requires(const Constants& constants) {
    { L::fibers_from(constants) } -> std::same_as<Fibers>;
};
/// A stress without an energy: its tangent is not symmetric, and it has no mixed form.
template <class L>
concept StressLaw = requires(const L& law, const Invariants<Dual<3>>& I, const Dual<3>& J) {
    { law.stress_coefficients(I, J) } -> std::same_as<std::array<Dual<3>, 3>>;
};
/// A law with a finite-strain energy, to which the energy of fibres can be added.
template <class L>
concept MayHaveFibers = !StressLaw<L> && !std::same_as<L, LinearElastic>;
/// A law with an isochoric energy, which can relax and soften.
template <class L>
concept MayBeInelastic = InvariantLaw<L> || StretchLaw<L>;
template <class L>
concept Law = (InvariantLaw<L> || StretchLaw<L> || CoupledLaw<L> || StressLaw<L> ||
               std::same_as<L, LinearElastic>)&&requires(const L& law, const Constants& constants) {
    { law.initial_shear_modulus_Pa() } -> std::same_as<double>;
    { L::info() } -> std::same_as<LawInfo>;
    { L::from(constants) } -> std::same_as<L>;
};

template <class List>
struct RubberOf;
template <Law... L>
struct RubberOf<std::tuple<L...>> {
    using type = std::variant<Rubber<L>...>;
};
/// A rubber of any law. A `std::visit` that does not handle all laws fails to compile.
using AnyRubber = RubberOf<LawList>::type;

}  // namespace soft::material
