/// Loads and outputs that name an obstacle.
#include <algorithm>

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

model::Output contact_output(const design::Design::OutputRequest& request, const Meshed& meshed,
                             const design::Values& values) {
    model::Output output{request.name, "", {}, request.measure, "", {}, request.obstacle};
    if (request.along.empty()) return output;
    const std::string path = "outputs." + request.name + ".along";
    output.direction = direction_of({path, "", request.along}, meshed);
    for (std::size_t i = 0; i < 3 && request.measure == model::Measure::force; ++i)
        if (meshed.shape.symmetry_planes[i] && output.direction[i] != 0)
            throw values.refuse(
                path, std::string{"the force on the mirror image at "} + component_name(meshed, i) + " = 0 cancels it",
                "use another direction, or a model without this symmetry plane");
    return output;
}

}  // namespace soft::geometry
