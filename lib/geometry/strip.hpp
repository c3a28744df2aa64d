#pragma once
/// A side of a body of revolution that is of another material, so that the body bends under pressure: keys geometry.strip.angle
/// and geometry.strip.material. Tested by geometry/bellows_test and geometry/fiber_tube_test.
#include <string>

#include "geometry/family.hpp"

namespace soft::geometry {

[[nodiscard]] design::Key strip_angle_key();
[[nodiscard]] design::Key strip_material_key();

/// Gives the body, once its fibres are laid, the sector of the design and its material. Made of whole cells, so that its volume
/// is exact: values.refuse(...) where its edges would not lie between cells, and for models in which it cannot be.
void add_strip_sector(Body& body, const design::Values& values);

/// What a region of the body is called within the strip: "strip" for the main one, else "fibers_strip", ...
[[nodiscard]] std::string strip_region(const std::string& region);

/// Within the strip every region is of the strip's material and keeps the fibres that the body has laid into it so far.
void add_strip_materials(Body& body, const design::Values& values);

}  // namespace soft::geometry
