#pragma once
/// The laws by name: what each takes, and how a design's constants become the law the elements run.
/// Tested by material/catalogue_test.
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "material/law.hpp"

namespace soft::material {

/// One entry a law, in the order of LawList.
[[nodiscard]] std::span<const LawInfo> laws();

/// nullptr for a name no law has.
[[nodiscard]] const LawInfo* find_law(std::string_view name);

/// What a design states of a rubber.
struct Description {
    std::string_view law;
    Constants constants = {};  ///< SI, by the names of LawInfo::parameters; optional ones may be missing
    std::optional<double> bulk_modulus_Pa = {};  ///< kappa; nullopt = incompressible
    VolumetricLaw volumetric = VolumetricLaw::quadratic;
    FiberFrame fiber_frame = FiberFrame::cartesian;
    std::optional<Fibers> fibers = {};  ///< besides the law; not where the law brings its own
};

/// Throws Error (bad_input) whose place is the parameter's name ("mu", "kappa", "law") for an unknown law, a missing or
/// superfluous constant, one outside its range, and constants that do not fit together; "fibers" or "fibers.k1" for fibres
/// outside their range or in a law that cannot have them.
[[nodiscard]] AnyRubber make_rubber(const Description& description);

/// Why a rubber cannot be run in a form, with what would be right ("problem; remedy"); empty where it can.
[[nodiscard]] std::string why_not(const AnyRubber& rubber, Form form);

[[nodiscard]] double initial_shear_modulus_Pa(const AnyRubber& rubber);

/// K of K/2 Theta^2 [Pa]; nullopt for an incompressible rubber.
[[nodiscard]] std::optional<double> bulk_modulus_Pa(const AnyRubber& rubber);

/// The law's table entry.
[[nodiscard]] const LawInfo& info_of(const AnyRubber& rubber);

/// Largest stress component of the undeformed rubber [Pa]: 0 but for a law that starts under stress (kraken).
[[nodiscard]] double reference_stress_Pa(const AnyRubber& rubber);

/// Of the law or beside it.
[[nodiscard]] const std::optional<Fibers>& fibers_of(const AnyRubber& rubber);

/// False for a stress without an energy.
[[nodiscard]] bool has_symmetric_tangent(const AnyRubber& rubber);

}  // namespace soft::material
