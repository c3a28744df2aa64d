#include "design/unit_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::design {
namespace {

constexpr double standard_gravity_m_s2 = 9.80665;
constexpr double max_gravities = 50.0;  // more is plausible only for a centrifuge or a shaker
// From foamed silicone to metal-filled rubber.
constexpr double min_density_kg_m3 = 100.0, max_density_kg_m3 = 5000.0;
/// Fibre angles of 0 to 1.57 deg from the axis are not used in practice; such numbers are probably angles up to 90 deg in radians.
constexpr double max_mistaken_rad = std::numbers::pi / 2;

void check_gravity(const Design& design, std::vector<std::string>& warnings) {
    for (const Design::BodyForceRequest& force : design.body_forces) {
        const std::string path = "loads." + force.name + ".acceleration: ",
                          size = core::quantity_text(force.acceleration_m_s2, core::Dimension::acceleration);
        if (std::abs(force.acceleration_m_s2) > max_gravities * standard_gravity_m_s2)
            warnings.push_back(path + size + " is " +
                               core::rounded_text(std::abs(force.acceleration_m_s2) / standard_gravity_m_s2, 3) +
                               " times gravity; is the unit right (9.81 m/s^2)?");
        if (force.acceleration_m_s2 < 0)
            warnings.push_back(path + size + " along " + force.along +
                               " points the other way; write 9.81 m/s^2 and the direction of gravity");
    }
}

void check_density(const model::Material& material, std::vector<std::string>& warnings) {
    const double density = material.density_kg_m3.value_or(min_density_kg_m3);
    if (density < min_density_kg_m3 || density > max_density_kg_m3)
        warnings.push_back(material.source + ".density: " + core::quantity_text(density, core::Dimension::density) +
                           " is unusual for a rubber (about 1100 kg/m^3); is the unit right?");
}

void check_angles(const Values& values, std::vector<std::string>& warnings) {
    for (const char* path : {"geometry.fibers.angle", "geometry.jacket.fibers.angle", "material.angle"}) {
        if (!values.has(path) || !values.given(path)) continue;
        const double degrees = values.number(path) * 180 / std::numbers::pi;
        if (degrees > 0 && degrees <= max_mistaken_rad)
            warnings.push_back(std::string{path} + ": " + core::rounded_text(degrees, 3) +
                               " deg is along the axis; if it is in radians, write " + core::rounded_text(degrees, 3) +
                               " rad (" + core::rounded_text(degrees * 180 / std::numbers::pi, 3) + " deg)");
    }
}

}  // namespace

void check_units(const Design& design, std::vector<std::string>& warnings) {
    check_gravity(design, warnings);
    check_density(design.material, warnings);
    for (const auto& [name, material] : design.materials) check_density(material, warnings);
    check_angles(design.values, warnings);
}

}  // namespace soft::design
