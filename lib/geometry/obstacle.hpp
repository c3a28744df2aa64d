#pragma once
/// Rigid obstacles of a design. Each shape is one file (obstacle_plane.cpp ... obstacle_surface.cpp), which declares its keys and
/// builds the obstacle from their values; a new shape needs one file and one line of obstacles.cpp.
///
/// A design states positions in x, y, z, where x is the axis of revolution. A section accepts the obstacles that it can represent, and
/// a shape throws values.refuse(...) for the others:
///     axisymmetric   bodies of revolution about x: a plane across x, a cylinder about x, a sphere on x, a profile revolved about x
///     plane strain   bodies that extend along z: a plane or a cylinder along z, a profile, a box (its z is unused)
/// Tested by geometry/obstacle_test.
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "model/case.hpp"
#include "model/shape.hpp"

namespace soft::geometry {

struct ObstacleInput {
    const design::Values& values;
    std::string path;  ///< "obstacles.table"
    model::Kinematics kinematics;
    const mesh::Mesh& mesh;                 ///< of the actuator
    double far_m = 0;                       ///< of a solid: profiles are extruded from z = -far_m to far_m
    std::array<bool, 3> symmetry_planes{};  ///< x, y, z = 0 of the model, where known
};
using ObstacleSurface = decltype(model::Obstacle::shape);

/// Faceted: the case file contains the obstacle (model::Shape::obstacles), as programs that read it do not read the file of a surface.
enum class ObstacleStorage { design, faceted };

struct ObstacleShape {
    design::ObstacleKeys keys;
    ObstacleStorage storage;
    ObstacleSurface (*build)(const ObstacleInput& input);  ///< faceted: a model::FacetedSurface
};

[[nodiscard]] ObstacleShape plane_obstacle();
[[nodiscard]] ObstacleShape cylinder_obstacle();
[[nodiscard]] ObstacleShape sphere_obstacle();
[[nodiscard]] ObstacleShape box_obstacle();
[[nodiscard]] ObstacleShape profile_obstacle();
[[nodiscard]] ObstacleShape surface_obstacle();

/// The keys of all shapes, for FamilyKeys::obstacles.
[[nodiscard]] std::vector<design::ObstacleKeys> obstacle_keys();

/// The faceted obstacles of the design, by name; `mesh` is that of the actuator.
[[nodiscard]] std::map<std::string, model::FacetedSurface> faceted_obstacles(const design::Design& design,
                                                                             model::Kinematics kinematics,
                                                                             const mesh::Mesh& mesh);

/// All obstacles of the design. Throws Error (bad_input) if `shape` lacks a faceted one.
[[nodiscard]] std::vector<model::Obstacle> make_obstacles(const design::Design& design, const model::Shape& shape,
                                                          const mesh::Mesh& mesh);

/// Where the undeformed actuator is nearest to an obstacle, or overlaps it most.
struct ObstacleGap {
    std::string name;
    double gap_m = 0;   ///< negative: depth of the overlap
    mesh::Point at{};   ///< on the actuator
    double cell_m = 0;  ///< longest side of the facet there; where the obstacle is a cylinder, across its axis
    /// The symmetry plane (x, y, z = 0) whose mirror image of the obstacle is nearer to some of the mesh than the obstacle.
    std::optional<std::size_t> wrong_side = {};
};
/// The gaps of all obstacles. It compares the nodes and the quadrature points of the free facets with the obstacle, and vertices and
/// edges of the obstacle, its centre or its axis with the closest point of the curved facets. Between these points an overlap that is
/// small compared with the facets may remain undetected.
[[nodiscard]] std::vector<ObstacleGap> obstacle_gaps(const model::Case& model);

/// Throws values.refuse(...) with position and depth for an obstacle that overlaps the undeformed actuator deeper than 1e-6 of its size,
/// and for one on the wrong side of a symmetry plane: contact with its mirror image would be missed.
void refuse_overlaps(const design::Design& design, const model::Case& model, std::span<const ObstacleGap> gaps);

/// For a sphere or a cylinder with a radius below the size of the cells that are nearest to it: the surface of the actuator cannot follow
/// it, and single points touch it.
[[nodiscard]] std::optional<std::string> small_obstacle_warning(const model::Obstacle& obstacle,
                                                                const ObstacleGap& gap);

/// For the shapes: the key `inside` of `word`, and the side of the actuator that it states.
[[nodiscard]] design::Key inside_key(const std::string& word);
[[nodiscard]] model::Side side_of(const design::Values& values, const std::string& path);
/// A vector of length 1; components below 1e-9 are rounding errors and become 0.
[[nodiscard]] Vector3 unit_vector(const design::Values& values, const std::string& path);
/// Whether a unit vector is parallel to a coordinate direction.
[[nodiscard]] bool is_parallel(const Vector3& direction, std::size_t component);
/// Polygons with the obstacle on their left -> segments whose normals point to the actuator.
[[nodiscard]] model::FacetedSurface segments_of(const std::vector<std::array<mesh::Point, 2>>& pieces);

}  // namespace soft::geometry
