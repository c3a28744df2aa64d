#include "model/rubber.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace soft::model {

namespace {

/// Hooke's law with the initial moduli of the rubber.
material::AnyRubber small_strain(const material::AnyRubber& rubber, std::optional<double> bulk_modulus_Pa) {
    if (material::fibers_of(rubber) || material::reference_stress_Pa(rubber) != 0.0)
        throw Error(ExitCode::bad_input, "strain",
                    "the law " + std::string{material::info_of(rubber).name} +
                        (material::fibers_of(rubber) ? " with fibres" : "") +
                        " has no isotropic, stress-free linear form",
                    "use strain: finite or another law");
    return material::make_rubber({.law = "linear-elastic",
                                  .constants = {{"mu", {material::initial_shear_modulus_Pa(rubber)}}},
                                  .bulk_modulus_Pa = bulk_modulus_Pa});
}

/// True for one family of fibres inclined to the axis: its mirror image is a different family.
bool lacks_mirror_symmetry(const Material& material) {
    const auto constant = [&](const char* name, double otherwise) {
        const auto found = material.constants.find(name);
        return found == material.constants.end() || found->second.empty() ? otherwise : found->second.front();
    };
    constexpr double between_rad = 0.5, rounding = 1e-9;
    const double families = material.fibers ? material.fibers->families : constant("families", 2);
    const double angle_rad = material.fibers ? material.fibers->angle_rad : constant("angle", between_rad);
    return families == 1 && std::abs(std::sin(2 * angle_rad)) > rounding;
}

}  // namespace

material::AnyRubber make_rubber(const Material& material) {
    const auto rubber = material::make_rubber({.law = material.law,
                                               .constants = {material.constants.begin(), material.constants.end()},
                                               .bulk_modulus_Pa = material.bulk_modulus_Pa,
                                               .volumetric = material.volumetric,
                                               .fiber_frame = material.fiber_frame,
                                               .fibers = material.fibers,
                                               .inelastic = material.inelastic});
    if (material.strain == Strain::small && material.inelastic)
        throw Error(ExitCode::bad_input, "strain", "linear rubber neither relaxes nor softens", "use strain: finite");
    return material.strain == Strain::small ? small_strain(rubber, material.bulk_modulus_Pa) : rubber;
}

std::vector<double> young_moduli_Pa(const Case& model) {
    std::vector<double> moduli;
    for (const auto& region : model.mesh.region_names)
        moduli.push_back(3 * material::initial_shear_modulus_Pa(
                                 make_rubber(*std::ranges::find(model.materials, region, &Material::name))));
    return moduli;
}

std::string explain_incompatibility(const Material& material, Kinematics kinematics,
                                    const std::array<bool, 3>& symmetry_planes) {
    if (!lacks_mirror_symmetry(material)) return {};
    const bool cylindrical = material.fiber_frame == FiberFrame::cylindrical;
    if (cylindrical && kinematics == Kinematics::axisymmetric)
        return "one family of fibres twists the actuator, which model: axisymmetric cannot represent; use families: 2 or model: solid";
    if (symmetry_planes[0] || symmetry_planes[1] || (cylindrical && symmetry_planes[2]))
        return "one family of fibres has no mirror symmetry, but the model is cut at symmetry planes; use families: 2 or "
               "model: solid";
    return {};
}

}  // namespace soft::model
