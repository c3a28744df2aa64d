#include "model/rubber.hpp"

#include "core/error.hpp"

namespace soft::model {

namespace {

/// Hooke's law with the moduli of the undeformed rubber.
material::AnyRubber small_strain(const material::AnyRubber& rubber) {
    const auto& law = material::info_of(rubber);
    if (law.fibers || material::reference_stress_Pa(rubber) != 0.0)
        throw Error(ExitCode::bad_input, "strain",
                    "the law " + std::string{law.name} + " has no isotropic, stress-free linear counterpart",
                    "strain: finite, or another law");
    return material::make_rubber({.law = "linear-elastic",
                                  .constants = {{"mu", {material::initial_shear_modulus_Pa(rubber)}}},
                                  .bulk_modulus_Pa = material::bulk_modulus_Pa(rubber)});
}

}  // namespace

material::AnyRubber make_rubber(const Material& material) {
    const auto rubber = material::make_rubber({.law = material.law,
                                  .constants = {material.constants.begin(), material.constants.end()},
                                  .bulk_modulus_Pa = material.bulk_modulus_Pa,
                                  .volumetric = material.volumetric,
                                  .fiber_frame = material.fiber_frame});
    return material.strain == Strain::small ? small_strain(rubber) : rubber;
}

std::string why_not(const Material& material, Kinematics kinematics) {
    const auto families = material.constants.find("families");
    const bool one = families != material.constants.end() && families->second.size() == 1 && families->second[0] == 1.0;
    if (!one || kinematics != Kinematics::axisymmetric || material.fiber_frame != FiberFrame::cylindrical) return {};
    return "one family of fibres twists a body of revolution, which its section cannot show; families: 2, or model: solid";
}

}  // namespace soft::model
