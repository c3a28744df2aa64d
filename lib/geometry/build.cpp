#include "geometry/build.hpp"

#include <algorithm>
#include <set>

#include "core/text.hpp"
#include "geometry/case_warnings.hpp"
#include "geometry/loading.hpp"
#include "model/formulation.hpp"
#include "model/rubber.hpp"

namespace soft::geometry {
namespace {

model::Formulation formulation_of(const design::Values& values, const mesh::Mesh& mesh) {
    const std::string word = values.has("mesh.formulation") ? values.text("mesh.formulation") : "mixed";
    model::Formulation formulation = model::Formulation::mixed;
    if (word == "displacement") formulation = model::Formulation::displacement;
    if (word == "f-bar") formulation = model::Formulation::f_bar;
    for (const mesh::CellType type : std::set(mesh.cell_types.begin(), mesh.cell_types.end()))
        if (const std::string reason = model::explain_incompatibility(type, formulation); !reason.empty())
            throw values.refuse("mesh.formulation", reason);
    return formulation;
}

/// The material of every region: the one that the family assigns, else the one of the region's name, else the main one. Includes
/// the fibres that the family adds to the region.
std::vector<model::Material> region_materials(const design::Design& design, const Meshed& meshed) {
    std::vector<model::Material> materials;
    for (const std::string& region : meshed.mesh.region_names) {
        const auto named = meshed.shape.region_materials.find(region);
        const auto found = design.materials.find(named == meshed.shape.region_materials.end() ? region : named->second);
        materials.push_back(found == design.materials.end() ? design.material : found->second);
        materials.back().name = region;
        if (const auto fibers = meshed.shape.region_fibers.find(region); fibers != meshed.shape.region_fibers.end()) {
            materials.back().fibers = fibers->second.fibers;
            materials.back().fiber_frame = fibers->second.frame;
        }
    }
    return materials;
}

/// Throws if the law of the rubber cannot be combined with fibres; the keys of the family check the fibres themselves.
void check_fibers(const design::Design& design, const model::Material& material) {
    try {
        static_cast<void>(model::make_rubber(material));
    } catch (const Error& error) {
        throw design.values.refuse(material.source + ".law", error.what());
    }
}

/// A material that no region uses is most likely misspelt. Built-in materials of a family may stay unused.
void check_materials(const design::Design& design, const Meshed& meshed,
                     const std::vector<model::Material>& materials) {
    for (const model::Material& material : materials) {
        if (material.fibers) check_fibers(design, material);
        const std::string reason =
            model::explain_incompatibility(material, meshed.shape.kinematics, meshed.shape.symmetry_planes);
        if (!reason.empty())
            throw design.values.refuse(
                (material.fibers ? "geometry.fibers" : material.source) + std::string{".families"}, reason);
    }
    for (const auto& [name, material] : design.materials) {
        const bool used = std::ranges::find(materials, material.source, &model::Material::source) != materials.end();
        if (!used && !meshed.keys.materials.contains(name))
            throw design.values.refuse(material.source + ".law", "no region uses this material",
                                       "regions: " + core::join(meshed.mesh.region_names));
    }
}

/// A case file of another program may combine a design with a mesh of another kind.
void check_kinematics(const design::Design& design, const model::Shape& shape) {
    const Model model = model_of(design.values);
    const auto needed = model == Model::axisymmetric   ? model::Kinematics::axisymmetric
                        : model == Model::plane_strain ? model::Kinematics::plane_strain
                                                       : model::Kinematics::solid;
    if (shape.kinematics != needed)
        throw design.values.refuse("model", "the mesh of the case is of another kind",
                                   "rebuild the case with mesh-gen");
}

}  // namespace

std::vector<std::string> warnings_of(const design::Design& design, const Built& built) {
    std::vector<std::string> warnings = design.warnings;
    warnings.insert(warnings.end(), built.mesh_warnings.begin(), built.mesh_warnings.end());
    const auto locks = [](mesh::CellType type) {
        return type == mesh::CellType::triangle3 || type == mesh::CellType::tet4;
    };
    const bool is_reported = design.values.has("mesh.cells") && design.values.text("mesh.cells") == "simplices";
    if (!is_reported && std::ranges::any_of(built.model.mesh.cell_types, locks))
        warnings.push_back((design.values.has("geometry.file") ? "geometry.file: " : "mesh.order: ") +
                           design::first_order_simplex_warning());
    for (std::string& warning : case_warnings(design, built.model)) warnings.push_back(std::move(warning));
    for (std::size_t k = 0; k < built.gaps.size(); ++k)
        if (auto warning = small_obstacle_warning(built.model.obstacles[k], built.gaps[k]))
            warnings.push_back(std::move(*warning));
    return warnings;
}

model::Case build_case(const design::Design& design, mesh::Mesh mesh, const model::Shape& shape) {
    const Meshed meshed{family_of(design.family).keys, mesh, shape};
    check_kinematics(design, shape);
    for (const model::Support& support : design.supports) require_face(meshed, support.face, "supports");

    model::Case result;
    result.name = design.name;
    result.kinematics = shape.kinematics;
    result.formulation = formulation_of(design.values, mesh);
    result.model_fraction = shape.model_fraction;
    result.symmetry_planes = shape.symmetry_planes;
    result.materials = region_materials(design, meshed);
    check_materials(design, meshed, result.materials);
    result.supports = design.supports;
    result.supports.insert(result.supports.end(), shape.supports.begin(), shape.supports.end());
    result.cavities = shape.cavities;
    result.obstacles = make_obstacles(design, shape, mesh);
    result.contact = design.contact;
    add_loads(result, design, meshed);
    add_outputs(result, design, meshed);
    result.path = design.path;
    result.solver = design.solver;
    result.dynamics = design.dynamics;
    if (result.dynamics && result.dynamics->integrator == model::Integrator::rosenbrock) {
        const auto refuse = [&](const std::string& what, const std::string& or_else) {
            throw design.values.refuse("dynamics.integrator", "rosenbrock solves linear equations, and " + what,
                                       "use another implicit integrator" + or_else);
        };
        if (model::has_friction(result))
            refuse("friction that slides is not linear", ", or set contact.friction and that of the obstacles to 0");
        if (!result.motions.empty()) refuse("one solution per stage does not follow an obstacle that moves", "");
    }
    result.mesh = std::move(mesh);
    return result;
}

Built build_with_figures(const design::Design& design) {
    MeshedShape made = make_shape(design);
    model::Case model = build_case(design, std::move(made.mesh), made.shape);
    std::vector<ObstacleGap> gaps = obstacle_gaps(model);
    refuse_overlaps(design, model, gaps);
    return {std::move(model),      std::move(made.shape),    std::move(made.part),
            std::move(made.notes), std::move(made.warnings), std::move(gaps)};
}

model::Case build_case(const design::Design& design) { return build_with_figures(design).model; }

design::Design read_built_design(const mesh::Mesh& mesh, const model::Shape& shape, std::string_view effective_yaml,
                                 std::string_view source, std::span<const design::Override> overrides) {
    design::FileFaces faces;
    for (const auto& [name, facets] : mesh.facet_sets) faces.faces.push_back(name);
    for (const model::Cavity& cavity : shape.cavities) faces.cavities.push_back(cavity.name);
    return design::read_built_design(effective_yaml, source, catalogue_keys(), overrides, faces);
}

mesh::Measure measure_of(const model::Case& model) {
    return model.kinematics == model::Kinematics::axisymmetric ? mesh::Measure::revolved : mesh::Measure::plain;
}

model::Case rebuild_case(mesh::Mesh mesh, const model::Shape& shape, std::string_view effective_yaml,
                         std::string_view source) {
    const design::Design design = read_built_design(mesh, shape, effective_yaml, source, {});
    return build_case(design, std::move(mesh), shape);
}

}  // namespace soft::geometry
