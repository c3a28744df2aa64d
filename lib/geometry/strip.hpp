#pragma once
/// A strip of another material along one side of a body of revolution, so that the body bends under pressure: keys
/// geometry.strip.angle and geometry.strip.material. Tested by geometry/bellows_test and geometry/fiber_tube_test.
#include <string>
#include <vector>

#include "geometry/family.hpp"

namespace soft::geometry {

[[nodiscard]] design::Key strip_angle_key();
[[nodiscard]] design::Key strip_material_key();
/// Adds what a strip changes to the meaning of mesh.sectors.
void describe_strip_sectors(std::vector<design::Key>& mesh_keys);

/// Adds the sector of the strip and its material to the body. Call it after the fibres are added. The sector consists of whole
/// cells (cell_size.hpp). Throws values.refuse(...) for angles whose cells would be too thin, and for models that cannot contain it.
void add_strip_sector(Body& body, const design::Values& values);

/// Name of a region of the body within the strip: "strip" for the main region, else "fibers_strip", ...
[[nodiscard]] std::string strip_region(const std::string& region);

/// Assigns the material of the strip to every region within it. The regions keep the fibres that the body has so far.
void add_strip_materials(Body& body, const design::Values& values);

}  // namespace soft::geometry
