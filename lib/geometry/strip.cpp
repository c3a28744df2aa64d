#include "geometry/strip.hpp"

#include <numbers>

#include "core/text.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

constexpr const char *angle_key = "geometry.strip.angle", *material_key = "geometry.strip.material",
                     *strip_name = "strip";

/// Of half the strip, and of the rest of its quarter turn.
constexpr double least_part_deg = 1;

}  // namespace

design::Key strip_angle_key() {
    return {.path = angle_key,
            .kind = design::Kind::angle,
            .fallback = "0 deg",
            .meaning = "angle of the sector about z < 0 that has another material, so that the body bends; 0 = none",
            .min = 0,
            .max = std::numbers::pi};
}

design::Key strip_material_key() {
    return {.path = material_key,
            .kind = design::Kind::text,
            .fallback = std::string{design::main_region},
            .meaning = "name of the strip material below materials; rubber = the main material"};
}

void describe_strip_sectors(std::vector<design::Key>& mesh_keys) {
    for (design::Key& key : mesh_keys)
        if (key.path == "mesh.sectors")
            key.meaning += "; beside and in a strip no larger than these, auto: 29 degrees (fine 10)";
}

std::string strip_region(const std::string& region) {
    return region == design::main_region ? std::string{strip_name} : region + "_" + strip_name;
}

void add_strip_materials(Body& body, const design::Values& values) {
    body.region_materials[strip_region(std::string{design::main_region})] = values.text(material_key);
    const auto wound = body.region_fibers;  // a copy, because the loop adds entries
    for (const auto& [region, fibers] : wound) {
        body.region_materials[strip_region(region)] = values.text(material_key);
        body.region_fibers[strip_region(region)] = fibers;
    }
}

void add_strip_sector(Body& body, const design::Values& values) {
    const double angle_rad = values.number(angle_key);
    if (angle_rad == 0) return;
    if (const Model model = model_of(values); model != Model::solid && model != Model::half)
        throw values.refuse(angle_key,
                            "model " + core::quoted(values.text("model")) + " assumes a symmetry that a strip breaks",
                            "use model: solid or half");
    const double least_rad = 2 * least_part_deg * std::numbers::pi / 180, rest_rad = std::numbers::pi - angle_rad;
    if (angle_rad < least_rad || (rest_rad > 1e-9 && rest_rad < least_rad))
        throw values.refuse(angle_key,
                            "cells of less than " + core::rounded_text(least_part_deg, 3) + " deg around the axis",
                            "use 0, 180 deg, or between " + core::rounded_text(2 * least_part_deg, 3) + " and " +
                                core::rounded_text(180 - 2 * least_part_deg, 3) + " deg");
    body.strip_rad = angle_rad;
    add_strip_materials(body, values);
}

}  // namespace soft::geometry
