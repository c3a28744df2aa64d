#pragma once
/// Segments the surface of a part into faces: planes, cylinders and other curved faces.
/// Tested by meshing/part_faces_test.
#include <optional>
#include <vector>

#include "meshing/named_faces.hpp"

namespace soft::meshing {

struct PartFace {
    enum class Shape { plane, cylinder, curved };
    Shape shape = Shape::curved;
    std::vector<std::size_t> facets;
    double area_m2 = 0;
    mesh::Point direction{};  ///< unit normal out of the body (plane), unit vector of the axis (cylinder)
    mesh::Point centre{};     ///< area centroid of the facets (plane, curved); on the axis in the middle (cylinder) [m]
    double radius_m = 0;      ///< of a cylinder, through the corners of its facets
    bool is_bore = false;     ///< of a cylinder: the material lies outside of it
    mesh::Point on_face{};    ///< a point on the face: the centroid of its largest facet [m]
    /// A rule that selects exactly these facets; nullopt if no rule of named_faces.hpp does.
    std::optional<FaceRule> rule;
};

/// Faces in descending order of area. A plane is a region whose points are within 1e-5 of the extent of one plane and whose area is at
/// least four times that of each such region that joins it smoothly (this excludes the facets of a cylinder). The remaining facets are
/// divided at sharp edges (sharp_rad); such a region is a cylinder if its normals are perpendicular to an axis to 1/100 and the
/// distances of its corners from the axis agree to 1/1000.
[[nodiscard]] std::vector<PartFace> part_faces(const BodySurface& surface);

}  // namespace soft::meshing
