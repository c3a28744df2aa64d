#include "geometry/loading.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "math/vector.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/locate.hpp"
#include "model/face_symmetry.hpp"
#include "model/facet_integrals.hpp"

namespace soft::geometry {
namespace {

/// Area mean of the outward unit normal of a face; shorter than 1 where the face is not flat.
Vector3 mean_normal(const Meshed& meshed, const std::string& face) {
    Vector3 sum{};
    double area = 0;
    for (const mesh::Facet& facet : meshed.mesh.facet_sets.at(face)) {
        const mesh::CellType type = facet_type(meshed.mesh, facet);
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(type)) {
            const auto n = mesh::facet_normal(meshed.mesh, facet, mesh::shape_values(type, point.xi));
            for (std::size_t i = 0; i < 3; ++i) sum[i] += point.weight * n[i];
            area += point.weight * std::hypot(n[0], n[1], n[2]);
        }
    }
    for (double& component : sum) component /= area;
    return sum;
}

/// Whether the load needs the volume of a cavity.
bool has_gas(const design::Design& design, std::size_t load) {
    return design.loads[load].targets.size() > 1 || design.loads[load].line ||
           std::ranges::any_of(design.path.stages, [&](const model::Stage& stage) {
               return stage.supplies.at(load).what != model::Prescription::pressure;
           });
}

void add_pressures(model::Case& result, const design::Design& design, const Meshed& meshed) {
    result.loads = design.loads;
    for (std::size_t i = 0; i < result.loads.size(); ++i)
        for (const std::string& target : result.loads[i].targets) {
            if (std::ranges::find(result.cavities, target, &model::Cavity::name) != result.cavities.end()) continue;
            require_face(meshed, target, "loads." + target);
            if (has_gas(design, i))
                throw Error(ExitCode::bad_input, "loads." + target, "is no cavity of this model, and has no volume",
                            "prescribe its pressure, or rebuild the case with mesh-gen");
        }
}

/// Throws for a direction in which a symmetry plane would mirror the weight or nothing carries it.
void check_weight(const std::string& path, const Vector3& direction, const Meshed& meshed,
                  const design::Values& values) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (direction[i] == 0) continue;
        if (meshed.shape.symmetry_planes[i])
            throw values.refuse(path,
                                std::string{"the symmetry plane "} + component_name(meshed, i) +
                                    " = 0 of the model would mirror the weight",
                                "use a model without this plane, or another direction");
        if (std::ranges::find(meshed.shape.supports, middle_faces[i], &model::Support::face) !=
            meshed.shape.supports.end())
            throw values.refuse(path, "no support carries the weight of the body", "remove gravity");
    }
}

model::FaceSymmetry symmetry_of(const Meshed& meshed, const std::string& face) {
    return model::face_symmetry(meshed.mesh, {meshed.shape.kinematics, meshed.shape.symmetry_planes}, face);
}

/// Undeformed area of the whole face of the whole actuator. Throws for a direction that a symmetry plane would mirror.
double whole_area_m2(const Meshed& meshed, const DirectionRequest& request, const Vector3& direction,
                     const design::Values& values) {
    const model::FaceSymmetry symmetry = symmetry_of(meshed, request.face);
    if (model::uncancelled_force(symmetry, direction) != direction)
        throw values.refuse(request.key, "a symmetry plane of the model would mirror the force",
                            "use a model without this plane, or another direction");
    return symmetry.copies * model::face_weights(meshed.mesh, meshed.shape.kinematics, request.face).area_m2;
}

void add_dead_loads(model::Case& result, const design::Design& design, const Meshed& meshed) {
    for (const auto& request : design.dead_loads) {
        const std::string location = "loads." + request.name;
        const bool against = request.along.starts_with('-');
        const DirectionRequest along{location + ".along", request.name, request.along.substr(against ? 1 : 0)};
        if (request.kind != model::DeadLoadKind::gravity) require_face(meshed, request.name, location);
        model::DeadLoad load{request.name, request.kind, direction_of(along, meshed), request.time_function};
        double size_SI = against ? -request.size_SI : request.size_SI;
        if (request.size_SI < 0) load.sign = -1;
        switch (request.kind) {
            case model::DeadLoadKind::traction: break;
            case model::DeadLoadKind::force:
                load.area_m2 = whole_area_m2(meshed, along, load.vector_SI, design.values);
                size_SI /= load.area_m2;
                break;
            case model::DeadLoadKind::gravity: check_weight(along.key, load.vector_SI, meshed, design.values); break;
        }
        for (double& component : load.vector_SI) component *= size_SI;
        result.dead_loads.push_back(std::move(load));
    }
}

/// The coordinate axis parallel to `direction`, or 3 if there is none.
std::size_t component_along(const Vector3& direction) {
    constexpr double rounding = 1e-9;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(std::abs(direction[i]) - 1) <= rounding) return i;
    return 3;
}

void add_motions(model::Case& result, const design::Design& design, const Meshed& meshed) {
    for (const auto& request : design.motions) {
        const std::string location = "loads." + request.face, path = location + ".along";
        if (is_obstacle(result, request.face)) {
            result.motions.push_back(obstacle_motion(request, meshed));
            continue;
        }
        require_face(meshed, request.face, location);
        const Vector3 direction = direction_of({path, request.face, request.along}, meshed);
        const std::size_t component = component_along(direction);
        if (component == 3)
            throw design.values.refuse(path, "a motion must follow a coordinate axis, and this direction does not",
                                       "rotate the part, or use x, y or z");
        model::Motion motion{request.face, {}};
        motion.displacement_m[component] = direction[component] < 0 ? -request.displacement_m : request.displacement_m;
        result.motions.push_back(std::move(motion));
    }
}

std::set<mesh::Index> nodes_of(const Meshed& meshed, const std::string& face) {
    std::set<mesh::Index> nodes;
    for (const mesh::Facet& facet : meshed.mesh.facet_sets.at(face))
        for (const mesh::Index node : mesh::facet_nodes(meshed.mesh, facet)) nodes.insert(node);
    return nodes;
}

bool share_a_node(const Meshed& meshed, const std::string& one, const std::string& other) {
    const std::set<mesh::Index> nodes = nodes_of(meshed, one), others = nodes_of(meshed, other);
    return std::ranges::any_of(others, [&](mesh::Index node) { return nodes.contains(node); });
}

/// Throws if a support or another motion also prescribes a component of a motion at a node.
void check_constraints(const model::Case& result, const design::Design& design, const Meshed& meshed) {
    const auto refuse = [&](const model::Motion& motion, std::size_t component, const std::string& other) {
        throw design.values.refuse(
            "loads." + motion.face + ".displacement",
            std::string{"over-constrained in "} + component_name(meshed, component) + ": " + other +
                (other.ends_with(core::quoted(motion.face)) ? ""
                                                            : ", which shares nodes with " + core::quoted(motion.face)),
            "keep one of the two");
    };
    for (std::size_t m = 0; m < result.motions.size(); ++m) {
        const model::Motion& motion = result.motions[m];
        if (is_obstacle(result, motion.face)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            if (!motion.displacement_m[i]) continue;
            for (const model::Support& support : result.supports)
                if (support.fixed[i] && share_a_node(meshed, motion.face, support.face))
                    refuse(motion, i, "a support fixes " + core::quoted(support.face));
            for (std::size_t k = 0; k < m; ++k) {
                const model::Motion& other = result.motions[k];
                if (!is_obstacle(result, other.face) && other.displacement_m[i] &&
                    *other.displacement_m[i] != *motion.displacement_m[i] &&
                    share_a_node(meshed, motion.face, other.face))
                    refuse(motion, i, "another motion moves " + core::quoted(other.face));
            }
        }
    }
}

bool share_a_facet(const Meshed& meshed, const std::string& one, const std::string& other) {
    const auto &facets = meshed.mesh.facet_sets.at(one), &others = meshed.mesh.facet_sets.at(other);
    const std::set<mesh::Facet> all(facets.begin(), facets.end());
    return std::ranges::any_of(others, [&](const mesh::Facet& facet) { return all.contains(facet); });
}

/// Throws values.refuse(...) with the nearest node for a point outside the mesh.
Vector3 point_of_part(const design::Design::OutputRequest& request, const Meshed& meshed,
                      const design::Values& values) {
    Vector3 point{};
    std::ranges::copy(request.point_m, point.begin());
    if (mesh::locate(meshed.mesh, point)) return point;
    const Vector3& nearest = meshed.mesh.point(mesh::nearest_node(meshed.mesh, point));
    std::string text;
    for (std::size_t i = 0; i < request.point_m.size(); ++i)
        text += (i > 0 ? ", " : "[") + core::rounded_text(1e3 * nearest[i], 6) + " mm";
    throw values.refuse("outputs." + request.name + ".point", "the point lies outside the mesh",
                        "use a point inside, the nearest node is " + text + "]");
}

/// A reaction needs a support or a motion of the face, and a direction in which its mirror images do not cancel.
void check_reaction(const model::Case& result, const design::Design::OutputRequest& request, const Vector3& direction,
                    const Meshed& meshed, const design::Values& values) {
    const std::string location = "outputs." + request.name;
    const bool force = request.measure == model::Measure::force;
    const model::FaceSymmetry symmetry = symmetry_of(meshed, request.face);
    const Vector3 left =
        force ? model::uncancelled_force(symmetry, direction) : model::uncancelled_moment(symmetry, direction);
    if (left == Vector3{})
        throw values.refuse(
            location + ".along",
            std::string{force ? "the force" : "the moment"} + " is 0, because the mirror image of the face cancels it",
            "use another direction");
    const auto is_constrained = [&](std::size_t i) {
        const auto at_face = [&](const std::string& face) { return share_a_facet(meshed, request.face, face); };
        return std::ranges::any_of(result.supports, [&](const auto& s) { return s.fixed[i] && at_face(s.face); }) ||
               std::ranges::any_of(result.motions, [&](const auto& m) {
                   return !is_obstacle(result, m.face) && m.displacement_m[i] && at_face(m.face);
               });
    };
    bool any = false;
    for (std::size_t i = 0; i < 3; ++i) any = any || ((!force || left[i] != 0) && is_constrained(i));
    if (!any)
        throw values.refuse(location + ".face",
                            core::quoted(request.face) +
                                " is not constrained in this direction, so there is no reaction " +
                                std::string{model::name_of(request.measure)},
                            "fix it under supports, or prescribe a displacement under loads");
}

}  // namespace

Vector3 direction_of(const DirectionRequest& request, const Meshed& meshed) {
    const std::string& along = request.along;
    if (along == "axis") return meshed.shape.axis;
    if (along == "x") return {1, 0, 0};
    if (along == "normal") {
        constexpr double flat = 1 - 1e-9;  // rounding of the sums; a curved face falls far below
        const auto n = mean_normal(meshed, request.face);
        if (!(std::hypot(n[0], n[1], n[2]) >= flat))  // also of a face without area
            throw Error(ExitCode::bad_input, request.key, "face " + core::quoted(request.face) + " is not flat",
                        "use axis, x, y or z");
        return n;
    }
    // The mean of y or z over a full turn has no meaning for a section, and r is not a fixed direction of a solid.
    const bool revolved = meshed.shape.kinematics == model::Kinematics::axisymmetric;
    const bool plane = meshed.shape.kinematics == model::Kinematics::plane_strain;
    if (along == "r" && revolved) return {0, 1, 0};
    if (along == "y" && !revolved) return {0, 1, 0};
    if (along == "z" && !revolved && !plane) return {0, 0, 1};
    throw Error(ExitCode::bad_input, request.key, core::quoted(along) + " is not a direction of this model",
                revolved ? "use axis, x, r or normal"
                : plane  ? "use axis, x, y or normal"
                         : "use axis, x, y, z or normal");
}

const char* component_name(const Meshed& meshed, std::size_t component) {
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    return component == 1 && meshed.shape.kinematics == model::Kinematics::axisymmetric ? "r" : names[component];
}

void require_face(const Meshed& meshed, const std::string& face, const std::string& location) {
    const auto& sets = meshed.mesh.facet_sets;
    const auto found = sets.find(face);
    if (found != sets.end() && !found->second.empty()) return;
    std::vector<std::string> present;
    for (const std::string& name : meshed.keys.faces)
        if (sets.contains(name)) present.push_back(name);
    throw Error(ExitCode::bad_input, location,
                found == sets.end() ? "this model has no face " + core::quoted(face)
                                    : "the face " + core::quoted(face) + " is empty",
                "available faces: " + core::join(present));
}

void add_loads(model::Case& result, const design::Design& design, const Meshed& meshed) {
    add_pressures(result, design, meshed);
    add_dead_loads(result, design, meshed);
    add_motions(result, design, meshed);
    check_constraints(result, design, meshed);
}

void add_outputs(model::Case& result, const design::Design& design, const Meshed& meshed) {
    for (const auto& request : design.outputs) {
        const std::string location = "outputs." + request.name;
        if (!request.obstacle.empty()) {
            result.outputs.push_back(contact_output(request, meshed, result, design.values));
            continue;
        }
        if (!request.point_m.empty()) {
            const Vector3 along = direction_of({location + ".along", "", request.along}, meshed);
            result.outputs.push_back(
                {request.name, "", along, request.measure, "", point_of_part(request, meshed, design.values)});
            continue;
        }
        require_face(meshed, request.face, location + ".face");
        const bool bend = request.measure == model::Measure::bend;
        if (bend) require_face(meshed, request.reference, location + ".reference");
        const bool about_z = (model::is_angle(request.measure) || request.measure == model::Measure::moment) &&
                             request.along == "z" && meshed.shape.kinematics == model::Kinematics::plane_strain;
        const Vector3 direction =
            about_z ? Vector3{0, 0, 1} : direction_of({location + ".along", request.face, request.along}, meshed);
        if (model::is_reaction(request.measure)) check_reaction(result, request, direction, meshed, design.values);
        result.outputs.push_back(
            {request.name, request.face, direction, request.measure, bend ? request.reference : "", {}});
    }
}

}  // namespace soft::geometry
