#include "model/rubber.hpp"

namespace soft::model {

material::AnyRubber make_rubber(const Material& material) {
    return material::make_rubber({.law = material.law,
                                  .constants = {material.constants.begin(), material.constants.end()},
                                  .bulk_modulus_Pa = material.bulk_modulus_Pa,
                                  .volumetric = material.volumetric,
                                  .fiber_frame = material.fiber_frame});
}

}  // namespace soft::model
