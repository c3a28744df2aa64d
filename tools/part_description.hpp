#pragma once
/// What a part's surface or CAD file holds, as the beginning of a design (YAML), and a picture with the numbers of its faces.
#include <string>
#include <vector>

#include "meshing/part_file.hpp"
#include "surface/part_faces.hpp"

namespace soft::cli {

struct PartDescription {
    std::string file;  ///< as the user has named it
    std::string unit;  ///< of an STL or OBJ file; empty: the file states its own
    const surface::BodySurface& surface;
    std::vector<surface::PartFace> faces;
};

/// Box, volume and closed cavities as comments; `family: imported` with a rule for each face that one rule selects.
[[nodiscard]] std::string description_yaml(const PartDescription& part);

/// Two opposite views, faces numbered as in the design; numbers of faces behind others have a dashed circle.
[[nodiscard]] std::string numbered_faces_svg(const PartDescription& part);

/// Whether the lengths may be in another unit; empty where they look right.
[[nodiscard]] std::string unit_warning(const PartDescription& part);

}  // namespace soft::cli
