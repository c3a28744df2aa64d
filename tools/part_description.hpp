#pragma once
/// Description of a surface or CAD file as the beginning of a design (YAML), and a picture of its numbered faces.
#include <string>
#include <vector>

#include "meshing/part_faces.hpp"
#include "meshing/part_file.hpp"

namespace soft::cli {

struct PartDescription {
    std::string file;  ///< as given by the user
    std::string unit;  ///< length unit of an STL or OBJ file; empty: the file states its unit
    const meshing::BodySurface& surface;
    std::vector<meshing::PartFace> faces;
};

/// Bounding box, volume and closed cavities as comments; `family: imported` with a rule for each face that a single rule can select.
[[nodiscard]] std::string description_yaml(const PartDescription& part);

/// SVG with two opposite views; faces are numbered as in the design. Numbers of hidden faces have a dashed circle.
[[nodiscard]] std::string numbered_faces_svg(const PartDescription& part);

/// Warning that the lengths may be in another unit; empty if they are plausible.
[[nodiscard]] std::string unit_warning(const PartDescription& part);

}  // namespace soft::cli
