#include "model/rubber.hpp"

namespace soft::model {

material::AnyRubber make_rubber(const Material& material) {
    return material::make_rubber({.law = material.law,
                                  .constants = {material.constants.begin(), material.constants.end()},
                                  .bulk_modulus_Pa = material.bulk_modulus_Pa,
                                  .volumetric = material.volumetric,
                                  .fiber_frame = material.fiber_frame});
}

std::string why_not(const Material& material, Kinematics kinematics) {
    const auto families = material.constants.find("families");
    const bool one = families != material.constants.end() && families->second.size() == 1 && families->second[0] == 1.0;
    if (!one || kinematics != Kinematics::axisymmetric || material.fiber_frame != FiberFrame::cylindrical) return {};
    return "one family of fibres twists a body of revolution, which its section cannot show; families: 2, or model: solid";
}

}  // namespace soft::model
