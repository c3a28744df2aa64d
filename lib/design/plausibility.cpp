#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/locking.hpp"
#include "design/materials.hpp"
#include "design/read_parts.hpp"
#include "material/stability.hpp"

namespace soft::design {
namespace {

// Silicones: from the softest gels to hard, filled grades, with a margin on both sides.
constexpr double min_young_Pa = 1e3, max_young_Pa = 50e6;
constexpr double max_solid_young_Pa = 300e9;  // above steel
// Neo-Hookean shells reach their limit point at pressures of the order of the shear modulus.
constexpr double pressure_over_modulus = 10.0, pressure_under_modulus = 1e-5;
// Around one standard atmosphere, 101.325 kPa.
constexpr double atmosphere_low_Pa = 101e3, atmosphere_high_Pa = 101.6e3;
// Below this ratio of bulk to shear modulus, Poisson's ratio is less than 0.475 and the change of volume is noticeable.
constexpr double min_bulk_ratio = 20.0;

std::string pressure_text(double value_Pa) { return core::quantity_text(value_Pa, core::Dimension::pressure); }

void check_material(const model::Material& material, double mu_Pa, std::vector<std::string>& warnings) {
    const double young_Pa = 3.0 * mu_Pa;
    const bool main = material.source == main_material;  // the others may be paper, fabric, a stiff cap
    if (main && (young_Pa < min_young_Pa || young_Pa > max_young_Pa))
        warnings.push_back("material: an initial Young's modulus of " + pressure_text(young_Pa) +
                           " is unusual for a silicone (1 kPa to 50 MPa); is the unit right?");
    if (!main && (young_Pa < min_young_Pa || young_Pa > max_solid_young_Pa))
        warnings.push_back(material.source + ": an initial Young's modulus of " + pressure_text(young_Pa) +
                           " is softer than any gel or harder than steel; is the unit right?");
    if (!main || !material.bulk_modulus_Pa) return;
    const double ratio = *material.bulk_modulus_Pa / mu_Pa;
    if (ratio < min_bulk_ratio)
        warnings.push_back("material.kappa: only " + core::rounded_text(ratio, 3) +
                           " times the shear modulus, the rubber is visibly compressible");
}

void check_law(const model::Material& material, const material::AnyRubber& rubber, double mu_Pa,
               std::vector<std::string>& warnings) {
    const std::string law{material::info_of(rubber).name};
    if (!material::has_symmetric_tangent(rubber))
        warnings.push_back(material.source + ": the undeformed state of " + law + " has the initial stress mu = " +
                           pressure_text(mu_Pa) + "; without load it shrinks by about mu/(3 kappa)");
    const auto limits = material::stability_limits(rubber);
    if (limits.empty()) return;
    const auto& range = material::default_stretch_range;
    warnings.push_back(material.source + ": " + law + " is " + material::stability_text(limits) +
                       " (Drucker stability, checked from " + core::rounded_text(range.min, 3) + " to " +
                       core::rounded_text(range.max, 3) + ")");
}

void check_pressure(const std::string& path, double pressure_Pa, double mu_Pa, std::vector<std::string>& warnings) {
    const double size_Pa = std::abs(pressure_Pa);
    if (size_Pa > pressure_over_modulus * mu_Pa)
        warnings.push_back(path + ": " + pressure_text(pressure_Pa) + " is far above the initial shear modulus " +
                           pressure_text(mu_Pa));
    if (size_Pa > 0 && size_Pa < pressure_under_modulus * mu_Pa)
        warnings.push_back(path + ": " + pressure_text(pressure_Pa) + " is far below the initial shear modulus " +
                           pressure_text(mu_Pa) + "; is it kPa or MPa?");
    if (size_Pa >= atmosphere_low_Pa && size_Pa <= atmosphere_high_Pa)
        warnings.push_back(path + ": " + pressure_text(pressure_Pa) +
                           " looks like an absolute pressure; pressures are gauge, above the surroundings");
}

/// Warns about an end pressure that is not between the start and the target of the stage.
void check_ends(const model::Stage& stage, const model::SupplyTarget& from, std::vector<std::string>& warnings) {
    const model::SupplyTarget& to = stage.supplies.front();
    constexpr auto pressure = model::Prescription::pressure;
    if (from.what != pressure || to.what != pressure) return;
    const std::string path =
        stage.name.empty() ? "path.until.pressure: " : "stage " + stage.name + ": until pressure: ";
    for (const model::Until& until : stage.until)
        if (until.quantity == "pressure" && (until.value - from.value) * (until.value - to.value) > 0)
            warnings.push_back(path + pressure_text(until.value) + " is never reached, " +
                               (stage.name.empty() ? "the path" : "the stage") + " ends at the full load " +
                               pressure_text(to.value));
}

std::string load_path(const Design& design, const model::Stage& stage, const std::string& load) {
    const std::string start = stage.name.empty() ? "" : "path.stages." + stage.name + ".",
                      short_form = start + "loads." + load;
    return (design.values.has(short_form + ".pressure") ? short_form : start + "loads.cavities." + load) + ".pressure";
}

/// Warns about a load whose target the previous stage may not reach (because of its `until`) and that this stage does not name.
void check_unfinished_loads(const Design& design, const model::Stage& stage, const model::Stage& before,
                            const std::vector<bool>& moved_before, std::vector<std::string>& warnings) {
    for (std::size_t i = 0; i < design.loads.size(); ++i) {
        const model::SupplyTarget &now = stage.supplies[i], &then = before.supplies[i];
        const bool on_its_way = !before.until.empty() && moved_before[i] && now.what == then.what &&
                                now.what == model::Prescription::pressure && now.value == then.value;
        if (!on_its_way || design.values.has(load_path(design, stage, design.loads[i].name))) continue;
        warnings.push_back("path.stages." + stage.name + ": loads." + design.loads[i].name +
                           " continues to its full value of stage " + before.name +
                           " if that stage ends early by its until; name the load in this stage to hold it");
    }
}

void check_loads(const Design& design, double mu_Pa, std::vector<std::string>& warnings) {
    model::Stage before;
    before.supplies.resize(design.loads.size());
    std::vector<bool> moved_before(design.loads.size(), false);
    for (const model::Stage& stage : design.path.stages) {
        for (std::size_t i = 0; i < design.loads.size(); ++i) {
            const model::SupplyTarget& target = stage.supplies[i];
            if (target.what == model::Prescription::pressure && target.value != before.supplies[i].value)
                check_pressure(load_path(design, stage, design.loads[i].name), target.value, mu_Pa, warnings);
        }
        if (!design.loads.empty()) check_ends(stage, before.supplies.front(), warnings);
        check_unfinished_loads(design, stage, before, moved_before, warnings);
        for (std::size_t i = 0; i < design.loads.size(); ++i)
            moved_before[i] = stage.supplies[i].what != before.supplies[i].what ||
                              stage.supplies[i].value != before.supplies[i].value;
        before = stage;
    }
    for (const Design::DeadLoadRequest& load : design.dead_loads)
        if (load.kind == model::DeadLoadKind::traction && std::abs(load.size_SI) > pressure_over_modulus * mu_Pa)
            warnings.push_back("loads." + load.name + ".traction: " + pressure_text(load.size_SI) +
                               " is far above the initial shear modulus " + pressure_text(mu_Pa));
}

std::string too_stiff(LockingChoice choice) {
    return core::rounded_text(locking_factor(choice), 2) + " times too stiff on " + std::string{locking_measured_on};
}

double max_bulk_ratio(const Design& design) {
    const auto ratio_of = [](const model::Material& material) {
        return material.bulk_modulus_Pa.value_or(0) / material::initial_shear_modulus_Pa(model::make_rubber(material));
    };
    double ratio = ratio_of(design.material);
    for (const auto& [name, material] : design.materials) ratio = std::max(ratio, ratio_of(material));
    return ratio;
}

void check_locking(const Design& design, std::vector<std::string>& warnings) {
    const auto has_value = [&](const char* path, std::string_view word) {
        return design.values.has(path) && design.values.text(path) == word;
    };
    if (has_value("mesh.cells", "simplices") && has_value("mesh.order", "1"))
        warnings.push_back("mesh.cells: " + first_order_simplex_warning());
    if (!has_value("mesh.formulation", "displacement")) return;
    const double ratio = max_bulk_ratio(design);
    const auto choice = has_value("mesh.order", "1") ? LockingChoice::first_order_displacement
                                                     : LockingChoice::second_order_displacement;
    if (ratio > locking_bulk_ratio)
        warnings.push_back("mesh.formulation: the displacement formulation locks at a bulk modulus of " +
                           core::rounded_text(ratio, 3) + " times the shear modulus (" + too_stiff(choice) +
                           "); formulation: mixed does not");
}

/// The stiffness damping of mixed cells has no volumetric part, because their displacement block has no volumetric stiffness.
void check_damping(const Design& design, std::vector<std::string>& warnings) {
    constexpr const char* damping = "dynamics.stiffness_damping";
    constexpr double compressible_bulk_ratio = 20;
    if (!design.values.has(damping) || design.values.number(damping) == 0 || !design.values.has("mesh.formulation") ||
        design.values.text("mesh.formulation") != "mixed")
        return;
    const auto is_compressible = [&](const model::Material& material) {
        return material.bulk_modulus_Pa &&
               *material.bulk_modulus_Pa <
                   compressible_bulk_ratio * material::initial_shear_modulus_Pa(model::make_rubber(material));
    };
    if (is_compressible(design.material) ||
        std::ranges::any_of(design.materials, [&](const auto& named) { return is_compressible(named.second); }))
        warnings.push_back(
            std::string{damping} +
            ": mixed cells damp only changes of shape, but this rubber is compressible enough to change its volume too; "
            "mesh.formulation: displacement damps both");
}

constexpr double standard_gravity_m_s2 = 9.80665;
constexpr double max_gravities = 50.0;  // more is plausible only for a centrifuge or a shaker
// From foamed silicone to metal-filled rubber.
constexpr double min_density_kg_m3 = 100.0, max_density_kg_m3 = 5000.0;
/// Fibre angles of 0 to 1.57 deg from the axis are not used in practice; such numbers are probably angles up to 90 deg in radians.
constexpr double max_mistaken_rad = std::numbers::pi / 2;

void check_gravity(const Design& design, std::vector<std::string>& warnings) {
    for (const Design::DeadLoadRequest& load : design.dead_loads) {
        if (load.kind != model::DeadLoadKind::gravity) continue;
        const std::string path = "loads." + load.name + ".acceleration: ",
                          size = core::quantity_text(load.size_SI, core::Dimension::acceleration);
        if (std::abs(load.size_SI) > max_gravities * standard_gravity_m_s2)
            warnings.push_back(path + size + " is " +
                               core::rounded_text(std::abs(load.size_SI) / standard_gravity_m_s2, 3) +
                               " times gravity; is the unit right (9.81 m/s^2)?");
        if (load.size_SI < 0)
            warnings.push_back(path + size + " along " + load.along +
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

/// Values of the right dimension but probably of a wrong unit or sign: gravity, density, fibre angles.
void check_units(const Design& design, std::vector<std::string>& warnings) {
    check_gravity(design, warnings);
    check_density(design.material, warnings);
    for (const auto& [name, material] : design.materials) check_density(material, warnings);
    check_angles(design.values, warnings);
}

}  // namespace

std::string first_order_simplex_warning() {
    return "first-order triangles and tetrahedra lock (" + too_stiff(LockingChoice::first_order_simplices) +
           "); order: 2 with formulation: mixed does not";
}

std::vector<std::string> plausibility(const Design& design) {
    std::vector<std::string> warnings;
    const double mu_Pa = material::initial_shear_modulus_Pa(model::make_rubber(design.material));
    const auto check = [&](const model::Material& material) {
        const material::AnyRubber law = model::make_rubber(material);
        check_material(material, material::initial_shear_modulus_Pa(law), warnings);
        check_law(material, law, material::initial_shear_modulus_Pa(law), warnings);
    };
    check(design.material);
    for (const auto& [name, material] : design.materials) check(material);
    check_loads(design, mu_Pa, warnings);
    check_locking(design, warnings);
    check_damping(design, warnings);
    check_units(design, warnings);
    return warnings;
}

}  // namespace soft::design
