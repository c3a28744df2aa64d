/// A box with sides parallel to x, y and z and rounded edges; in plane strain its section.
#include <algorithm>
#include <limits>

#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {
namespace {

/// Contact acts at points of the facets. An edge of this radius does not push through between them deeper than the contact distance: with a
/// spacing s its depth is s^2/8 over the radius, s = 1/11 of a facet in sections and 1/3 in solids.
double rounding_m(const mesh::Mesh& mesh) {
    constexpr double of_section = 0.25, of_solid = 0.75;
    double sum_m = 0, count = 0;
    for (const mesh::Facet& facet : mesh::boundary_facets(mesh)) {
        const auto corners = mesh::facet_corners(mesh, facet);
        for (std::size_t a = 0; a < corners.size(); ++a, ++count)
            sum_m += norm(difference(mesh.point(corners[a]), mesh.point(corners[(a + 1) % corners.size()])));
    }
    return (mesh.dimension == 3 ? of_solid : of_section) * sum_m / count;
}

ObstacleSurface build(const ObstacleInput& input) {
    const std::string path = input.path + ".box", from = path + ".from", to = path + ".to", radius = path + ".radius";
    if (input.kinematics == model::Kinematics::axisymmetric)
        throw input.values.refuse(from, "a box is not a body of revolution about x",
                                  "use plane, cylinder, sphere or profile, or model: solid");
    model::Box box{point_of(input.values, from), point_of(input.values, to), 0};
    const bool solid = input.kinematics == model::Kinematics::solid;
    double thinnest_m = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < (solid ? 3U : 2U); ++i) {
        if (!(box.low[i] < box.high[i]))
            throw input.values.refuse(to, std::string{"its "} + "xyz"[i] + " is not greater than that of from",
                                      "from is the lowest corner, to the highest");
        if (input.symmetry_planes[i] && box.low[i] <= 0 && box.high[i] >= 0) {  // with its mirror image
            box.high[i] = std::max(box.high[i], -box.low[i]);
            box.low[i] = -box.high[i];
        }
        thinnest_m = std::min(thinnest_m, box.high[i] - box.low[i]);
    }
    if (const auto stated = input.values.numbers(radius); !stated.empty()) {
        box.radius_m = stated.front();
        if (box.radius_m > 0.5 * thinnest_m)
            throw input.values.refuse(radius, "the box is thinner than twice this radius", "use a smaller radius");
    } else {
        constexpr double largest_share = 0.25;
        box.radius_m = std::min(rounding_m(input.mesh), largest_share * thinnest_m);
    }
    if (!solid) {
        box.low[2] = -std::numeric_limits<double>::infinity();
        box.high[2] = std::numeric_limits<double>::infinity();
    }
    return box;
}

}  // namespace

ObstacleShape box_obstacle() {
    using design::Kind;
    design::Key radius{
        .path = "box.radius",
        .kind = Kind::length,
        .fallback = "auto",
        .meaning =
            "radius of its edges; auto: three quarters of the mean side of the actuator's facets (plane strain a "
            "quarter), at most a quarter of the box; 0 mm: sharp edges, which push through between the points at "
            "which contact acts",
        .min = 0,
        .choices = {"auto"}};
    return {{"box",
             {vector_key("box.from", Kind::length, "lowest corner: [x, y, z]; plane strain does not use z"),
              vector_key("box.to", Kind::length, "highest corner: [x, y, z]"), std::move(radius)}},
            ObstacleStorage::design,
            build};
}

}  // namespace soft::geometry
