#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/text.hpp"
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"
#include "mesh/mesh.hpp"
#include "model/location.hpp"

namespace soft::geometry {
namespace {

constexpr double rounding = 1e-9;  // of a direction

std::span<const ObstacleShape> shapes() {
    static const std::array all{plane_obstacle(), cylinder_obstacle(), sphere_obstacle(),
                                box_obstacle(),   profile_obstacle(),  surface_obstacle()};
    return all;
}

const ObstacleShape& shape_of(const design::Design::ObstacleRequest& request) {
    return *std::ranges::find_if(shapes(), [&](const ObstacleShape& one) { return one.keys.name == request.shape; });
}

std::string path_of(const std::string& name) { return "obstacles." + name; }

}  // namespace

std::vector<design::ObstacleKeys> obstacle_keys() {
    std::vector<design::ObstacleKeys> keys;
    for (const ObstacleShape& shape : shapes()) keys.push_back(shape.keys);
    return keys;
}

std::map<std::string, model::FacetedSurface> faceted_obstacles(const design::Design& design,
                                                               model::Kinematics kinematics, const mesh::Mesh& mesh) {
    constexpr double far = 10;  // sizes of the actuator: beyond any of its motions
    double reach_m = 0;
    for (const mesh::Point& point : mesh.points) reach_m = std::max(reach_m, std::abs(point[2]));
    std::map<std::string, model::FacetedSurface> faceted;
    for (const auto& request : design.obstacles) {
        const ObstacleShape& shape = shape_of(request);
        if (shape.storage != ObstacleStorage::faceted) continue;
        const ObstacleInput input{design.values, path_of(request.name), kinematics, mesh,
                                  reach_m + far * mesh::extent_m(mesh)};
        faceted[request.name] = std::get<model::FacetedSurface>(shape.build(input));
    }
    return faceted;
}

std::vector<model::Obstacle> make_obstacles(const design::Design& design, const model::Shape& shape,
                                            const mesh::Mesh& mesh) {
    std::vector<model::Obstacle> obstacles;
    for (const auto& request : design.obstacles) {
        const ObstacleShape& own = shape_of(request);
        model::Obstacle& obstacle = obstacles.emplace_back(model::Obstacle{request.name, {}});
        const auto friction = design.values.numbers(path_of(request.name) + ".friction");
        obstacle.friction = friction.empty() ? design.contact.friction : friction.front();
        if (own.storage == ObstacleStorage::design) {
            if (shape.obstacles.contains(request.name))
                throw Error(ExitCode::bad_input, path_of(request.name),
                            "the file contains this obstacle as an earlier version meshed it",
                            "rebuild the case with mesh-gen");
            obstacle.shape =
                own.build({design.values, path_of(request.name), shape.kinematics, mesh, 0, shape.symmetry_planes});
            continue;
        }
        const auto stored = shape.obstacles.find(request.name);
        if (stored == shape.obstacles.end())
            throw Error(ExitCode::bad_input, path_of(request.name), "the case does not contain this obstacle",
                        "rebuild the case with mesh-gen");
        obstacle.shape = stored->second;
    }
    return obstacles;
}

void refuse_overlaps(const design::Design& design, const model::Case& model, std::span<const ObstacleGap> gaps) {
    constexpr double touching = 1e-6;
    const double allowed_m = touching * mesh::extent_m(model.mesh);
    for (const ObstacleGap& gap : gaps) {
        if (gap.gap_m >= -allowed_m && !gap.wrong_side) continue;
        const auto request = std::ranges::find(design.obstacles, gap.name, &design::Design::ObstacleRequest::name);
        const std::string key = path_of(gap.name) + "." + shape_of(*request).keys.keys.front().path;
        if (gap.wrong_side)
            throw design.values.refuse(key,
                                       core::quoted(gap.name) + " is nearer to the mirror image at " +
                                           "xyz"[*gap.wrong_side] + " = 0 than to the part that is meshed",
                                       "mirror its position at this plane, or use model: solid");
        throw design.values.refuse(
            key,
            core::quoted(gap.name) + " overlaps the undeformed actuator by " + length_text(-gap.gap_m) + " at " +
                model::location_text(model.kinematics, gap.at),
            std::string{"move it away, touching is allowed"} +
                (request->shape == "plane" ? ", or turn its normal, which points to the actuator" : ""));
    }
}

std::optional<std::string> small_obstacle_warning(const model::Obstacle& obstacle, const ObstacleGap& gap) {
    const auto radius_of = [](const auto& shape) {
        if constexpr (requires { shape.side; })
            if (shape.side == model::Side::outside) return shape.radius_m;
        return std::numeric_limits<double>::infinity();
    };
    const double radius_m = std::visit(radius_of, obstacle.shape);
    if (radius_m >= gap.cell_m) return std::nullopt;
    return path_of(obstacle.name) + ": its radius of " + length_text(radius_m) +
           " is below the size of the cells that are nearest, " + length_text(gap.cell_m) +
           ", which touch it at single points and cannot follow it: forces come out too large; use cells of at "
           "most half of the radius where they touch (mesh.size)";
}

design::Key inside_key(const std::string& word) {
    return {.path = word + ".inside",
            .kind = design::Kind::flag,
            .fallback = "false",
            .meaning = "whether the actuator is inside of the " + word};
}

model::Side side_of(const design::Values& values, const std::string& path) {
    return values.text(path) == "true" ? model::Side::inside : model::Side::outside;
}

Vector3 unit_vector(const design::Values& values, const std::string& path) {
    Vector3 vector = point_of(values, path);
    for (int pass = 0; pass < 2; ++pass) {  // again after rounding
        const double length = norm(vector);
        if (!(length > 0)) throw values.refuse(path, "the direction is zero", "use a direction such as [0, 0, 1]");
        for (double& component : vector) component = std::abs(component) > rounding * length ? component / length : 0;
    }
    return vector;
}

bool is_parallel(const Vector3& direction, std::size_t component) { return std::abs(direction[component]) == 1; }

model::FacetedSurface segments_of(const std::vector<std::array<mesh::Point, 2>>& pieces) {
    model::FacetedSurface surface;
    const auto number_of = [&](const mesh::Point& point) {
        const auto number = std::ranges::find(surface.points, point) - surface.points.begin();
        if (number == std::ssize(surface.points)) surface.points.push_back(point);
        return static_cast<int>(number);
    };
    for (const auto& [start, end] : pieces) {
        const int first = number_of(start);
        surface.facets.push_back({first, number_of(end), -1});
    }
    return surface;
}

}  // namespace soft::geometry
