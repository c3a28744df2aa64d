#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/materials.hpp"
#include "design/read_parts.hpp"

namespace soft::design {
namespace {

// Silicones: from the softest gels to hard, filled grades, with room on both sides.
constexpr double softest_young_Pa = 1e3, hardest_young_Pa = 50e6;
// Neo-Hookean shells pass their limit point at pressures of the order of the shear modulus.
constexpr double pressure_over_modulus = 10.0;
// Around one standard atmosphere, 101.325 kPa.
constexpr double atmosphere_low_Pa = 101e3, atmosphere_high_Pa = 101.6e3;
// Below this Poisson's ratio is under 0.475 and the change of volume shows.
constexpr double least_bulk_ratio = 20.0;

std::string pressure_text(double value_Pa) { return core::quantity_text(value_Pa, core::Dimension::pressure); }
std::string length_text(double value_m) { return core::quantity_text(value_m, core::Dimension::length); }

void check_material(const Design& design, double mu_Pa, std::vector<std::string>& warnings) {
    const double young_Pa = 3.0 * mu_Pa;
    if (young_Pa < softest_young_Pa || young_Pa > hardest_young_Pa)
        warnings.push_back("material: an initial Young's modulus of " + pressure_text(young_Pa) +
                           " is unusual for a silicone (1 kPa to 50 MPa); is the unit right?");
    if (!design.material.bulk_modulus_Pa) return;
    const double ratio = *design.material.bulk_modulus_Pa / mu_Pa;
    if (ratio < least_bulk_ratio)
        warnings.push_back("material.kappa: only " + core::rounded_text(ratio, 3) +
                           " times the shear modulus, the rubber is visibly compressible");
}

void check_loads(const Design& design, double mu_Pa, std::vector<std::string>& warnings) {
    for (const model::PressureLoad& load : design.loads) {
        const double size_Pa = std::abs(load.pressure_Pa);
        const std::string path = "loads." + load.target + ".pressure: ";
        if (size_Pa > pressure_over_modulus * mu_Pa)
            warnings.push_back(path + pressure_text(load.pressure_Pa) + " is far above the initial shear modulus " +
                               pressure_text(mu_Pa));
        if (size_Pa >= atmosphere_low_Pa && size_Pa <= atmosphere_high_Pa)
            warnings.push_back(path + pressure_text(load.pressure_Pa) +
                               " looks like an absolute pressure; pressures are gauge, above the surroundings");
    }
    for (const model::Until& until : design.path.until) {
        const double full_Pa = design.loads.front().pressure_Pa;
        if (until.quantity == "pressure" && (until.value * full_Pa < 0 || std::abs(until.value) > std::abs(full_Pa)))
            warnings.push_back("path.until.pressure: " + pressure_text(until.value) +
                               " is never reached, the path ends at the full load " + pressure_text(full_Pa));
    }
}

/// The thinnest part that the family's keys name.
struct Wall {
    std::string path;
    double thickness_m;
};
std::optional<Wall> thinnest_wall(const Values& values) {
    std::optional<Wall> thinnest;
    const auto consider = [&](const char* path, double thickness_m) {
        if (!thinnest || thickness_m < thinnest->thickness_m) thinnest = Wall{path, thickness_m};
    };
    for (const char* path : {"geometry.wall", "geometry.thickness", "geometry.cap"})
        if (values.has(path)) consider(path, values.number(path));
    if (values.has("geometry.outer_radius") && values.has("geometry.inner_radius"))
        consider("geometry.outer_radius - geometry.inner_radius",
                 values.number("geometry.outer_radius") - values.number("geometry.inner_radius"));
    return thinnest;
}

}  // namespace

std::vector<std::string> plausibility(const Design& design) {
    std::vector<std::string> warnings;
    const double mu_Pa = find_law(design.material.law)->initial_shear_modulus_Pa(design.material.constants);
    check_material(design, mu_Pa, warnings);
    check_loads(design, mu_Pa, warnings);
    const double size_m = design.values.number("mesh.size");
    const std::optional<Wall> wall = thinnest_wall(design.values);
    if (wall && wall->thickness_m > 0 && size_m > wall->thickness_m)
        warnings.push_back("mesh.size: " + length_text(size_m) + " is more than the wall, " + wall->path + " = " +
                           length_text(wall->thickness_m) + "; one cell through it is coarse");
    return warnings;
}

}  // namespace soft::design
