#pragma once
/// Lookup of laws by name, their parameters, and construction of a law from the constants of a design.
/// Tested by material/catalogue_test.
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "material/law.hpp"

namespace soft::material {

/// One entry per law, in the order of LawList.
[[nodiscard]] std::span<const LawInfo> laws();

/// nullptr for an unknown name.
[[nodiscard]] const LawInfo* find_law(std::string_view name);

/// Description of a rubber in a design.
struct Description {
    std::string_view law;
    Constants constants = {};  ///< SI, by the names of LawInfo::parameters; optional ones may be missing
    std::optional<double> bulk_modulus_Pa = {};  ///< kappa; nullopt = incompressible
    VolumetricLaw volumetric = VolumetricLaw::quadratic;
    FiberFrame fiber_frame = FiberFrame::cartesian;
    std::optional<Fibers> fibers = {};        ///< in addition to the law; not allowed if the law has fibres
    std::optional<Inelastic> inelastic = {};  ///< only for laws with an isochoric energy
};

/// Throws Error (bad_input) for an unknown law, a missing or unknown constant, a constant outside its range, inconsistent
/// constants, and an initial shear modulus that is not positive; the location is the name of the parameter ("mu", "kappa", "law").
/// Throws it with the location "fibers" or "fibers.k1" for fibres that are outside their range or that the law does not support, and
/// likewise with "viscoelastic", "viscoelastic.times", "softening.r" ....
[[nodiscard]] AnyRubber make_rubber(const Description& description);

/// The incompressible rubber of a known law without these checks, for parts of a law such as c01 alone. Constants that are not given have
/// their default values.
[[nodiscard]] AnyRubber make_unchecked_rubber(std::string_view law, Constants constants);

/// Reason why a rubber cannot be used with a formulation ("problem; remedy"); empty if it can.
[[nodiscard]] std::string explain_incompatibility(const AnyRubber& rubber, Form form);

[[nodiscard]] double initial_shear_modulus_Pa(const AnyRubber& rubber);

/// K of K/2 Theta^2 [Pa]; nullopt for an incompressible rubber.
[[nodiscard]] std::optional<double> bulk_modulus_Pa(const AnyRubber& rubber);

/// The table entry of the law.
[[nodiscard]] const LawInfo& info_of(const AnyRubber& rubber);

/// Largest component of the initial stress [Pa]: 0 except for kraken.
[[nodiscard]] double reference_stress_Pa(const AnyRubber& rubber);

/// The fibres of the law, or those in addition to it.
[[nodiscard]] const std::optional<Fibers>& fibers_of(const AnyRubber& rubber);

/// nullptr for an elastic rubber.
[[nodiscard]] const Inelastic* inelastic_of(const AnyRubber& rubber);

/// False for laws without an energy.
[[nodiscard]] bool has_symmetric_tangent(const AnyRubber& rubber);

}  // namespace soft::material
