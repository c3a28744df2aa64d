#include "fem/materials.hpp"

#include "core/error.hpp"

namespace soft::fem {

AnyRubber make_rubber(const model::Material& material, model::Formulation formulation) {
    const std::string location = "materials/" + material.name;
    const auto make = [&] {
        try {
            return model::make_rubber(material);
        } catch (const Error& error) {
            throw Error(error.code(), "", location + "/" + error.what());  // the law names only the constant
        }
    };
    AnyRubber rubber = make();
    if (const std::string reason = material::explain_incompatibility(rubber, formulation); !reason.empty())
        throw Error(ExitCode::bad_input, location, reason);
    return rubber;
}

}  // namespace soft::fem
