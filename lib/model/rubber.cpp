#include "model/rubber.hpp"

#include <cmath>

#include "core/error.hpp"

namespace soft::model {

namespace {

/// Hooke's law with the moduli of the undeformed rubber.
material::AnyRubber small_strain(const material::AnyRubber& rubber, std::optional<double> bulk_modulus_Pa) {
    if (material::fibers_of(rubber) || material::reference_stress_Pa(rubber) != 0.0)
        throw Error(ExitCode::bad_input, "strain",
                    "the law " + std::string{material::info_of(rubber).name} +
                        (material::fibers_of(rubber) ? " with its fibres" : "") +
                        " has no isotropic, stress-free linear counterpart",
                    "strain: finite, or another law");
    return material::make_rubber({.law = "linear-elastic",
                                  .constants = {{"mu", {material::initial_shear_modulus_Pa(rubber)}}},
                                  .bulk_modulus_Pa = bulk_modulus_Pa});
}

/// One family between the axis and the hoop: its mirror image is another one.
bool is_one_sided(const Material& material) {
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
                                               .fibers = material.fibers});
    return material.strain == Strain::small ? small_strain(rubber, material.bulk_modulus_Pa) : rubber;
}

std::string why_not(const Material& material, Kinematics kinematics, const std::array<bool, 3>& symmetry_planes) {
    if (!is_one_sided(material)) return {};
    const bool cylindrical = material.fiber_frame == FiberFrame::cylindrical;
    if (cylindrical && kinematics == Kinematics::axisymmetric)
        return "one family of fibres twists a body of revolution, which its section cannot show; families: 2, or model: solid";
    if (symmetry_planes[0] || symmetry_planes[1] || (cylindrical && symmetry_planes[2]))
        return "one family of fibres is not its own mirror image, and the model is cut at planes of symmetry; families: 2, or "
               "model: solid";
    return {};
}

}  // namespace soft::model
