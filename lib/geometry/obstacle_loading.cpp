/// Loads and outputs that name an obstacle.
#include <algorithm>
#include <cmath>

#include "contact/signed_distance.hpp"
#include "geometry/loading.hpp"

namespace soft::geometry {

bool is_obstacle(const model::Case& result, const std::string& name) {
    return std::ranges::find(result.obstacles, name, &model::Obstacle::name) != result.obstacles.end();
}

model::Motion obstacle_motion(const design::Design::MotionRequest& request, const Meshed& meshed) {
    const Vector3 d = direction_of({"loads." + request.face + ".along", "", request.along}, meshed);
    const double size_m = request.displacement_m;
    return {request.face, {size_m * d[0], size_m * d[1], size_m * d[2]}, request.time_function};
}

namespace {

/// Whether an obstacle is its own mirror image at the plane x, y or z = 0, as far as the body notices.
bool is_own_image(const model::Obstacle& obstacle, const mesh::Mesh& mesh, std::size_t plane) {
    constexpr double asymmetry = 1e-3;  // of the facets of a symmetric obstacle
    const contact::SignedDistance distance = contact::signed_distance(obstacle);
    return std::ranges::all_of(mesh.points, [&, allowed_m = asymmetry * mesh::extent_m(mesh)](mesh::Point point) {
        const double here_m = distance(point);
        point[plane] = -point[plane];
        return std::abs(distance(point) - here_m) <= allowed_m;
    });
}

}  // namespace

model::Output contact_output(const design::Design::OutputRequest& request, const Meshed& meshed,
                             const model::Case& result, const design::Values& values) {
    model::Output output{request.name, "", {}, request.measure, "", {}, request.obstacle};
    if (request.along.empty()) return output;
    const std::string path = "outputs." + request.name + ".along";
    output.direction = direction_of({path, "", request.along}, meshed);
    const auto obstacle = std::ranges::find(result.obstacles, request.obstacle, &model::Obstacle::name);
    for (std::size_t i = 0; i < 3 && request.measure == model::Measure::force; ++i) {
        if (!meshed.shape.symmetry_planes[i] || output.direction[i] == 0) continue;
        if (obstacle == result.obstacles.end() || is_own_image(*obstacle, meshed.mesh, i))
            throw values.refuse(
                path, std::string{"the force on the mirror image at "} + component_name(meshed, i) + " = 0 cancels it",
                "use another direction, or a model without this symmetry plane");
    }
    return output;
}

}  // namespace soft::geometry
