#include "assembly/materials.hpp"

#include "core/error.hpp"

namespace soft::assembly {

AnyRubber make_rubber(const model::Material& material, model::Formulation formulation) {
    const std::string place = "materials/" + material.name;
    const auto make = [&] {
        try {
            return model::make_rubber(material);
        } catch (const Error& error) {
            throw Error(error.code(), "", place + "/" + error.what());  // the law names its constant, not the region
        }
    };
    AnyRubber rubber = make();
    if (const std::string reason = material::why_not(rubber, formulation); !reason.empty())
        throw Error(ExitCode::bad_input, place, reason);
    return rubber;
}

}  // namespace soft::assembly
