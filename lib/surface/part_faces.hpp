#pragma once
/// The faces that a part's surface consists of, found from its facets: planes, cylinders and other curved pieces.
/// Tested by surface/part_faces_test.
#include <optional>
#include <vector>

#include "surface/named_faces.hpp"

namespace soft::surface {

struct PartFace {
    enum class Shape { plane, cylinder, curved };
    Shape shape = Shape::curved;
    std::vector<std::size_t> facets;
    double area_m2 = 0;
    mesh::Point direction{};  ///< unit normal out of the body (plane), unit vector of the axis (cylinder)
    mesh::Point centre{};     ///< area centroid of the facets (plane, curved); on the axis in the middle (cylinder) [m]
    double radius_m = 0;      ///< of a cylinder, through the corners of its facets
    bool is_bore = false;     ///< of a cylinder: the body lies outside of it
    mesh::Point on_face{};    ///< a point on the face: the middle of its largest facet [m]
    /// Selects exactly these facets; nullopt where no rule of named_faces.hpp does.
    std::optional<FaceRule> rule;
};

/// Ordered by area, the largest first. Planes are regions whose points are within 1e-5 of the extent of one plane and that are larger than
/// four times each such region joined to them smoothly (facets of a cylinder are not). What remains is divided at sharp edges
/// (sharp_rad); it is a cylinder if its normals and the distance of its corners from an axis agree to 1/1000.
[[nodiscard]] std::vector<PartFace> part_faces(const BodySurface& surface);

}  // namespace soft::surface
