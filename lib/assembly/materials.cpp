#include "assembly/materials.hpp"

#include "core/error.hpp"

namespace soft::assembly {

namespace {

material::VolumetricLaw volumetric_law(model::Volumetric volumetric) {
    switch (volumetric) {
        case model::Volumetric::quadratic: return material::VolumetricLaw::quadratic;
        case model::Volumetric::log: return material::VolumetricLaw::log;
        case model::Volumetric::mixed: return material::VolumetricLaw::mixed;
    }
    return material::VolumetricLaw::quadratic;
}

}  // namespace

material::Form form_of(model::Formulation formulation) {
    switch (formulation) {
        case model::Formulation::displacement: return material::Form::displacement;
        case model::Formulation::mixed: return material::Form::mixed;
        case model::Formulation::f_bar: return material::Form::f_bar;
    }
    return material::Form::mixed;
}

AnyRubber make_rubber(const model::Material& material, model::Formulation formulation) {
    const std::string place = "materials/" + material.name;
    const auto make = [&] {
        const auto frame = material.fiber_frame == model::FiberFrame::cylindrical ? material::FiberFrame::cylindrical
                                                                                  : material::FiberFrame::cartesian;
        const material::Constants constants(material.constants.begin(), material.constants.end());
        try {
            return material::make_rubber({material.law, constants, material.bulk_modulus_Pa,
                                          volumetric_law(material.volumetric), frame});
        } catch (const Error& error) {
            throw Error(error.code(), "", place + "/" + error.what());   // the law names its constant, not the region
        }
    };
    AnyRubber rubber = make();
    if (const std::string reason = material::why_not(rubber, form_of(formulation)); !reason.empty())
        throw Error(ExitCode::bad_input, place, reason);
    return rubber;
}

}  // namespace soft::assembly
