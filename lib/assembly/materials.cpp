#include "assembly/materials.hpp"

#include "core/error.hpp"

namespace soft::assembly {

namespace {

double positive_constant(const model::Material& material, const std::string& key) {
    const auto found = material.constants.find(key);
    const std::string place = "materials/" + material.name + "/" + key;
    if (found == material.constants.end() || found->second.size() != 1)
        throw Error(ExitCode::bad_input, place, "the law " + material.law + " needs one value here");
    if (!(found->second[0] > 0.0)) throw Error(ExitCode::bad_input, place, "must be greater than 0");
    return found->second[0];
}

material::VolumetricLaw volumetric_law(model::Volumetric volumetric) {
    switch (volumetric) {
        case model::Volumetric::quadratic: return material::VolumetricLaw::quadratic;
        case model::Volumetric::log: return material::VolumetricLaw::log;
        case model::Volumetric::mixed: return material::VolumetricLaw::mixed;
    }
    return material::VolumetricLaw::quadratic;
}

}  // namespace

AnyRubber make_rubber(const model::Material& material) {
    if (material.law != material::NeoHookean::name)
        throw Error(ExitCode::bad_input, "materials/" + material.name, "unknown law '" + material.law + "'",
                    "this version has neo-hookean");
    material::Rubber<material::NeoHookean> rubber{{positive_constant(material, "mu")}};
    rubber.volumetric = volumetric_law(material.volumetric);
    rubber.inverse_bulk_modulus = material.bulk_modulus_Pa ? 1.0 / *material.bulk_modulus_Pa : 0.0;
    return rubber;
}

double initial_shear_modulus_Pa(const AnyRubber& rubber) {
    return std::visit([](const auto& r) { return r.law.initial_shear_modulus_Pa(); }, rubber);
}

}  // namespace soft::assembly
